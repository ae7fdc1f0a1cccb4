//! The home of a session in a page: scenarios are given files.

use std::path::PathBuf;

use diagnostics::Problem;
use drive::{Drive, DriveError, Wishes};
use files::GIVEN;
use loop_protocol::{Home, Opening, Plane};

/// A home without a disk. Names of scenarios, machines and overlays mean given files where there are such.
#[derive(Debug, Default)]
pub struct Page;

/// The path in memory of a file that a page calls `name`.
fn given(name: &str) -> PathBuf {
    if name.starts_with(GIVEN) { PathBuf::from(name) } else { PathBuf::from(format!("{GIVEN}{name}")) }
}

/// The given file of a name, or the name itself where there is none: then the program may carry it.
fn given_or_carried(name: String) -> String {
    let path = given(&name);
    if files::is_file(&path) { path.display().to_string() } else { name }
}

impl Home for Page {
    fn give(&mut self, planes: &[Plane]) -> Result<(), DriveError> {
        for plane in planes {
            let taken = files::give(given(plane.name()), plane.bytes());
            taken.map_err(|error| DriveError::from(Problem::of_file(plane.name(), error.to_string())))?;
        }
        Ok(())
    }

    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        let Some(scenario) = &asked.scenario else {
            let problem = Problem::of_file("request", "no scenario is named").key("scenario");
            return Err(problem.expected("the name of a given file, as scenarios/first-light.toml").into());
        };
        let opening = Opening {
            machine: asked.machine.clone().map(given_or_carried),
            overlays: asked.overlays.iter().cloned().map(given_or_carried).collect(),
            ..asked.clone()
        };
        Drive::open(&given(scenario), &opening.over(&Wishes::default()), 1)
    }
}
