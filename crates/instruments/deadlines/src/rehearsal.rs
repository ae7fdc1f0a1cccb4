//! A mission's timing without its pictures: frames of whatever takes time, into timing records.

use std::collections::BTreeMap;

use front_door::Opened;
use generator::Timed;
use hardware_model::{HardwareModel, ModelRaster, Raster, Settings};
use landscape::Landscape;
use machine::{ControlPlane, MachineStage};
use quantities::Rate;
use rayon::ThreadPool;
use replay::Progress;
use scenario::{PoseRow, PoseTable, Scenario, Yoke};
use timing::{FORMAT, FrameTiming, TimingRecord};

use crate::DeadlineError;

/// Missed deadlines that are kept: more than a person or a version control takes, less than fills the memory.
const MOST_MISSES: usize = 4_000_000;

/// Everything that a frame of a mission needs on the hybrid machine, but the frame.
pub struct Rehearsal {
    /// The scenario, with the wishes.
    pub scenario: Scenario,
    /// The hardware model, without the wishes for raster, range and laws.
    pub model: HardwareModel,
    /// Ground, scenery and settings of the machine.
    pub stage: MachineStage,
    /// The digital side of the machine on the stage. Whatever else is drawn changes no event of it.
    pub control: ControlPlane,
    /// The threads that do the work.
    pub pool: ThreadPool,
    /// What was written and asked for, by its keys.
    pub(crate) keys: BTreeMap<String, String>,
}

impl Rehearsal {
    /// Makes the ground by the threads of `pool`. The settings are those of the hybrid machine, whatever draws.
    ///
    /// # Errors
    /// If the ground cannot be made, or something does not fit on it.
    pub fn new(opened: Opened, pool: ThreadPool) -> Result<Self, DeadlineError> {
        let keys = opened.keys()?;
        let stage = pool.install(|| opened.machine_stage())?;
        let control = ControlPlane::of_timing(stage.clone());
        let Opened { scenario, model, .. } = opened;
        Ok(Self { scenario, model, stage, control, pool, keys })
    }

    /// The hardware model with raster and range of the run, for formulas.
    pub fn model_as_run(&self) -> HardwareModel {
        let Settings { raster, timebase, range, .. } = &self.stage.settings;
        let Raster { sweeps, samples, refresh, .. } = *raster;
        let raster = ModelRaster { sweeps, samples, refresh, update: timebase.update, ..self.model.raster };
        HardwareModel { raster, range: *range, ..self.model.clone() }
    }

    /// The machine as something that takes time.
    pub(crate) fn job(&self) -> TimedJob<'_> {
        let settings = &self.stage.settings;
        TimedJob {
            scenario: &self.scenario,
            landscape: &self.stage.landscape,
            clock: (settings.timebase.update, settings.yoke),
            machine: &self.model.name,
            keys: &self.keys,
            timed: &self.control,
            pool: &self.pool,
        }
    }

    /// Hash of everything that decides the timing, as in a record.
    pub fn inputs(&self) -> String {
        self.control.inputs(&self.scenario)
    }

    /// Where the vehicle is in each of `frames`, ascending.
    ///
    /// # Errors
    /// If the path cannot be driven.
    pub fn poses(&self, frames: &[u64]) -> Result<Vec<PoseRow>, DeadlineError> {
        self.job().poses(frames)
    }

    /// The timing record of `frames`, ascending, at least one. `progress` hears of every frame.
    ///
    /// # Errors
    /// If a frame cannot be drawn, or there are more misses than a record keeps.
    pub fn record(&self, frames: &[u64], progress: &dyn Fn(Progress)) -> Result<TimingRecord, DeadlineError> {
        self.job().record(frames, progress)
    }
}

/// A mission on whatever takes time.
#[derive(Clone, Copy)]
pub(crate) struct TimedJob<'a> {
    pub scenario: &'a Scenario,
    pub landscape: &'a Landscape,
    /// Update rate and yoke, by which poses go.
    pub clock: (Rate, Option<Yoke>),
    /// Name in the record.
    pub machine: &'a str,
    pub keys: &'a BTreeMap<String, String>,
    pub timed: &'a dyn Timed,
    pub pool: &'a ThreadPool,
}

impl TimedJob<'_> {
    /// Where the vehicle is in each of `frames`, ascending.
    pub fn poses(&self, frames: &[u64]) -> Result<Vec<PoseRow>, DeadlineError> {
        let (Some(&first), Some(&last)) = (frames.first(), frames.last()) else { return Ok(Vec::new()) };
        let (update, yoke) = self.clock;
        let rows = PoseTable::resolve(self.scenario, self.landscape, update, yoke, first..last + 1)?;
        Ok(frames.iter().map(|frame| rows.rows()[(frame - first) as usize]).collect())
    }

    /// The timing record of `frames`, ascending, at least one.
    pub fn record(&self, frames: &[u64], progress: &dyn Fn(Progress)) -> Result<TimingRecord, DeadlineError> {
        let poses = self.poses(frames)?;
        let first = self.poses(&[0])?[0].pose;
        let before_mission = self.pool.install(|| self.timed.before_mission(&first));
        progress(Progress::Begins { what: "timing", frames: frames.len() as u64, kept: 0 });
        let mut kept: Vec<FrameTiming> = Vec::with_capacity(frames.len());
        let mut misses = 0;
        for (&frame, row) in frames.iter().zip(&poses) {
            let found = self.pool.install(|| self.timed.frame(frame, &row.pose))?;
            misses += found.misses.len();
            kept.push(found);
            check_room(misses, kept.len())?;
            progress(Progress::Frame { done: kept.len() as u64 });
        }
        Ok(TimingRecord {
            format: FORMAT,
            scenario: self.scenario.title.clone(),
            machine: self.machine.to_owned(),
            inputs: self.timed.inputs(self.scenario),
            keys: self.keys.clone(),
            master: self.timed.master().to_string(),
            before_mission: before_mission?,
            frames: kept,
        })
    }
}

fn check_room(misses: usize, frames: usize) -> Result<(), DeadlineError> {
    match misses <= MOST_MISSES {
        true => Ok(()),
        false => Err(DeadlineError::TooManyMisses { misses, frames, most: MOST_MISSES }),
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
