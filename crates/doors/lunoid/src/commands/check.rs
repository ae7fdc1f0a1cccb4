//! `lunoid check`: scenarios, hardware models and whatever else is written in TOML, every fault of each.

use std::path::{Path, PathBuf};

use cartridge::{CartridgeError, of_file};
use clap::Args;
use diagnostics::{Problem, ProblemList, ProblemRecord};
use files::FileError;
use front_door::{KNOWN, Kind, OpenError, Wishes, expect_drawable, expect_followable, open, path_problems};
use generator::Row;
use hardware_model::{HardwareModel, ModelSource};
use limits::Limit;
use serde_json::{Value, json};
use terrain_builder::{Base, Description, Ground, Textures};

use command_line::output::{Colour, print, print_json, tell, warn};
use command_line::values;
use command_line::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid check scenarios/*.toml hardware-models/*.toml

A scenario is read with its machine, its ground is made and its path driven over it; nothing is
drawn. A file of differences, with neither `name` nor `base`, is read as an overlay over the
ideal machine. What the program of a generator ran on and cartridges are read too, and a
landscape of `lunoid terrain` is built. Exit code 3 if there is any fault.";

/// Read scenarios, hardware models and whatever else is written in TOML, and list every fault.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Check {
    /// The files to check; a scenario also by its name in `scenarios/`.
    #[arg(required = true, value_parser = values::scenario)]
    files: Vec<PathBuf>,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
}

impl Check {
    /// Checks every file and prints all faults.
    pub fn run(&self, colour: Colour) -> Result<Verdict, Failure> {
        let found = self.files.iter().map(|file| {
            let kind = Kind::of(file);
            let result = match kind {
                Kind::Scenario => check_scenario(file),
                Kind::Model => check_model(file),
                Kind::Overlay => check_overlay(file),
                Kind::Sidecar => Ok(Sound::default()),
                Kind::Terrain => check_terrain(file),
                Kind::Gear(row) => of_generator(row, file, registry::check_gear),
                Kind::GeneratorOverlay(row) => {
                    of_generator(row, file, |row, name, text| registry::overlay(row, name, text).map(drop))
                }
                Kind::Cartridge => check_cartridge(file),
                Kind::Unknown => Err(of_no_kind(file)),
            };
            (file, kind, result)
        });
        let found: Vec<_> = found.collect();
        let faults: Vec<&ProblemList> =
            found.iter().filter_map(|(_, _, result)| result.as_ref().err()).collect();
        if self.json {
            let rows = found.iter().map(|(file, kind, result)| document(file, *kind, result));
            print_json(&json!({ "schema": "lunoid.check/1", "files": rows.collect::<Vec<_>>() }))?;
        } else {
            for (file, kind, result) in &found {
                if let Ok(sound) = result {
                    sound.remarks.iter().for_each(|remark| warn(remark));
                    let drawn = sound.drawing.iter().map(|drawing| format!("; drawn {drawing}"));
                    let drawn = drawn.collect::<String>();
                    print(&format!("{}: {}, no fault{drawn}\n", file.display(), kind.word()))?;
                }
            }
            let texts: Vec<String> = faults.iter().map(|list| list.render(colour.on_stderr())).collect();
            tell(&texts.join("\n"));
        }
        match faults.into_iter().next() {
            None => Ok(Verdict::Yes),
            Some(_) => Err(Failure::Told),
        }
    }
}

/// What a file without a fault has to say.
#[derive(Debug, Default)]
struct Sound {
    /// What is odd about it, in words.
    remarks: Vec<String>,
    /// How the hybrid machine draws it by default, if it is a scenario of it.
    drawing: Option<String>,
}

impl From<Vec<String>> for Sound {
    fn from(remarks: Vec<String>) -> Self {
        Self { remarks, drawing: None }
    }
}

/// A file without a fault, or every fault.
type Checked = Result<Sound, ProblemList>;

/// Of a model alone: over a scenario of other sweeps its delays may meet their words all the same.
fn check_model(path: &Path) -> Checked {
    let loaded = HardwareModel::read(path, &[], &[])?;
    expect_drawable(&loaded)?;
    let idle = loaded.model.check().into_iter().filter(|finding| finding.keys.contains(&"loader.delay"));
    let idle = idle.map(|finding| format!("{}: {}", path.display(), finding.message));
    Ok(loaded.remarks.into_iter().chain(idle).collect::<Vec<_>>().into())
}

/// Differences have no faults by themselves: they are those of the ideal machine under them. Whether a machine can be built under them
/// depends on the model below.
fn check_overlay(path: &Path) -> Checked {
    let ideal = ModelSource::BuiltIn("ideal".into());
    let loaded = HardwareModel::load(&ideal, &[path.to_owned()], &[])?;
    expect_followable(&loaded.values).map(|()| Sound::default())
}

/// Reads a file of the generator of `row`.
fn of_generator(row: &Row, path: &Path, read: fn(&Row, &str, &str) -> Result<(), ProblemList>) -> Checked {
    let name = path.display().to_string();
    let of_file = |error: FileError| Problem::of_file(&name, error.to_string());
    let bytes = files::read_all(path, Limit::TextBytes).map_err(of_file)?;
    read(row, &name, &String::from_utf8_lossy(&bytes)).map(|()| Sound::default())
}

fn check_cartridge(path: &Path) -> Checked {
    let problem = |error: CartridgeError| Problem::of_file(error.place, error.message);
    of_file(path).map(|_| Sound::default()).map_err(|error| problem(error).into())
}

/// Builds a landscape over its base, with its pictures.
fn check_terrain(path: &Path) -> Checked {
    let name = path.display().to_string();
    let of_file = |error: &dyn std::fmt::Display| Problem::of_file(&name, error.to_string());
    let description = Description::read(path)?;
    let base = Base::open(&description).map_err(|error| of_file(&error))?;
    Textures::open(&description).map_err(|error| of_file(&error))?;
    let ground = Ground::new(description, base).map_err(|error| of_file(&error))?;
    Ok(ground.warnings().iter().map(|warning| format!("{name}: {warning}")).collect::<Vec<_>>().into())
}

fn of_no_kind(path: &Path) -> ProblemList {
    let title = "no key of any kind of file that is known";
    Problem::of_file(path.display().to_string(), title).expected(KNOWN).into()
}

fn check_scenario(path: &Path) -> Checked {
    let name = path.display().to_string();
    let problems = |error: OpenError| match error {
        OpenError::Problems(list) => list,
        other => Problem::of_file(&name, other.to_string()).into(),
    };
    let opened = open(path, &Wishes::default()).map_err(problems)?;
    let stage = opened.machine_stage().map_err(problems)?;
    opened.poses(&stage.stage(), 0..opened.frames()).map_err(|error| path_problems(&error))?;
    let drawing = opened.drawing(&stage);
    Ok(Sound { remarks: opened.remarks, drawing })
}

fn document(file: &Path, kind: Kind, result: &Checked) -> Value {
    let problems = result.as_ref().err().into_iter().flat_map(ProblemList::records).map(|record| {
        let ProblemRecord { file, line, column, key, title, found, expected, help } = record;
        json!({ "file": file, "line": line, "column": column, "key": key, "title": title, "found": found,
                "expected": expected, "help": help })
    });
    json!({
        "file": file.display().to_string(),
        "kind": kind.word(),
        "ok": result.is_ok(),
        "problems": problems.collect::<Vec<_>>(),
        "warnings": result.as_ref().map_or(&[][..], |sound| &sound.remarks),
        "drawing": result.as_ref().ok().and_then(|sound| sound.drawing.as_ref()),
    })
}
