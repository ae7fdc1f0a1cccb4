//! A rehearsal of whatever a timing record can be made of.

use generator::Stage;
use lunsim::Program;
use timing::{FrameTiming, TimingRecord};

use super::rehearsal::Rehearsal;
use crate::Failure;
use crate::loading::{Loaded, StageArgs, Threads};
use crate::output::table;
use crate::progress::Display;

/// A machine's digital side, or LUNSIM.
pub enum Rehearsed {
    Machine(Box<Rehearsal>),
    Program(Box<Rehearsal<Program>>),
}

impl Rehearsed {
    /// Reads scenario and model; `frames` is asked of the scenario before any ground is made.
    pub fn open(
        stage: &StageArgs,
        threads: &Threads,
        frames: impl FnOnce(&Loaded) -> Result<Vec<u64>, Failure>,
    ) -> Result<(Self, Vec<u64>), Failure> {
        let loaded = stage.load()?;
        let Some(hardware) = loaded.program else {
            let (machine, frames) = Rehearsal::of_machine(loaded, threads, frames)?;
            return Ok((Self::Machine(Box::new(machine)), frames));
        };
        let program = |stage: &Stage| Program::new(stage.clone(), hardware).map_err(Failure::input);
        let (program, frames) = Rehearsal::of(loaded, threads, frames, program)?;
        Ok((Self::Program(Box::new(program)), frames))
    }

    /// The timing record of `frames`, ascending, at least one.
    pub fn record(&self, frames: &[u64], display: &Display) -> Result<TimingRecord, Failure> {
        match self {
            Self::Machine(machine) => machine.record(frames, display),
            Self::Program(program) => program.record(frames, display),
        }
    }
}

/// How long each frame of a program takes, unit by unit and in all.
pub fn times_text(record: &TimingRecord) -> String {
    let seconds = |ticks: u64| format!("{:.2}", ticks as f64 / Program::MASTER_HZ as f64);
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
