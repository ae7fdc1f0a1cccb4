//! `lunoid photo`: photographs of the ground.

mod brief;
mod check;
mod drape;
mod import;
mod make;

use clap::{Args, Subcommand};

use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid photo make scenarios/first-light.toml --out runs/photo
  lunoid photo import image.tif --out runs/image
  lunoid photo check runs/photo/photo.png --camera runs/photo/camera.json \\
    --ground runs/photo/elevation.asc
  lunoid photo drape scenarios/first-light.toml --photo runs/photo/photo.png \\
    --camera runs/photo/camera.json --out runs/albedo.png
  lunoid photo brief runs/photo-flight --out runs/briefing.png

docs/photo.md describes the files.";

/// Make or import a photograph of ground, check it against an elevation file, make a map of albedo, and put a map beside a flight.
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
    /// Make a photograph with its map file out of a georeferenced raster of light.
    Import(import::Import),
    /// Say how well a photograph and an elevation file agree.
    Check(check::Check),
    /// Make a map of the ground's albedo out of photographs.
    Drape(drape::DrapeArgs),
    /// Put the map beside each frame of a run: the course, the eye's place and the angle of view.
    Brief(brief::Brief),
}

impl PhotoCommand {
    /// Makes, imports, checks or drapes a photograph, or briefs a flight.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Make(make) => make.run(),
            What::Import(import) => import.run(),
            What::Check(check) => check.run(),
            What::Drape(drape) => drape.run(),
            What::Brief(brief) => brief.run(),
        }
    }
}
