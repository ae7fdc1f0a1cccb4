//! `lunoid photo`: photographs of the ground.

mod check;
mod drape;
mod make;

use clap::{Args, Subcommand};

use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid photo make scenarios/first-light.toml --out runs/photo
  lunoid photo check runs/photo/photo.png --camera runs/photo/camera.json --ground runs/photo/elevation.asc
  lunoid photo drape scenarios/first-light.toml --photo runs/photo/photo.png --camera runs/photo/camera.json --out runs/albedo.png

docs/photo.md describes the files.";

/// Make a photograph of a landscape, check a photograph against an elevation file, and make a map of albedo out of photographs.
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
    /// Make a map of the ground's albedo out of photographs.
    Drape(drape::DrapeArgs),
}

impl PhotoCommand {
    /// Makes, checks or drapes a photograph.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Make(make) => make.run(),
            What::Check(check) => check.run(),
            What::Drape(drape) => drape.run(),
        }
    }
}
