//! What a run was made from.

use hardware_model::EffectiveValue;

use crate::FileRecord;

/// Files that a run was made from; paths as the user gave them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Inputs {
    /// The scenario file.
    pub scenario: Option<FileRecord>,
    /// Files that it refers to: bank, path.
    pub references: Vec<FileRecord>,
    /// Name of the hardware model.
    pub model: String,
    /// Files of the model, the lowest base first.
    pub model_files: Vec<FileRecord>,
    /// The effective model.
    pub model_values: Vec<EffectiveValue>,
}
