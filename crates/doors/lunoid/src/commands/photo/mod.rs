//! `lunoid photo`: photographs of the ground.

mod check;
mod make;

use clap::{Args, Subcommand};

use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid photo make scenarios/first-light.toml --out runs/photo
  lunoid photo check runs/photo/photo.png --camera runs/photo/camera.json --ground runs/photo/elevation.asc

docs/photo.md describes the files.";

/// Make a photograph of a landscape, and check a photograph against an elevation file.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct PhotoCommand {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Draw a vertical or oblique photograph of a landscape, with its camera file, its truth and its elevations.
    Make(make::Make),
    /// Say how well a photograph and an elevation file agree.
    Check(check::Check),
}

impl PhotoCommand {
    /// Makes or checks a photograph.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Make(make) => make.run(),
            What::Check(check) => check.run(),
        }
    }
}
