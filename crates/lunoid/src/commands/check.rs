//! `lunoid check`: scenarios, hardware models and whatever else is written in TOML, every fault of each.

use std::path::{Path, PathBuf};

use cartridge::{CartridgeError, of_file};
use clap::Args;
use diagnostics::{Problem, ProblemList, ProblemRecord};
use files::FileError;
use hardware_model::{Asked, HardwareModel, ModelSource};
use limits::Limit;
use lunsim::Hardware;
use scenario::{PoseTable, Scenario};
use serde_json::{Value, json};

use crate::kind::{KNOWN, Kind};
use crate::loading::{hardware_model, other_names, path_problems, stage_problems};
use crate::output::{Colour, print, print_json, tell};
use crate::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid check scenarios/*.toml hardware-models/*.toml

A scenario is read with its machine, its ground is made and its path driven over it; nothing is drawn. A file of
differences, with neither `name` nor `base`, is read as an overlay over the ideal machine. What LUNSIM ran on and
cartridges are read too. Exit code 3 if there is any fault.";

/// Read scenarios, hardware models and whatever else is written in TOML, and list every fault.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Check {
    /// Files.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
}

impl Check {
    /// Checks.
    pub fn run(&self, colour: Colour) -> Result<Verdict, Failure> {
        let found = self.files.iter().map(|file| {
            let kind = Kind::of(file);
            let result = match kind {
                Kind::Scenario => check_scenario(file),
                Kind::Model => check_model(file),
                Kind::Overlay => check_overlay(file),
                Kind::Sidecar => Ok(()),
                Kind::Gear => check_gear(file),
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
                if result.is_ok() {
                    print(&format!("{}: {}, no fault\n", file.display(), kind.word()))?;
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

fn check_model(path: &Path) -> Result<(), ProblemList> {
    HardwareModel::read(path, &[], &[]).map(|_| ())
}

/// Differences have no faults by themselves: they are those of the ideal machine under them.
fn check_overlay(path: &Path) -> Result<(), ProblemList> {
    let ideal = ModelSource::BuiltIn("ideal".into());
    HardwareModel::load(&ideal, &[path.to_owned()], &[]).map(|_| ())
}

fn check_gear(path: &Path) -> Result<(), ProblemList> {
    let name = path.display().to_string();
    let of_file = |error: FileError| Problem::of_file(&name, error.to_string());
    let bytes = files::read_all(path, Limit::TextBytes).map_err(of_file)?;
    Hardware::parse(&name, &String::from_utf8_lossy(&bytes)).map(|_| ())
}

fn check_cartridge(path: &Path) -> Result<(), ProblemList> {
    let problem = |error: CartridgeError| Problem::of_file(error.place, error.message);
    of_file(path).map(|_| ()).map_err(|error| problem(error).into())
}

fn of_no_kind(path: &Path) -> ProblemList {
    let title = "no key of any kind of file that is known";
    Problem::of_file(path.display().to_string(), title).expected(KNOWN).into()
}

fn check_scenario(path: &Path) -> Result<(), ProblemList> {
    let name = path.display().to_string();
    let of_file = |title: String| ProblemList::from(Problem::of_file(&name, title));
    let scenario = Scenario::read(path)?;
    let (machine, folder) = (hardware_model(&scenario.machine), path.parent().unwrap_or(Path::new("")));
    let source = ModelSource::find_as(Asked { place: &name, others: &other_names() }, machine, folder)?;
    let model = HardwareModel::load(&source, &[], &[])?;
    let settings = stage::settings(&scenario, &model.model).map_err(|error| {
        of_file(format!("scenario and machine `{}` do not fit together: {error}", scenario.machine))
    })?;
    let stage = stage::build(&scenario, settings).map_err(|error| stage_problems(&name, &error))?;
    let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
    let poses = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, 0..scenario.frames(update));
    poses.map(|_| ()).map_err(|error| path_problems(&error))
}

fn document(file: &Path, kind: Kind, result: &Result<(), ProblemList>) -> Value {
    let problems = result.as_ref().err().into_iter().flat_map(ProblemList::iter).map(|problem| {
        let ProblemRecord { file, line, column, key, title, found, expected, help } = problem.record();
        json!({ "file": file, "line": line, "column": column, "key": key, "title": title, "found": found,
                "expected": expected, "help": help })
    });
    json!({
        "file": file.display().to_string(),
        "kind": kind.word(),
        "ok": result.is_ok(),
        "problems": problems.collect::<Vec<_>>(),
    })
}
