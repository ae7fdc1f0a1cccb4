//! A pixel of any generator: its own explanation, or what its planes hold there.

use generator::{Fact, Generator, Planes, Session};
use scenario::{Pose, View};
use signal::Probe;

use crate::InquiryError;

/// What `session`, which `generator` made for a stage with `view`, says of a pixel (column and line) of frame `frame` from `pose`. If
/// it says nothing of its own, the frame is drawn by the threads of the current pool, and each plane has its value at the pixel.
///
/// # Errors
/// If there is no such pixel, or the pose cannot be drawn.
pub fn facts(
    generator: &dyn Generator,
    session: &dyn Session,
    view: &View,
    (frame, pose): (u64, &Pose),
    pixel: [usize; 2],
) -> Result<Vec<Fact>, InquiryError> {
    expect_pixel(pixel, [view.columns, view.lines])?;
    let facts = session.explain(frame, pose, pixel)?;
    if !facts.is_empty() {
        return Ok(facts);
    }
    let mut planes = Planes::new(view.columns as usize, view.lines as usize, generator.planes());
    session.frame(frame, pose, &mut planes, &mut Probe::off())?;
    Ok(planes.facts(pixel))
}

/// Sees that a picture of `columns` and `lines` has the pixel.
pub(crate) fn expect_pixel([x, y]: [usize; 2], [columns, lines]: [u32; 2]) -> Result<(), InquiryError> {
    match x < columns as usize && y < lines as usize {
        true => Ok(()),
        false => Err(InquiryError::Pixel { x, y, columns, lines }),
    }
}
