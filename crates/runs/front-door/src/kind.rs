//! What a TOML file is meant to be, by its keys.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use diagnostics::{Problems, TomlFile};
use generator::Row;
use hardware_model::{Asked, HardwareModel, LoadedModel, ModelSource};
use limits::Limit;
use scenario::{Overrides, Scenario};

use crate::expect_followable;
use crate::keys::of_scenario;
use crate::{OpenError, Wishes};

/// What a TOML file is meant to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A scenario of a mission.
    Scenario,
    /// A whole hardware model.
    Model,
    /// Differences to be laid over a hardware model.
    Overlay,
    /// The description beside a bank, which only people read.
    Sidecar,
    /// A landscape of features over a base, which `lunoid terrain` builds.
    Terrain,
    /// What the program of a generator ran on.
    Gear(&'static Row),
    /// Differences to be laid over run parameters and gear of a generator.
    GeneratorOverlay(&'static Row),
    /// A test cartridge: a scene whose answer is known.
    Cartridge,
    /// None of the known kinds.
    Unknown,
}

/// The kinds that are known, each with the keys that it is known by.
pub const KNOWN: &str = "a scenario (title, landscape, path or sun), a hardware model (name or base), differences from \
                         one (a table of its parts), what a generator ran on (computer, recorder, sampler, memory or \
                         beam; with format, differences from it), a cartridge (scene), a landscape (area or feature) or the description of a \
                         bank (content_blake3)";

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
        } else if has(&["area", "feature"]) && !has(&["landscape"]) {
            Self::Terrain
        } else if has(&["title", "landscape", "path", "sun"]) {
            Self::Scenario
        } else if has(&["name", "base"]) {
            Self::Model
        } else if let Some(row) = registry::overlay_owner(&file).filter(|_| has(&["format"])) {
            Self::GeneratorOverlay(row)
        } else if let Some(row) =
            registry::ROWS.iter().find(|row| row.gear.is_some_and(|gear| has(gear.tables)))
        {
            Self::Gear(row)
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
    pub fn word(self) -> String {
        match self {
            Self::Scenario => "scenario".into(),
            Self::Model => "hardware-model".into(),
            Self::Overlay => "overlay over ideal".into(),
            Self::Sidecar => "description of a bank".into(),
            Self::Terrain => "landscape".into(),
            Self::Gear(row) => format!("hardware of {}", row.name),
            Self::GeneratorOverlay(row) => format!("overlay over {}", row.name),
            Self::Cartridge => "cartridge".into(),
            Self::Unknown => "unknown".into(),
        }
    }

    /// One error in place of the faults that a file of another kind has as one of this kind.
    ///
    /// # Errors
    /// If the file is of another kind that is known.
    pub fn expect(self, path: &Path) -> Result<(), OpenError> {
        let found = match Self::told(path) {
            Some(found) if found != self && found != Self::Unknown => found,
            _ => return Ok(()),
        };
        let [found, expected] = [found, self].map(Self::phrase);
        let path = path.display();
        Err(OpenError::Input(format!(
            "{path}: this is {found}, expected {expected}; name a file of that kind"
        )))
    }

    /// Returns the kind as words for a sentence.
    fn phrase(self) -> String {
        match self {
            Self::Scenario => "a scenario".into(),
            Self::Model => "a hardware model (--machine)".into(),
            Self::Overlay => "differences from a hardware model (--overlay)".into(),
            Self::Sidecar => "the description of a bank".into(),
            Self::Terrain => "a landscape (lunoid terrain)".into(),
            Self::Gear(row) => format!("what {} ran on", row.name),
            Self::GeneratorOverlay(row) => format!("differences from what {} draws by (--overlay)", row.name),
            Self::Cartridge => "a cartridge (lunoid cartridge run --folder)".into(),
            Self::Unknown => "a file of no known kind".into(),
        }
    }
}

/// Reads a scenario; run parameters of generators may stand in its file as well.
///
/// # Errors
/// Every fault of the file, or one error if it is of another kind.
pub fn read_scenario(path: &Path) -> Result<Scenario, OpenError> {
    read_scenario_over(path, &Wishes::default())
}

/// Reads a scenario with those of the wishes over it that are keys of scenarios, and over the ground of their bank.
///
/// # Errors
/// As [`read_scenario`], and every fault of the keys.
pub(crate) fn read_scenario_over(path: &Path, wishes: &Wishes) -> Result<Scenario, OpenError> {
    let sets = wishes.set.iter().filter_map(|(key, value)| Some((of_scenario(key)?, value)));
    let sets =
        sets.map(|(key, value)| Ok((key, as_toml(key, value)?))).collect::<Result<Vec<_>, OpenError>>()?;
    let sets: Vec<(&str, &str)> = sets.iter().map(|(key, value)| (*key, value.as_str())).collect();
    let over = Overrides { sets: &sets, bank: wishes.bank.as_deref() };
    let read = Scenario::read_over(path, &registry::parameter_tables(), over);
    read.or_else(|faults| Kind::Scenario.expect(path).and(Err(faults.into())))
}

/// A value of the command line as TOML in one line: one that is no TOML is a word, so that words need no quotes.
fn as_toml(key: &str, value: &str) -> Result<String, OpenError> {
    let is_bare = |part: &str| {
        !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-')
    };
    if !key.split('.').all(is_bare) || value.contains(char::is_control) {
        let set = format!("--set scenario.{key}={value}").escape_debug().to_string();
        return Err(OpenError::Wish(format!(
            "{set}: this is no key with a value in one line; expected one such as scenario.raster.columns=640"
        )));
    }
    // Scenarios have dates in quotes.
    let is_toml = |table: toml::Table| !table.values().any(toml::Value::is_datetime);
    match format!("value = {value}").parse().is_ok_and(is_toml) {
        true => Ok(value.to_owned()),
        false => Ok(toml::Value::from(value).to_string()),
    }
}

/// Reads a hardware model, by name or path, with differences over it.
///
/// # Errors
/// Every fault of the files, parts that nobody can follow, or one error if a file is of another kind. Whether a machine can be built of the
/// model [`expect_drawable`](crate::expect_drawable) says.
pub fn read_model(
    asked: Asked<'_>,
    name: &str,
    folder: &Path,
    overlays: &[PathBuf],
    set: &[(String, String)],
) -> Result<LoadedModel, OpenError> {
    let source = ModelSource::find_as(asked, name, folder)?;
    let loaded = HardwareModel::load(&source, overlays, set).or_else(|faults| {
        if let ModelSource::File(path) = &source {
            Kind::Model.expect(path)?;
        }
        Err(OpenError::from(faults))
    })?;
    expect_followable(&loaded.values)?;
    Ok(loaded)
}

/// Tables of a model, by the one that has all of them.
fn parts_of_a_model() -> BTreeSet<String> {
    let ideal = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]);
    let values = ideal.map_or(Vec::new(), |ideal| ideal.values);
    values.iter().filter_map(|value| Some(value.key.split_once('.')?.0.to_owned())).collect()
}
