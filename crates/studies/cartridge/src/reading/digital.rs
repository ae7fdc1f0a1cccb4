//! What the digital side did in the frame.

use serde::Deserialize;
use timing::Deadline;

use super::Deviation;
use crate::formula::processor::{Task, response_ticks};
use crate::scene::machine::{Drawn, MachineCase};

/// A count of folds.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FoldsReading {
    /// Folds of both ramps in all sweeps.
    pub count: u64,
}

/// Sets of words asked for at a fold, in the mean of the frame.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SetsAFoldReading {
    /// How many: two registers for each colour that changes.
    pub count: f64,
}

/// Worst response time of a processor task.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ResponseReading {
    /// The processor task whose response time is read.
    pub task: Task,
}

/// A count of missed deadlines.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MissedReading {
    /// Their kind, as timing records have it: `transfer`, `sweep-set-up`, `frame-tasks`, `corner`.
    #[cfg_attr(test, schemars(with = "String"))]
    pub deadline: Deadline,
    /// How many deadlines are missed.
    pub count: u64,
}

/// Use of a unit.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct UtilisationReading {
    /// Name, as timing records have it: `cpu`, `cpu.interrupts`.
    pub unit: String,
    /// Share of the frame.
    pub share: f64,
}

/// Share of the sweeps that repeat the one before.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RepeatedSweepsReading {
    /// Share of all sweeps but the first.
    pub share: f64,
}

impl Task {
    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::SweepSetUp => "sweep-set-up",
            Self::FrameTables => "frame-tables",
        }
    }
}

impl FoldsReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        Ok(Deviation::of("folds", seen.folds as f64, self.count as f64, 1.0))
    }
}

impl SetsAFoldReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        let timing = seen.timing()?;
        let found = timing.sets.wanted as f64 / timing.folds as f64;
        Ok(Deviation::of("sets a fold", found, self.count, 1.0))
    }
}

impl ResponseReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let timing = seen.timing()?;
        let (deadline, available) = match self.task {
            Task::SweepSetUp => {
                (Deadline::SWEEP_SET_UP, timing.ticks as f64 / f64::from(meant.settings.raster.sweeps))
            }
            Task::FrameTables => (Deadline::FRAME_TASKS, timing.ticks as f64),
        };
        let least = timing.deadlines.get(&deadline).and_then(|slack| slack.least);
        let least = least.ok_or(format!("the processor has no task of the kind {}", self.task.word()))?;
        let what = format!("response of {} (ticks)", self.task.word());
        Ok(Deviation::of(what, available - least as f64, response_ticks(meant, self.task)?, 1.0))
    }
}

impl MissedReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        let slack = seen.timing()?.deadlines.get(&self.deadline);
        let slack = slack.ok_or(format!("the machine has no deadline of the kind {}", self.deadline))?;
        Ok(Deviation::of(format!("missed {}", self.deadline), slack.missed as f64, self.count as f64, 1.0))
    }
}

impl UtilisationReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        let timing = seen.timing()?;
        let unit = timing.units.iter().find(|unit| unit.unit == self.unit);
        let unit = unit.ok_or(format!("the machine has no unit {}", self.unit))?;
        Ok(Deviation::of(format!("utilisation of {}", self.unit), timing.utilisation(unit), self.share, 1.0))
    }
}

impl RepeatedSweepsReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let mut repeated = 0;
        for sweep in meant.sweeps().skip(1) {
            repeated += u32::from(seen.wave("tg.height", sweep)? == seen.wave("tg.height", sweep - 1)?);
        }
        let all = meant.settings.raster.sweeps.saturating_sub(1);
        Ok(Deviation::of("repeated sweeps", f64::from(repeated) / f64::from(all), self.share, 1.0))
    }
}
