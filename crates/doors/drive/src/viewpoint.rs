//! A frame from one pose: what is asked of it.

use exact::View;
use quantities::degrees;
use scenario::Pose;

use crate::bench::Bench;
use crate::{Drive, DriveError, EyePose, Seen};

/// One frame of an opened scenario, from one pose: of the path, of a loop, or anywhere.
#[derive(Clone, Copy)]
pub struct Viewpoint<'a> {
    pub(crate) drive: &'a Drive,
    pub(crate) bench: &'a Bench,
    pub(crate) frame: u64,
    pub(crate) pose: Pose,
}

impl Viewpoint<'_> {
    /// Number of the frame, counted at the update rate.
    pub fn frame(&self) -> u64 {
        self.frame
    }

    /// Where the vehicle is.
    pub fn pose(&self) -> EyePose {
        EyePose::of(&self.pose, self.drive.opened.scenario.channel.as_ref())
    }

    /// Azimuth, clockwise from north, and elevation of the sun (degrees).
    pub fn sun_deg(&self) -> [f64; 2] {
        let sun = self.bench.stage.scenery.sun(self.pose.time);
        [sun.azimuth, sun.elevation].map(degrees)
    }

    /// Draws the frame as the generator shows it.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn draw(&self) -> Result<Seen, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let draw = || drive.drawing.draw(&*bench.session, (*frame, pose), drive.file());
        let (picture, light, counts) = drive.pool.install(draw)?;
        Ok(Seen { frame: *frame, pose: self.pose(), picture, light, counts })
    }

    /// Places of the ground (north, east; m) under what pixels show whose ranges are `range` (m), line by line; none where it is infinite.
    pub fn places(&self, range: &[f32]) -> Vec<Option<[f64; 2]>> {
        let Self { bench, pose, .. } = self;
        let view = &bench.stage.view;
        let (columns, lines) = (view.columns as usize, view.lines as usize);
        let eye = View::new(view.laws.projection, &pose.attitude).with_yoke(pose.yoke);
        let centre = |at: usize, of: usize| (2 * at + 1) as f64 / of as f64 - 1.0;
        let place = |(at, range): (usize, &f32)| {
            let x = view.field.tan_half_width * centre(at % columns, columns);
            let y = view.field.tan_half_height * centre(at / columns, lines);
            let [north, east] = eye.ray(x, y).direction.map(|part| part * f64::from(*range));
            range.is_finite().then(|| [pose.eye[0] + north, pose.eye[1] + east])
        };
        range.iter().enumerate().map(place).collect()
    }
}
