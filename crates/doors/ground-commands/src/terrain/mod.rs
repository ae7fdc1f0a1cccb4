//! `lunoid terrain`: landscapes as text files of features over a base.

mod adding;
mod edits;
mod export;
mod show;

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use terrain_builder::{Base, Description, Ground, Textures};

use command_line::output::{Place, expect_outputs};
use command_line::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid terrain new runs/ground.toml --longitude-deg 3.0,3.1 --latitude-deg 26.0,26.1 \\
    --resolution-m 50
  lunoid terrain add runs/ground.toml --id west --crater 3.03,26.05,400 --wall-percent 4 \\
    --depth-percent 20
  lunoid terrain show runs/ground.toml --plot runs/ground.png
  lunoid terrain export runs/ground.toml --out runs/ground";

/// Build landscapes from features, and export them for every generator.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct TerrainCommand {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Write a new landscape: an area without features.
    New(edits::New),
    /// Lay an elevation file below the features.
    Import(edits::Import),
    /// Add a crater, a boulder, or features from a file.
    Add(adding::Add),
    /// Remove a feature by its name.
    Remove(edits::Remove),
    /// Undo the last edit.
    Undo(edits::Undo),
    /// Tell the features in numbers, and draw the ground.
    Show(show::Show),
    /// Write a landscape as files for every generator.
    Export(export::Export),
}

impl TerrainCommand {
    /// Does what is asked.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::New(new) => new.run()?,
            What::Import(import) => import.run()?,
            What::Add(add) => add.run()?,
            What::Remove(remove) => remove.run()?,
            What::Undo(undo) => undo.run()?,
            What::Show(show) => show.run()?,
            What::Export(export) => export.run()?,
        }
        Ok(Verdict::Yes)
    }
}

/// Reads a landscape, and its base.
fn opened(file: &Path) -> Result<(Description, Base), Failure> {
    let description = Description::read(file)?;
    let base = Base::open(&description).map_err(Failure::input)?;
    Ok((description, base))
}

/// Sees that `outputs` replace neither a landscape nor a file that it names.
fn expect_apart(outputs: &[Place], file: &Path, description: &Description) -> Result<(), Failure> {
    let named = description.files().map(|path| Place::file("a file of the landscape", path));
    let inputs: Vec<Place> = [Place::file("the landscape", file)].into_iter().chain(named).collect();
    expect_outputs(outputs, &inputs)
}

/// Builds a landscape over its base.
fn built(file: &Path, description: Description, base: Base) -> Result<Ground, Failure> {
    Ground::new(description, base).map_err(|error| Failure::input(format!("{}: {error}", file.display())))
}

/// Reads the pictures over a landscape.
fn textures(file: &Path, description: &Description) -> Result<Textures, Failure> {
    Textures::open(description).map_err(|error| Failure::input(format!("{}: {error}", file.display())))
}

/// A landscape file that a command reads or edits.
#[derive(Debug, Args)]
struct Landscape {
    /// File of the landscape (TOML).
    #[arg(value_name = "FILE")]
    file: PathBuf,
}
