//! `lunoid study`: the three promises as numbers.

mod economy;
mod error;
mod outputs;
mod pops;
mod shadow;
mod stability;

use clap::{Args, Subcommand};

use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid study error scenarios/first-light.toml --quick
  lunoid study economy scenarios/showpiece.toml --quick
  lunoid study shadow scenarios/vehicle-shadow.toml
  lunoid study pops scenarios/lod-descent.toml
  lunoid study error --help";

/// Measure error against run time, what a scene does not need, what flat ground costs a shadow, and what pops.
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
    /// What is left out, what that saves, and what is still wasted.
    Economy(economy::EconomyStudy),
    /// Stiff parts and extreme scenes, each by every method.
    Stability(stability::StabilityStudy),
    /// Distances along the view axis frame by frame, and what levels of detail do to them.
    Pops(pops::PopStudy),
    /// The vehicle's shadow on flat ground against that on true ground.
    Shadow(shadow::ShadowStudy),
}

impl StudyCommand {
    /// Runs the chosen study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.study {
            Study::Error(study) => study.run(),
            Study::Economy(study) => study.run(),
            Study::Stability(study) => study.run(),
            Study::Pops(study) => study.run(),
            Study::Shadow(study) => study.run(),
        }
    }
}
