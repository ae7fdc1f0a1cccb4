//! A rehearsal of whatever a timing record can be made of.

use std::collections::BTreeMap;

use front_door::Opened;
use generator::{Stage, Timed};
use rayon::ThreadPool;
use replay::Progress;
use text::table;
use timing::{FrameTiming, TimingRecord};

use crate::rehearsal::TimedJob;
use crate::{DeadlineError, Rehearsal};

/// The hybrid machine's digital side, or another generator whose frames take time.
pub enum Rehearsed {
    /// The digital side of the hybrid machine.
    Machine(Box<Rehearsal>),
    /// Another generator whose frames take time.
    Other(Box<Other>),
}

/// A generator that is no hybrid machine, as something that takes time.
pub struct Other {
    opened: Opened,
    keys: BTreeMap<String, String>,
    stage: Stage,
    timed: Box<dyn Timed>,
    pool: ThreadPool,
}

impl Rehearsed {
    /// Makes the ground by the threads of `pool`, and readies whatever draws.
    ///
    /// # Errors
    /// If the ground cannot be made, or the frames of the generator take no time.
    pub fn new(opened: Opened, pool: ThreadPool) -> Result<Self, DeadlineError> {
        match opened.is_machine() {
            true => Ok(Self::Machine(Box::new(Rehearsal::new(opened, pool)?))),
            false => Ok(Self::Other(Box::new(Other::new(opened, pool)?))),
        }
    }

    /// The timing record of `frames`, ascending, at least one. `progress` hears of every frame.
    ///
    /// # Errors
    /// If a frame cannot be drawn, or there are more misses than a record keeps.
    pub fn record(&self, frames: &[u64], progress: &dyn Fn(Progress)) -> Result<TimingRecord, DeadlineError> {
        match self {
            Self::Machine(machine) => machine.record(frames, progress),
            Self::Other(other) => other.job().record(frames, progress),
        }
    }
}

impl Other {
    fn new(opened: Opened, pool: ThreadPool) -> Result<Self, DeadlineError> {
        let keys = opened.keys()?;
        let stage = pool.install(|| opened.stage())?;
        let timed = opened.generator.timed(stage.clone())?;
        let timed = timed.ok_or_else(|| DeadlineError::NoTime(opened.drawn_by().to_owned()))?;
        Ok(Self { opened, keys, stage, timed, pool })
    }

    fn job(&self) -> TimedJob<'_> {
        TimedJob {
            scenario: &self.opened.scenario,
            landscape: &self.stage.landscape,
            clock: (self.stage.view.update, self.stage.view.yoke),
            machine: self.opened.drawn_by(),
            keys: &self.keys,
            timed: &*self.timed,
            pool: &self.pool,
        }
    }

    /// A table of how long each frame of `record` takes (s), unit by unit and in all.
    pub fn times_text(&self, record: &TimingRecord) -> String {
        times_text(record, self.timed.master().hertz())
    }
}

fn times_text(record: &TimingRecord, master_hz: f64) -> String {
    let seconds = |ticks: u64| format!("{:.2}", ticks as f64 / master_hz);
    let head = |frame: &FrameTiming| -> Vec<String> {
        let units = frame.units.iter().map(|unit| format!("{} (s)", unit.unit));
        ["frame".to_owned()].into_iter().chain(units).chain(["in all (s)".to_owned()]).collect()
    };
    let row = |frame: &FrameTiming| -> Vec<String> {
        let units = frame.units.iter().map(|unit| seconds(unit.busy));
        [frame.frame.to_string()].into_iter().chain(units).chain([seconds(frame.ticks)]).collect()
    };
    let rows: Vec<_> =
        record.frames.first().map(head).into_iter().chain(record.frames.iter().map(row)).collect();
    format!("\n{}", table(&rows))
}
