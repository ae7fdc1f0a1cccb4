//! Which pictures are drawn.

use std::path::PathBuf;

use generator::{Role, Row};
use hardware_model::{BUILT_IN, Economy, FAULTS};
use lunoid_tests::shipped::folder;

/// Scenarios that are also drawn under every economy and every fault.
const THOROUGH: [&str; 2] = ["craters", "full-drive"];

/// Generators of the registry that are drawn, in the order of the record.
static GUESTS: [&Row; 6] =
    [&lunsim::ROW, &exact::ROW, &sampled::ROW, &lod_mesh::ROW, &panels::ROW, &smooth_faces::ROW];

/// Who draws, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// A hardware model, by name.
    Model(&'static str),
    /// The scenario's own machine with this economy.
    Economy(Economy),
    /// The scenario's own machine with this fault over it, by name and text.
    Fault(&'static str),
    /// A generator of the registry.
    Guest(&'static Row),
}

/// A scenario under something that draws it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Case {
    /// Name of the scenario.
    pub scenario: String,
    /// What draws the scenario.
    pub by: By,
}

impl Case {
    /// Its name in the record, without frames.
    pub fn name(&self) -> String {
        let by = match self.by {
            By::Model(name) => name.to_owned(),
            By::Economy(Economy::Lossless) => "lossless".into(),
            By::Economy(Economy::Normal) => "normal".into(),
            By::Economy(_) => "preview".into(),
            By::Fault(name) => format!("fault {name}"),
            By::Guest(row) => row.name.into(),
        };
        format!("{}, {by}", self.scenario)
    }

    /// The first, the middle and the last frame of `count`; of the judge, which is slow, the first alone.
    pub fn frames(&self, count: u64) -> Vec<u64> {
        match self.by {
            By::Guest(row) if row.role == Role::Judge => vec![0],
            _ => vec![0, count / 2, count - 1],
        }
    }

    /// Returns the path of the scenario's file.
    pub fn file(&self) -> PathBuf {
        folder().join(&self.scenario).with_extension("toml")
    }
}

/// All of them, scenario by scenario.
pub fn cases() -> Result<Vec<Case>, String> {
    let entries = std::fs::read_dir(folder()).map_err(|error| format!("{}: {error}", folder().display()))?;
    let mut names: Vec<String> = entries
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned()))
        .collect();
    names.sort();
    Ok(names.into_iter().flat_map(of_scenario).collect())
}

fn of_scenario(scenario: String) -> Vec<Case> {
    let models = BUILT_IN.iter().map(|(name, _)| By::Model(name));
    let mut all: Vec<By> = models.chain(GUESTS.iter().map(|row| By::Guest(row))).collect();
    all.push(By::Economy(Economy::Normal));
    if THOROUGH.contains(&scenario.as_str()) {
        all.extend([Economy::Lossless, Economy::Instants(1)].map(By::Economy));
        all.extend(FAULTS.iter().map(|(name, ..)| By::Fault(name)));
    }
    all.into_iter().map(|by| Case { scenario: scenario.clone(), by }).collect()
}
