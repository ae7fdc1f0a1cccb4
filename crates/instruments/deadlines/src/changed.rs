//! The pictures of two rehearsals of one frame, and the pixels in which they differ.

use generator::{PlaneKind, Planes};
use machine::{MachineStage, Prepare};
use picture::{ChangedPixels, Depth, Encoder, Transfer};
use signal::Probe;

use crate::{DeadlineError, Rehearsal};

/// Pixels of frame `frame` that `found` does not draw as `baseline` does, in levels of 8 bits; brighter is brighter by `found`.
///
/// # Errors
/// If the pictures are not of one size, or a frame cannot be drawn.
pub fn changed_pixels(
    baseline: &Rehearsal,
    found: &Rehearsal,
    frame: u64,
) -> Result<ChangedPixels, DeadlineError> {
    let [first, second] = [baseline, found].map(|rehearsal| size(&rehearsal.stage));
    if first != second {
        return Err(DeadlineError::OtherSize { baseline: first, found: second });
    }
    let both = [intensity(baseline, frame)?, intensity(found, frame)?];
    let both = both.each_ref().map(|planes| planes.get(PlaneKind::Intensity).unwrap_or_default());
    let display = found.stage.settings.display;
    let transfer = Transfer::new(display.white as f32, display.gamma as f32)?;
    Ok(ChangedPixels::between(&Encoder::new(transfer, Depth::Eight), both, second)?)
}

/// Columns and lines of the picture.
fn size(stage: &MachineStage) -> [usize; 2] {
    [stage.settings.raster.columns, stage.settings.raster.lines].map(|count| count as usize)
}

fn intensity(rehearsal: &Rehearsal, frame: u64) -> Result<Planes, DeadlineError> {
    let pose = rehearsal.poses(&[frame])?[0].pose;
    let [columns, lines] = size(&rehearsal.stage);
    let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
    let session = rehearsal.stage.clone().prepare();
    rehearsal.pool.install(|| session.frame(frame, &pose, &mut planes, &mut Probe::off()))?;
    Ok(planes)
}
