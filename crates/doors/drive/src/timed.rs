//! How the digital side kept its deadlines in a frame.

use generator::Timed;

use crate::{DriveError, Viewpoint};

/// Counts of one frame, as its timing record has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FrameTiming {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Folds of both ramps in all sweeps.
    pub folds: u64,
    /// Words that came after the stop they were meant for.
    pub late_words: u64,
    /// Deadlines that were not met, those of the words among them.
    pub missed: u64,
}

impl Viewpoint<'_> {
    /// Counts folds, late words and deadlines that were not met. No event is listed, so it takes a part of what their listing takes.
    ///
    /// # Errors
    /// If the hybrid machine does not draw, or the pose cannot be drawn.
    pub fn timing(&self) -> Result<FrameTiming, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        if !drive.opened.is_machine() {
            let title = format!("{} has no deadlines", drive.drawn_by());
            return Err(DriveError::asked(drive.file(), title, "a hardware model"));
        }
        let timing = drive.pool.install(|| Timed::frame_for_totals(bench.control(), *frame, pose));
        let timing = timing.map_err(|error| DriveError::of(drive.file(), &error))?;
        let missed = timing.misses.len() as u64;
        Ok(FrameTiming { frame: *frame, folds: timing.folds, late_words: timing.late_words, missed })
    }
}
