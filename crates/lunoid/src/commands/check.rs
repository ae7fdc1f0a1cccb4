//! `lunoid check`: scenarios and hardware models, every fault of each.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::Args;
use diagnostics::{Problem, ProblemList, ProblemRecord, Problems, TomlFile};
use hardware_model::{HardwareModel, ModelSource};
use limits::Limit;
use scenario::{PoseTable, Scenario};
use serde_json::{Value, json};

use crate::loading::{hardware_model, stage_problems};
use crate::output::{Colour, print, print_json, tell};
use crate::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid check scenarios/*.toml hardware-models/*.toml

A scenario is read with its machine, its ground is made and its path driven over it; nothing is drawn. A file of
differences, with neither `name` nor `base`, is read as an overlay over the ideal machine. Exit code 3 if there is any
fault.";

/// Read scenarios and hardware models and list every fault.
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

/// What a TOML file is meant to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A scenario.
    Scenario,
    /// A hardware model.
    Model,
    /// Differences to be laid over a hardware model.
    Overlay,
    /// The description beside a bank, which only people read.
    Sidecar,
}

impl Kind {
    /// What the keys of a file say; what is no TOML is taken for a scenario, whose reader says why not.
    pub fn of(path: &Path) -> Self {
        let problems = Problems::new();
        let name = path.display().to_string();
        let file = files::read_all(path, Limit::TextBytes).ok();
        let file = file.and_then(|bytes| TomlFile::parse_bytes(&name, &bytes, &problems));
        let has = |keys: &[&str]| {
            file.as_ref().is_some_and(|file| keys.iter().any(|key| file.root(&problems).has(key)))
        };
        if has(&["content_blake3"]) {
            Self::Sidecar
        } else if has(&["title", "landscape", "path", "sun"]) {
            Self::Scenario
        } else if has(&["name", "base"]) {
            Self::Model
        } else if has(&parts_of_a_model().iter().map(String::as_str).collect::<Vec<_>>()) {
            Self::Overlay
        } else {
            Self::Scenario
        }
    }

    fn word(self) -> &'static str {
        match self {
            Self::Scenario => "scenario",
            Self::Model => "hardware-model",
            Self::Overlay => "overlay over ideal",
            Self::Sidecar => "description of a bank",
        }
    }
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

/// Tables of a model, by the one that has all of them.
fn parts_of_a_model() -> BTreeSet<String> {
    let ideal = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]);
    let values = ideal.map_or(Vec::new(), |ideal| ideal.values);
    values.iter().filter_map(|value| Some(value.key.split_once('.')?.0.to_owned())).collect()
}

fn check_scenario(path: &Path) -> Result<(), ProblemList> {
    let name = path.display().to_string();
    let of_file = |title: String| ProblemList::from(Problem::of_file(&name, title));
    let scenario = Scenario::read(path)?;
    let source =
        ModelSource::find(hardware_model(&scenario.machine), path.parent().unwrap_or(Path::new("")))?;
    let model = HardwareModel::load(&source, &[], &[])?;
    let settings = stage::settings(&scenario, &model.model).map_err(|error| {
        of_file(format!("scenario and machine `{}` do not fit together: {error}", scenario.machine))
    })?;
    let stage = stage::build(&scenario, settings).map_err(|error| stage_problems(&name, &error))?;
    let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
    let poses = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, 0..scenario.frames(update));
    poses.map(|_| ()).map_err(|error| of_file(format!("the path cannot be driven: {error}")))
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
