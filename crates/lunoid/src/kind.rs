//! What a TOML file is meant to be, by its keys.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use diagnostics::{Problems, TomlFile};
use hardware_model::{Asked, HardwareModel, LoadedModel, ModelSource};
use limits::Limit;
use scenario::Scenario;

use crate::Failure;
use crate::lunsim_keys::GEAR;

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
    /// What LUNSIM ran on.
    Gear,
    /// A test cartridge.
    Cartridge,
    /// None of these.
    Unknown,
}

/// The kinds that are known, each with the keys that it is known by.
pub const KNOWN: &str = "a scenario (title, landscape, path or sun), a hardware model (name or base), differences from \
                         one (a table of its parts), what LUNSIM ran on (computer or recorder), a cartridge (scene) or \
                         the description of a bank (content_blake3)";

impl Kind {
    /// What the keys of a file say, if it can be read.
    pub fn told(path: &Path) -> Option<Self> {
        let problems = Problems::new();
        let name = path.display().to_string();
        let file = TomlFile::parse_bytes(&name, &files::read_all(path, Limit::TextBytes).ok()?, &problems)?;
        let has = |keys: &[&str]| keys.iter().any(|key| file.root(&problems).has(key));
        let kind = if has(&["content_blake3"]) {
            Self::Sidecar
        } else if has(&["scene"]) {
            Self::Cartridge
        } else if has(&["title", "landscape", "path", "sun"]) {
            Self::Scenario
        } else if has(&["name", "base"]) {
            Self::Model
        } else if has(&GEAR) {
            Self::Gear
        } else if has(&parts_of_a_model().iter().map(String::as_str).collect::<Vec<_>>()) {
            Self::Overlay
        } else {
            Self::Unknown
        };
        Some(kind)
    }

    /// The same; what cannot be read is taken for a scenario, whose reader says why.
    pub fn of(path: &Path) -> Self {
        Self::told(path).unwrap_or(Self::Scenario)
    }

    /// In a table or a document.
    pub fn word(self) -> &'static str {
        match self {
            Self::Scenario => "scenario",
            Self::Model => "hardware-model",
            Self::Overlay => "overlay over ideal",
            Self::Sidecar => "description of a bank",
            Self::Gear => "hardware of lunsim",
            Self::Cartridge => "cartridge",
            Self::Unknown => "unknown",
        }
    }

    /// One error in place of the faults that a file of another kind has as one of this kind.
    pub fn expect(self, path: &Path) -> Result<(), Failure> {
        let found = match Self::told(path) {
            Some(found) if found != self && found != Self::Unknown => found,
            _ => return Ok(()),
        };
        let [found, expected] = [found, self].map(|kind| match kind {
            Self::Scenario => "a scenario",
            Self::Model => "a hardware model (--machine)",
            Self::Overlay => "differences from a hardware model (--overlay)",
            Self::Sidecar => "the description of a bank",
            Self::Gear => "what LUNSIM ran on",
            Self::Cartridge => "a cartridge (lunoid cartridge run --folder)",
            Self::Unknown => "a file of no known kind",
        });
        let path = path.display();
        Err(Failure::input(format!("{path}: this is {found}, expected {expected}; name a file of that kind")))
    }
}

/// Reads a scenario.
pub fn read_scenario(path: &Path) -> Result<Scenario, Failure> {
    Scenario::read(path).or_else(|faults| Kind::Scenario.expect(path).and(Err(faults.into())))
}

/// Reads a hardware model, by name or path, with differences over it.
pub fn read_model(
    asked: Asked<'_>,
    name: &str,
    folder: &Path,
    overlays: &[PathBuf],
    set: &[(String, String)],
) -> Result<LoadedModel, Failure> {
    let source = ModelSource::find_as(asked, name, folder)?;
    HardwareModel::load(&source, overlays, set).or_else(|faults| {
        if let ModelSource::File(path) = &source {
            Kind::Model.expect(path)?;
        }
        Err(faults.into())
    })
}

/// Tables of a model, by the one that has all of them.
fn parts_of_a_model() -> BTreeSet<String> {
    let ideal = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]);
    let values = ideal.map_or(Vec::new(), |ideal| ideal.values);
    values.iter().filter_map(|value| Some(value.key.split_once('.')?.0.to_owned())).collect()
}
