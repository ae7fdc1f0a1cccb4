//! Hardware models of a scene: shipped ones, under shipped faults and single settings.

use std::path::PathBuf;

use hardware_model::{BUILT_IN, FAULTS, HardwareModel, ModelSource};
use serde::Deserialize;
use toml::{Table, Value};

/// Hardware models that the answer holds for. Their format is that of hardware model files.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Hardware {
    /// Models that the program carries, by name; the scene is run on each.
    models: Vec<String>,
    /// Faults that the program carries, by name, laid over each model in this order.
    #[serde(default)]
    overlays: Vec<String>,
    /// Tables of a hardware model file, laid over all of these.
    #[serde(default)]
    #[cfg_attr(test, schemars(with = "serde_json::Map<String, serde_json::Value>"))]
    set: Table,
}

impl Hardware {
    /// Each model as it is to be run.
    pub fn load(&self) -> Result<Vec<HardwareModel>, String> {
        if self.models.is_empty() {
            return Err("hardware.models = []: expected at least one model".into());
        }
        known("hardware.models", &self.models, BUILT_IN.map(|(name, _)| name).as_slice())?;
        known("hardware.overlays", &self.overlays, FAULTS.map(|(name, _)| name).as_slice())?;
        let overlays: Vec<PathBuf> = self.overlays.iter().map(PathBuf::from).collect();
        let mut sets = Vec::new();
        flatten(String::new(), &self.set, &mut sets);
        let load = |name: &String| {
            let source = ModelSource::BuiltIn(name.clone());
            let loaded = HardwareModel::load(&source, &overlays, &sets);
            loaded
                .map(|loaded| loaded.model)
                .map_err(|list| format!("hardware: {}", list.render(false).trim_end()))
        };
        self.models.iter().map(load).collect()
    }
}

fn known(key: &str, names: &[String], known: &[&str]) -> Result<(), String> {
    match names.iter().find(|name| !known.contains(&name.as_str())) {
        Some(name) => Err(format!("{key}: no `{name}` is carried; known: {}", known.join(", "))),
        None => Ok(()),
    }
}

/// Every value below a table by its dotted key, as text of TOML.
fn flatten(prefix: String, table: &Table, into: &mut Vec<(String, String)>) {
    for (key, value) in table {
        let key = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
        match value {
            Value::Table(below) => flatten(key, below, into),
            value => into.push((key, value.to_string())),
        }
    }
}
