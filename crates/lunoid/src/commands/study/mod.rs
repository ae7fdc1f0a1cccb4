//! `lunoid study`: the three promises as numbers.

mod error;
mod plots;

use clap::{Args, Subcommand};

use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid study error scenarios/first-light.toml --quick
  lunoid study error --help";

/// Measure error against run time.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct StudyCommand {
    #[command(subcommand)]
    study: Study,
}

#[derive(Debug, Subcommand)]
enum Study {
    /// Error against run time, one factor at a time.
    Error(error::ErrorStudy),
}

impl StudyCommand {
    /// Studies.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.study {
            Study::Error(study) => study.run(),
        }
    }
}
