//! `lunoid list`, `lunoid signals`: what there is.

mod signals;

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use hardware_model::{BUILT_IN, FAULTS, HardwareModel, ModelSource, proof};
use limits::{ROWS, Row};
use scenario::Scenario;
use serde_json::{Value, json};

use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};
use text::table;

use signals::SignalListing;

pub use signals::Signals;

/// List what there is.
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  lunoid list scenarios\n\nModels and scenarios are looked for in hardware-models/ and scenarios/ of the current folder."
)]
pub struct List {
    /// Kind of things to list.
    #[arg(value_enum)]
    what: Kind,
    /// Print the list as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Whatever `--machine` can name: hardware models, and generators that are none.
    Machines,
    /// Hardware models and built-in overlays.
    Models,
    /// Scenarios in the current folder.
    Scenarios,
    /// Signals of the machine.
    Signals,
    /// Limits that `--raise` sets.
    Limits,
}

impl List {
    /// Prints the list of the chosen kind.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match self.what {
            Kind::Machines => machines(self.json)?,
            Kind::Models => models(self.json)?,
            Kind::Scenarios => scenarios(self.json)?,
            Kind::Signals => SignalListing::of_table().show(self.json)?,
            Kind::Limits => limits(self.json)?,
        }
        Ok(Verdict::Yes)
    }
}

/// Lists what draws: hardware models, then generators that are none.
fn machines(json: bool) -> Result<(), Failure> {
    let others = registry::ROWS.iter().map(|row| [row.name.into(), row.about.into(), "built in".into()]);
    let others: Vec<[String; 3]> = others.collect();
    let others = Listing { what: "generators", heading: ["generator", "draws", "from"], rows: &others };
    let models = model_rows();
    let models = Listing { what: "models", heading: MODEL_HEADING, rows: &models };
    show(&[models, others], json)
}

/// Lists hardware models: those of the current folder, and those that the program carries; then the overlays that it
/// carries, over models and over generators.
pub fn models(json: bool) -> Result<(), Failure> {
    let rows = model_rows();
    let overlays = FAULTS.map(|(name, text)| [name.into(), proof(text).into(), "built in".into()]);
    let models = Listing { what: "models", heading: MODEL_HEADING, rows: &rows };
    let overlays = Listing { what: "overlays", heading: ["overlay", "proves", "from"], rows: &overlays };
    let gears = registry::ROWS.iter().filter_map(|row| Some((row.name, row.gear?)));
    let faults = gears.flat_map(|(row, gear)| gear.faults.iter().map(move |fault| (row, fault)));
    let others: Vec<[String; 3]> =
        faults.map(|(row, (name, text))| [(*name).into(), proof(text).into(), row.into()]).collect();
    let heading = ["overlay", "proves", "over"];
    let others = Listing { what: "overlays_of_generators", heading, rows: &others };
    show(&[models, overlays, others], json)
}

const MODEL_HEADING: [&str; 3] = ["name", "raster", "from"];

fn model_rows() -> Vec<[String; 3]> {
    let mut files = toml_files("hardware-models");
    // Below it are differences and programs.
    files.retain(|file| file.parent().is_some_and(|folder| folder.ends_with("hardware-models")));
    let carried = BUILT_IN.iter().filter(|(name, _)| !files.iter().any(|file| stem(file) == *name));
    let files = files.iter().map(|file| (file.display().to_string(), ModelSource::File(file.clone())));
    let sources =
        files.chain(carried.map(|(name, _)| ("built in".into(), ModelSource::BuiltIn((*name).into()))));
    sources
        .map(|(place, source)| match HardwareModel::load(&source, &[], &[]) {
            Ok(loaded) => {
                let raster = loaded.model.raster;
                let says =
                    format!("{} sweeps of {} samples, {}", raster.sweeps, raster.samples, raster.update);
                [loaded.model.name, says, place]
            }
            Err(problems) => [stem(Path::new(&place)), faults(problems.len()), place],
        })
        .collect()
}

fn scenarios(json: bool) -> Result<(), Failure> {
    let read = |file: &Path| Scenario::read_beside(file, &registry::parameter_tables());
    let row = |file: &PathBuf| match read(file) {
        Ok(scenario) => [file.display().to_string(), scenario.title, scenario.shows],
        Err(problems) => [file.display().to_string(), String::new(), faults(problems.len())],
    };
    let rows: Vec<[String; 3]> = toml_files("scenarios").iter().map(row).collect();
    show(&[Listing { what: "scenarios", heading: ["file", "title", "shows"], rows: &rows }], json)
}

/// Lists what is read and made at most, as it is set now.
fn limits(json: bool) -> Result<(), Failure> {
    if json {
        let row = |Row { name, what, limit, most, .. }: &Row| json!({ "name": name, "of": what, "at_most": limit.value(), "raised_to_at_most": most });
        let rows: Vec<_> = ROWS.iter().map(row).collect();
        return print_json(&json!({ "schema": "lunoid.list/1", "limits": rows }));
    }
    let row = |row: Row| {
        let most = format!("{}, can be raised to {}", row.limit.value(), row.most);
        [row.name.into(), row.what.into(), most]
    };
    show(&[Listing { what: "limits", heading: ["name", "of", "at most"], rows: &ROWS.map(row) }], false)
}

/// Rows under a heading.
struct Listing<'a> {
    what: &'a str,
    heading: [&'a str; 3],
    rows: &'a [[String; 3]],
}

impl Listing<'_> {
    fn document(&self) -> Value {
        let row = |row: &[String; 3]| {
            let keys = self.heading.iter().map(|key| (*key).to_owned());
            Value::Object(keys.zip(row.iter().map(|cell| Value::from(cell.as_str()))).collect())
        };
        self.rows.iter().map(row).collect()
    }

    fn table(&self) -> String {
        let heading = self.heading.map(str::to_owned).to_vec();
        let rows = self.rows.iter().map(|row| row.to_vec());
        table(&[heading].into_iter().chain(rows).collect::<Vec<_>>())
    }
}

fn show(listings: &[Listing], json: bool) -> Result<(), Failure> {
    if json {
        let mut document = json!({ "schema": "lunoid.list/1" });
        for listing in listings {
            document[listing.what] = listing.document();
        }
        return print_json(&document);
    }
    print(&listings.iter().map(Listing::table).collect::<Vec<_>>().join("\n"))
}

fn faults(count: usize) -> String {
    format!("{count} fault{}: see lunoid check", if count == 1 { "" } else { "s" })
}

fn stem(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// TOML files of a folder and of the folders in it, in alphabetical order; none where there is no such folder.
fn toml_files(folder: &str) -> Vec<PathBuf> {
    let entries =
        |folder: &Path| fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let is_meant = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        // The descriptions of banks are TOML too.
        path.is_file() && name.ends_with(".toml") && !name.ends_with(".bank.toml")
    };
    let here: Vec<PathBuf> = entries(Path::new(folder)).collect();
    let below = here.iter().filter(|path| path.is_dir()).flat_map(|path| entries(path));
    let mut files: Vec<PathBuf> = below.chain(here.iter().cloned()).filter(is_meant).collect();
    files.sort();
    files
}
