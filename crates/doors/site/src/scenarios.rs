//! The scenarios that ship, with the files that they name.

use std::fs;
use std::path::{Path, PathBuf};

use front_door::{Opened, Wishes, open};
use serde_json::Value;

use crate::error::SiteError;

/// Folder of the scenarios in the repository and in the site.
pub const FOLDER: &str = "scenarios";

/// Scenarios that can be opened, and those that cannot.
#[derive(Debug, Default)]
pub struct Shipped {
    /// Files of the scenarios, from the workspace on, without repetition.
    pub files: Vec<PathBuf>,
    /// What `scenarios.json` has of each.
    pub rows: Vec<Value>,
    /// Names of those that are left out, each with the reason.
    pub left_out: Vec<(String, String)>,
}

/// The scenarios of `workspace`, by name. Those that need a file that does not ship are left out.
pub fn shipped(workspace: &Path) -> Result<Shipped, SiteError> {
    let mut shipped = Shipped::default();
    for path in scenario_files(workspace)? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match open(&path, &Wishes::default()) {
            Ok(opened) => shipped.add(workspace, &name, &path, &opened),
            Err(error) => shipped.left_out.push((name, error.to_string())),
        }
    }
    shipped.files.sort();
    shipped.files.dedup();
    Ok(shipped)
}

fn scenario_files(workspace: &Path) -> Result<Vec<PathBuf>, SiteError> {
    let folder = workspace.join(FOLDER);
    let failed = |source| SiteError::System { path: folder.clone(), doing: "list the folder", source };
    let entries = fs::read_dir(&folder).map_err(failed)?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>();
    let mut paths = paths.map_err(failed)?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    Ok(paths)
}

impl Shipped {
    fn add(&mut self, workspace: &Path, name: &str, path: &Path, opened: &Opened) {
        let named = opened.scenario.files().into_iter().map(Path::to_owned);
        let mut files: Vec<PathBuf> = [path.to_owned()].into_iter().chain(named).collect();
        files.iter_mut().for_each(|file| *file = file.strip_prefix(workspace).unwrap_or(file).to_owned());
        files.sort();
        files.dedup();
        let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
        self.rows.push(site::row(name, &format!("{FOLDER}/{name}.toml"), opened, &names));
        self.files.extend(files);
    }
}
