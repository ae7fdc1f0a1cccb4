//! `lunoid bank`: banks of terrain coefficients.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use landscape::bank_file::{self, export_corners, import_corners, sidecar_path};
use landscape::{Bank, Level, Sun};
use limits::Limit;
use plots::{BankLook, bank_picture};
use quantities::radians;
use serde_json::json;

use command_line::loading::StageArgs;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};
use file_info::{bank_document, bank_text};
use front_door::read_scenario;

/// Make, read and draw banks of terrain coefficients.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid bank show moon.bank -o moon.png")]
pub struct BankCommand {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Make a bank from plain coefficients.
    Import(Import),
    /// Give the plain coefficients of a bank back.
    Export(Export),
    /// Describe a bank, and draw it.
    Show(Show),
    /// Write the landscape of a scenario as a bank.
    Generate(Generate),
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid bank import corners.npy --region-size-m 250 -o moon.bank\n\n\
    The array is f64 [corners north, corners east, 9]; word 3p+q is d^(p+q) times the derivative of height p times to\n\
    the north and q times to the east, in metres; corners ascend from the origin.")]
struct Import {
    /// Array of corners (.npy).
    corners: PathBuf,
    /// Side of a region.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    region_size_m: f64,
    /// North and east of the first corner.
    #[arg(long, value_name = "X,Y", value_parser = values::place, default_value = "0,0")]
    origin_m: [f64; 2],
    /// What the ground is.
    #[arg(long)]
    title: Option<String>,
    /// Bank to write; a text description is written beside it.
    #[arg(short, long, value_name = "BANK")]
    out: PathBuf,
    /// Print what was written as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid bank export moon.bank -o corners.npy")]
struct Export {
    /// Bank file to read.
    bank: PathBuf,
    /// Level, 0 is the finest.
    #[arg(long, default_value_t = 0, value_parser = values::at_least(0_usize))]
    level: usize,
    /// Array to write (.npy).
    #[arg(short, long, value_name = "NPY")]
    out: PathBuf,
    /// Print what was written as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid bank show moon.bank -o moon.png --sun 120,10")]
struct Show {
    /// Bank file to read.
    bank: PathBuf,
    /// Picture file to write.
    #[arg(short, long, value_name = "PNG|SVG")]
    out: Option<PathBuf>,
    /// Level to draw, 0 is the finest.
    #[arg(long, requires = "out", default_value_t = 0, value_parser = values::at_least(0_usize))]
    level: usize,
    /// Azimuth and elevation of the sun in the picture (degrees).
    #[arg(long, value_name = "AZIMUTH,ELEVATION", requires = "out", value_parser = values::sun,
          default_value = "315,20")]
    sun: [f64; 2],
    /// The longer side of the map (pixels).
    #[arg(long, requires = "out", default_value_t = 800, value_parser = values::whole(120..=8000_u32))]
    pixels: u32,
    /// Draw the borders of regions.
    #[arg(long, requires = "out")]
    regions: bool,
    /// Print the description as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid bank generate scenarios/first-light.toml -o first-light.bank")]
struct Generate {
    /// Scenario to read: a file, or the name of one in `scenarios/`.
    #[arg(value_parser = values::scenario)]
    scenario: PathBuf,
    /// Bank file to write.
    #[arg(short, long, value_name = "BANK")]
    out: PathBuf,
    /// Print what was written as JSON.
    #[arg(long)]
    json: bool,
}

impl BankCommand {
    /// Does what is asked.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Import(import) => import.run()?,
            What::Export(export) => export.run()?,
            What::Show(show) => show.run()?,
            What::Generate(generate) => generate.run()?,
        }
        Ok(Verdict::Yes)
    }
}

impl Import {
    fn run(&self) -> Result<(), Failure> {
        expect_outputs(&bank_at(&self.out), &[Place::file("the array", &self.corners)])?;
        let of_file =
            |error: &dyn std::fmt::Display| Failure::input(format!("{}: {error}", self.corners.display()));
        let array = files::read_npy(&self.corners, Limit::BankBytes)?;
        let level =
            import_corners(array, self.region_size_m, self.origin_m).map_err(|error| of_file(&error))?;
        let stem = self.corners.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let title = self.title.clone().unwrap_or(stem);
        let bank = Bank::new(title, vec![level], None).map_err(|error| of_file(&error))?;
        write(&self.out, &bank, self.json)
    }
}

impl Export {
    fn run(&self) -> Result<(), Failure> {
        expect_outputs(&[Place::file("--out", &self.out)], &[Place::file("the bank", &self.bank)])?;
        let bank = bank_file::read(&self.bank)?;
        let level = level_of(&self.bank, &bank, self.level)?;
        files::write_npy(&self.out, &export_corners(level))?;
        let [north, east] = level.corners();
        if self.json {
            return print_json(&json!({
                "schema": "lunoid.bank-exported/1",
                "file": self.out.display().to_string(),
                "level": self.level,
                "shape": [north, east, 9],
            }));
        }
        print(&format!("{}: f64 [{north}, {east}, 9]\n", self.out.display()))
    }
}

impl Show {
    fn run(&self) -> Result<(), Failure> {
        expect_outputs(&Place::pictures([("--out", &self.out)]), &[Place::file("the bank", &self.bank)])?;
        let bank = bank_file::read(&self.bank)?;
        let level = level_of(&self.bank, &bank, self.level)?;
        if let Some(out) = &self.out {
            let [azimuth, elevation] = self.sun.map(radians);
            let mut look = BankLook::titled(bank.title());
            (look.longest, look.regions) = (self.pixels, self.regions);
            bank_picture(level, Sun { azimuth, elevation }, &look)?.write(out)?;
        }
        if self.json { print_json(&bank_document(&self.bank, &bank)) } else { print(&bank_text(&bank)) }
    }
}

impl Generate {
    fn run(&self) -> Result<(), Failure> {
        expect_outputs(&bank_at(&self.out), &StageArgs::of(&self.scenario).sources())?;
        let scenario = read_scenario(&self.scenario)?;
        write(&self.out, &front_door::bank(&scenario)?, self.json)
    }
}

/// A bank that is to be written, and the description beside it.
pub fn bank_at(out: &Path) -> [Place; 2] {
    [Place::file("--out", out), Place::file("the description beside --out,", sidecar_path(out))]
}

fn write(out: &Path, bank: &Bank, json: bool) -> Result<(), Failure> {
    bank_file::write(out, bank)?;
    if json {
        return print_json(&bank_document(out, bank));
    }
    print(&format!("{}: {}", out.display(), bank_text(bank)))
}

fn level_of<'a>(path: &Path, bank: &'a Bank, index: usize) -> Result<&'a Level, Failure> {
    bank.levels().get(index).ok_or_else(|| {
        let (path, count) = (path.display(), bank.levels().len());
        Failure::usage(format!("--level {index}: {path} has levels 0..{count}; expected one of them"))
    })
}
