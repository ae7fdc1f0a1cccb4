//! `lunoid timing`: what the digital side did and when, and baselines to hold it to.

mod baseline;
mod columns;
mod show;

use clap::{Args, Subcommand};

use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid timing show scenarios/first-light.toml --machine pra-nominal --frames 0..4
  lunoid timing record scenarios/first-light.toml --machine pra-nominal --frames 0..2 \\
    --out first-light.json
  lunoid timing check scenarios/first-light.toml --machine pra-nominal --baseline first-light.json";

/// Show the timing of the digital side, record it, and hold it to a record.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct TimingCommand {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Write the timing of some frames as a baseline, for version control.
    Record(baseline::Record),
    /// Hold the timing to a baseline: 0 it is met, 1 it is not, 3 bad input.
    Check(baseline::Check),
    /// Show deadlines, use of units, misses and the critical path, as text, JSON or plots.
    Show(show::Show),
    /// Trace every column that differs from the ideal machine to lines of the record: 0 all are accounted for, 1 not.
    Columns(columns::Columns),
}

impl TimingCommand {
    /// Does what is asked.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Record(record) => record.run(),
            What::Check(check) => check.run(),
            What::Show(show) => show.run(),
            What::Columns(columns) => columns.run(),
        }
    }
}
