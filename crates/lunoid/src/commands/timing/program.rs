//! A rehearsal of whatever a timing record can be made of.

use front_door::Opened;
use generator::{Stage, Timed};
use rayon::ThreadPool;
use timing::{FrameTiming, TimingRecord};

use super::rehearsal::{Rehearsal, TimedJob};
use crate::Failure;
use crate::loading::{StageArgs, Threads};
use crate::output::table;
use crate::progress::Display;

/// The hybrid machine's digital side, or another generator whose frames take time.
pub enum Rehearsed {
    Machine(Box<Rehearsal>),
    Other(Box<Other>),
}

/// A generator that is no hybrid machine, as something that takes time.
pub struct Other {
    opened: Opened,
    stage: Stage,
    timed: Box<dyn Timed>,
    pool: ThreadPool,
}

impl Rehearsed {
    /// Reads scenario and model; `frames` is asked of the scenario before any ground is made.
    pub fn open(
        stage: &StageArgs,
        threads: &Threads,
        frames: impl FnOnce(&Opened) -> Result<Vec<u64>, Failure>,
    ) -> Result<(Self, Vec<u64>), Failure> {
        let opened = stage.load()?;
        if opened.row.is_none_or(|row| !row.timed) {
            let (machine, frames) = Rehearsal::of(opened, threads, frames)?;
            return Ok((Self::Machine(Box::new(machine)), frames));
        }
        let frames = frames(&opened)?;
        Ok((Self::Other(Box::new(Other::new(opened, threads)?)), frames))
    }

    /// The timing record of `frames`, ascending, at least one.
    pub fn record(&self, frames: &[u64], display: &Display) -> Result<TimingRecord, Failure> {
        match self {
            Self::Machine(machine) => machine.record(frames, display),
            Self::Other(other) => other.job().record(frames, display),
        }
    }
}

impl Other {
    fn new(opened: Opened, threads: &Threads) -> Result<Self, Failure> {
        let pool = threads.pool()?;
        let stage = pool.install(|| opened.stage())?;
        let timed = opened.generator.timed(stage.clone()).map_err(Failure::input)?;
        let timed = timed.ok_or_else(|| {
            Failure::usage(format!("--machine {}: its frames take no time", opened.drawn_by()))
        })?;
        Ok(Self { opened, stage, timed, pool })
    }

    fn job(&self) -> TimedJob<'_> {
        TimedJob {
            scenario: &self.opened.scenario,
            landscape: &self.stage.landscape,
            clock: (self.stage.view.update, self.stage.view.yoke),
            machine: self.opened.drawn_by(),
            timed: &*self.timed,
            pool: &self.pool,
        }
    }

    /// How long each frame takes, unit by unit and in all.
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
