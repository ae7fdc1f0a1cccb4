//! `lunoid state`: the whole machine written, read, gone on from and stepped.

mod held;
mod load;
mod save;
mod step;

use clap::{Args, Subcommand};

use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid state save scenarios/nominal-drive.toml --frame 40 --sweep 262 --out there.state
  lunoid state load there.state --frames 3 --out after
  lunoid state step there.state --by event --count 5

docs/state-format.md describes the file.";

/// Write the whole machine at the start of a sweep, go on from there, or step from place to place.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct StateCommand {
    #[command(subcommand)]
    action: Action,
}

/// What is done with a state.
#[derive(Debug, Subcommand)]
enum Action {
    /// Write the machine at the start of a sweep into a file.
    Save(save::Save),
    /// Read the machine from a file and draw the rest of its frame, and frames after it.
    Load(load::Load),
    /// Move a machine that stands in a file, forwards or backwards, and show what is there.
    Step(step::Step),
}

impl StateCommand {
    /// Does what the command line says.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.action {
            Action::Save(save) => save.run(),
            Action::Load(load) => load.run(),
            Action::Step(step) => step.run(),
        }
    }
}
