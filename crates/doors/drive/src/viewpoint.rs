//! A frame from one pose: what is asked of it.

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

    /// Draws the frame as the generator shows it.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn draw(&self) -> Result<Seen, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let draw = || drive.drawing.draw(&*bench.session, (*frame, pose), drive.file());
        let (picture, light) = drive.pool.install(draw)?;
        Ok(Seen { frame: *frame, pose: self.pose(), picture, light })
    }
}
