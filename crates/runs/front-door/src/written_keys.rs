//! Everything that was written and asked for, by its keys: what a person compares when two runs differ.

use std::collections::BTreeMap;

use limits::Limit;
use toml::{Table, Value};

use crate::overlays::of_generators;
use crate::{OpenError, Opened};

impl Opened {
    /// Values as written: `machine.KEY` of the effective model, `scenario.KEY` of the scenario's file, `asked.KEY` of the command.
    /// Items of a list have their number: `scenario.path.keyframes[1].x_m`.
    ///
    /// # Errors
    /// If the scenario can no longer be read.
    pub fn keys(&self) -> Result<BTreeMap<String, String>, OpenError> {
        let values = self.inputs.model_values.iter();
        let mut keys: BTreeMap<String, String> =
            values.map(|value| (format!("machine.{}", value.key), value.value.clone())).collect();
        let text = files::read_all(&self.path, Limit::TextBytes)?;
        let scenario: Table = String::from_utf8_lossy(&text).parse().unwrap_or_default();
        flatten("scenario", &Value::Table(scenario), &mut keys);
        for overlay in of_generators(&self.wishes)? {
            let tables = overlay.text.parse().unwrap_or_default();
            flatten("asked", &Value::Table(tables), &mut keys);
        }
        keys.remove("asked.format");
        self.ask(&mut keys);
        Ok(keys)
    }

    /// What the command asks for beside the model's keys.
    fn ask(&self, keys: &mut BTreeMap<String, String>) {
        let wishes = &self.wishes;
        let of_generator: Vec<_> =
            wishes.set.iter().filter(|(key, _)| !keys.contains_key(&format!("machine.{key}"))).collect();
        keys.extend(of_generator.into_iter().map(|(key, value)| (format!("asked.{key}"), value.clone())));
        let asked = [
            ("bank", wishes.bank.as_ref().map(|bank| bank.display().to_string())),
            ("sweeps", wishes.sweeps.map(|count| count.to_string())),
            ("samples", wishes.samples.map(|count| count.to_string())),
        ];
        let told = asked.into_iter().filter_map(|(key, value)| Some((format!("asked.{key}"), value?)));
        keys.extend(told);
    }
}

fn flatten(place: &str, value: &Value, keys: &mut BTreeMap<String, String>) {
    match value {
        Value::Table(table) => {
            table.iter().for_each(|(key, value)| flatten(&format!("{place}.{key}"), value, keys));
        }
        Value::Array(items) if items.iter().any(Value::is_table) => {
            for (number, item) in items.iter().enumerate() {
                flatten(&format!("{place}[{number}]"), item, keys);
            }
        }
        other => drop(keys.insert(place.to_owned(), other.to_string())),
    }
}
