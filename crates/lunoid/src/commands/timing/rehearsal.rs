//! A mission's timing without its pictures: frames through the control plane of a machine, or as jobs of a program, into
//! timing records.

use generator::Stage;
use hardware_model::{HardwareModel, ModelRaster, Raster, Settings};
use machine::ControlPlane;
use rayon::ThreadPool;
use replay::Progress;
use scenario::{PoseRow, PoseTable, Scenario};
use timing::{FORMAT, FrameTiming, TimingRecord};

use super::timed::Timed;
use crate::Failure;
use crate::loading::{Loaded, StageArgs, Threads};
use crate::progress::Display;
use crate::values::Span;

/// Missed deadlines that are kept: more than a person or a version control takes, less than fills the memory.
const MOST_MISSES: usize = 4_000_000;

/// Everything that a frame of a mission needs, but the frame.
pub struct Rehearsal<T = ControlPlane> {
    pub scenario: Scenario,
    pub model: HardwareModel,
    pub stage: Stage,
    /// What is timed: the digital side of a machine on the stage, or a program.
    pub control: T,
    pub pool: ThreadPool,
}

impl Rehearsal {
    /// Reads scenario and model; `frames` is asked of the scenario before any ground is made.
    pub fn open(
        stage: &StageArgs,
        threads: &Threads,
        frames: impl FnOnce(&Loaded) -> Result<Vec<u64>, Failure>,
    ) -> Result<(Self, Vec<u64>), Failure> {
        Self::of_machine(stage.load()?, threads, frames)
    }

    /// The same of what was read.
    pub fn of_machine(
        loaded: Loaded,
        threads: &Threads,
        frames: impl FnOnce(&Loaded) -> Result<Vec<u64>, Failure>,
    ) -> Result<(Self, Vec<u64>), Failure> {
        loaded.expect_machine("it has no sweeps and no deadlines")?;
        Self::of(loaded, threads, frames, |stage| Ok(ControlPlane::new(stage.clone())))
    }

    /// The hardware model with raster and range of the run, for formulas.
    pub fn model_as_run(&self) -> HardwareModel {
        let Settings { raster, timebase, range, .. } = &self.stage.settings;
        let Raster { sweeps, samples, refresh, .. } = *raster;
        let raster = ModelRaster { sweeps, samples, refresh, update: timebase.update, ..self.model.raster };
        HardwareModel { raster, range: *range, ..self.model.clone() }
    }
}

impl<T: Timed> Rehearsal<T> {
    /// Makes the ground of `loaded`, and what is timed on it.
    pub fn of(
        mut loaded: Loaded,
        threads: &Threads,
        frames: impl FnOnce(&Loaded) -> Result<Vec<u64>, Failure>,
        control: impl FnOnce(&Stage) -> Result<T, Failure>,
    ) -> Result<(Self, Vec<u64>), Failure> {
        let chosen = frames(&loaded)?;
        let pool = threads.pool()?;
        let stage = loaded.stage(&pool)?;
        let control = control(&stage)?;
        let Loaded { scenario, model, .. } = loaded;
        Ok((Self { scenario, model, stage, control, pool }, chosen))
    }

    /// Where the vehicle is in each of `frames`, ascending.
    pub fn poses(&self, frames: &[u64]) -> Result<Vec<PoseRow>, Failure> {
        let (Some(&first), Some(&last)) = (frames.first(), frames.last()) else { return Ok(Vec::new()) };
        let (update, yoke) = (self.stage.settings.timebase.update, self.stage.settings.yoke);
        let table = PoseTable::resolve(&self.scenario, &self.stage.landscape, update, yoke, first..last + 1);
        let rows = table.map_err(Failure::input)?;
        Ok(frames.iter().map(|frame| rows.rows()[(frame - first) as usize]).collect())
    }

    /// The timing record of `frames`, ascending, at least one.
    pub fn record(&self, frames: &[u64], display: &Display) -> Result<TimingRecord, Failure> {
        let poses = self.poses(frames)?;
        let first = self.poses(&[0])?[0].pose;
        let before_mission = self.pool.install(|| self.control.before_mission(&first));
        display.hear(Progress::Begins { what: "timing", frames: frames.len() as u64, kept: 0 });
        let mut kept: Vec<FrameTiming> = Vec::with_capacity(frames.len());
        let mut misses = 0;
        for (&frame, row) in frames.iter().zip(&poses) {
            let found = self.pool.install(|| self.control.frame(frame, &row.pose)).map_err(Failure::input)?;
            misses += found.misses.len();
            kept.push(found);
            check_room(misses, kept.len())?;
            display.hear(Progress::Frame { done: kept.len() as u64 });
        }
        display.end();
        Ok(TimingRecord {
            format: FORMAT,
            scenario: self.scenario.title.clone(),
            machine: self.control.machine(&self.model),
            inputs: self.control.inputs(&self.scenario, &self.stage),
            master: self.control.master(&self.stage),
            before_mission: before_mission.map_err(Failure::input)?,
            frames: kept,
        })
    }
}

fn check_room(misses: usize, frames: usize) -> Result<(), Failure> {
    if misses <= MOST_MISSES {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "{misses} missed deadlines in {frames} frames: expected at most {MOST_MISSES}; choose fewer --frames or --sweeps"
    )))
}

/// The frames asked for, or `usual` of the whole mission.
pub fn choose(
    loaded: &Loaded,
    asked: Option<Span>,
    usual: impl FnOnce(u64) -> Vec<u64>,
) -> Result<Vec<u64>, Failure> {
    match asked {
        Some(_) => Ok(loaded.choose(asked)?.collect()),
        None => Ok(usual(loaded.frames())),
    }
}

/// The first frames of a mission, at most `count`.
pub fn first(count: u64) -> impl FnOnce(u64) -> Vec<u64> {
    move |all| (0..all.min(count)).collect()
}

/// Frames spread over a mission, the first among them, at most `count`.
pub fn spread(count: u64) -> impl FnOnce(u64) -> Vec<u64> {
    move |all| {
        let chosen = all.min(count);
        (0..chosen).map(|index| index * all / chosen).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{first, spread};

    #[test]
    fn usual_frames() {
        assert_eq!(first(4)(3), [0, 1, 2]);
        assert_eq!(first(2)(90), [0, 1]);
        assert_eq!(spread(4)(90), [0, 22, 45, 67]);
        assert_eq!(spread(4)(3), [0, 1, 2]);
    }
}
