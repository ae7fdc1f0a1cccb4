//! The arithmetic of the hardware report, section 4, measured by running; and the slowest parts that would just do.

mod blend;
mod level;
mod report;
mod search;
mod tear;
mod units;

use generator::FrameError;
use machine::FrameSweeps;
use scenario::PoseRow;
use timing::TimingRecord;

use self::blend::BlendFigures;
use self::level::LevelFigures;
use self::tear::TearLaw;
use crate::{DeadlineError, Rehearsal};

pub use report::Report;
pub use search::Search;

/// Frames of a mission on the hybrid machine whose parts are sized.
pub struct Sizing<'a> {
    rehearsal: &'a Rehearsal,
    poses: Vec<PoseRow>,
    law: TearLaw,
    /// Lines of the picture from which a step shows.
    shows: f64,
}

impl<'a> Sizing<'a> {
    /// `frames` of the mission, ascending. A step of `shows` lines of the picture shows as a tear.
    ///
    /// # Errors
    /// If the path cannot be driven.
    pub fn new(rehearsal: &'a Rehearsal, frames: &[u64], shows: f64) -> Result<Self, DeadlineError> {
        let law = TearLaw::new(&rehearsal.stage.settings.raster, shows);
        Ok(Self { rehearsal, poses: rehearsal.poses(frames)?, law, shows })
    }

    /// What was measured beside what the formulas say. `record` is of the same frames.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    pub fn report(&self, record: &TimingRecord) -> Result<Report, DeadlineError> {
        let rehearsal = self.rehearsal;
        let sweeps = |row: &PoseRow| rehearsal.control.sweeps(row.frame, &row.pose);
        let (levels, blend) = rehearsal.pool.install(|| -> Result<_, FrameError> {
            let frames = self.poses.iter().map(sweeps).collect::<Result<Vec<FrameSweeps<'_>>, _>>()?;
            Ok((
                LevelFigures::measure(rehearsal, &frames, &self.law),
                BlendFigures::measure(rehearsal, &frames),
            ))
        })?;
        Ok(Report::new(rehearsal, record, (&levels, blend.as_ref()), &self.poses, self.shows))
    }

    /// The slowest parts with which no tear shows.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    pub fn search(&self) -> Result<Vec<Search>, DeadlineError> {
        let Self { rehearsal, poses, law, .. } = self;
        Ok(rehearsal.pool.install(|| search::all(rehearsal, poses, law))?)
    }
}
