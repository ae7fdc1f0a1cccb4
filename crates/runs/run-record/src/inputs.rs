//! What a run was made from.

use hardware_model::EffectiveValue;
use serde::{Deserialize, Serialize};

use crate::FileRecord;

/// Files that a run was made from; paths as the user gave them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Inputs {
    /// The scenario file, if there is one.
    pub scenario: Option<FileRecord>,
    /// Files that it refers to: bank, path.
    pub references: Vec<FileRecord>,
    /// Name of the hardware model.
    pub model: String,
    /// Files of the model, the lowest base first.
    pub model_files: Vec<FileRecord>,
    /// Values of the effective model, each with its origin.
    pub model_values: Vec<EffectiveValue>,
}

/// The hardware model of a run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModelRecord {
    /// Name of the model.
    pub name: String,
    /// Its files, the lowest base first.
    pub files: Vec<FileRecord>,
    /// Values of the model, each with its origin.
    pub values: Vec<ModelValue>,
}

/// A value of a hardware model.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModelValue {
    /// Dotted key of the value.
    pub key: String,
    /// The value, as it is written in TOML.
    pub value: String,
    /// File and line that it came from.
    pub origin: String,
}

impl From<&Inputs> for ModelRecord {
    fn from(inputs: &Inputs) -> Self {
        let value = |value: &EffectiveValue| ModelValue {
            key: value.key.clone(),
            value: value.value.clone(),
            origin: value.origin.clone(),
        };
        Self {
            name: inputs.model.clone(),
            files: inputs.model_files.clone(),
            values: inputs.model_values.iter().map(value).collect(),
        }
    }
}
