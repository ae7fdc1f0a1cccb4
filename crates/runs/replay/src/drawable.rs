//! Whether a job can be drawn at all, before a file is written.

use std::ops::Range;

use generator::{PrepareError, Session};
use rayon::ThreadPool;
use scenario::{PathProblems, PoseTable};

use crate::{Job, ReplayError};

impl Job<'_> {
    /// Asks the generator for every frame of the job; nothing is drawn and nothing written.
    ///
    /// # Errors
    /// If the path cannot be driven, or the generator cannot draw the stage or the pose of a frame.
    pub fn expect_drawable(&self, pool: &ThreadPool) -> Result<(), ReplayError> {
        let poses = self.poses(self.frames.clone())?;
        let session = self.session(pool)?;
        Ok(poses.rows().iter().try_for_each(|row| session.check(row.frame, &row.pose))?)
    }

    /// Eye and attitude of `frames`.
    ///
    /// # Errors
    /// If the path cannot be driven.
    pub fn poses(&self, frames: Range<u64>) -> Result<PoseTable, PathProblems> {
        let view = &self.stage.view;
        let update = view.update;
        PoseTable::resolve(self.scenario, &self.stage.landscape, update, view.yoke, frames)
    }

    /// The generator made ready by the threads of `pool`.
    pub(crate) fn session(&self, pool: &ThreadPool) -> Result<Box<dyn Session>, PrepareError> {
        pool.install(|| self.generator.prepare(self.stage.clone()))
    }
}
