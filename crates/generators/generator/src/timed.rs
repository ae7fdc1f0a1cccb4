//! Generators whose frames take time on a machine of their own.

use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{FrameTiming, Task};

use crate::FrameError;

/// A figure of a generator in time, measured and by formula.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedFigure {
    /// Key of the figure in documents, ending in its unit.
    pub key: &'static str,
    /// Meaning of the figure, in words.
    pub meaning: &'static str,
    /// Value over the measured frames.
    pub measured: Option<f64>,
    /// Value that the formula gives.
    pub formula: Option<f64>,
    /// The formula in symbols.
    pub law: &'static str,
}

/// Time of a routine that the source of a generator reports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReportedTime {
    /// Name of the routine. Its tasks have this name, or begin with it and a dot.
    pub routine: &'static str,
    /// Time (s) that the source measured.
    pub seconds: f64,
}

/// A generator on a stage, as a job that takes time.
pub trait Timed: Sync {
    /// The clock whose ticks its records count.
    fn master(&self) -> Rate;

    /// Hash of everything that decides its timing on `scenario`.
    fn inputs(&self, scenario: &Scenario) -> String;

    /// What it has to do before frame 0, whose pose is `first`.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn before_mission(&self, first: &Pose) -> Result<Vec<Task>, FrameError>;

    /// What frame `frame` from `pose` takes.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError>;

    /// What `frames`, at least one, took beside what the formulas of the generator say; nothing if it has none.
    fn sizing(&self, _frames: &[FrameTiming]) -> Vec<SizedFigure> {
        Vec::new()
    }

    /// How long the work of a frame takes in all (master ticks), where that is another time than the length of the frame.
    fn in_all(&self, _frame: &FrameTiming) -> Option<u64> {
        None
    }

    /// Times that its source reports for one frame, in the order of its routines; none if it reports none.
    fn reported(&self) -> &'static [ReportedTime] {
        &[]
    }

    /// A frame as [`frame`](Self::frame) tells it, for totals, which no record keeps: the hash of its events may be left out, and is empty then.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn frame_for_totals(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        self.frame(frame, pose)
    }
}
