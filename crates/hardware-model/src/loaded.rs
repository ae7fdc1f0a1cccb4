//! A model as read: what it means, and where each value came from.

use std::path::{Path, PathBuf};

use diagnostics::{ProblemList, Problems};

use crate::layering::layered;
use crate::written::model;
use crate::{HardwareModel, ModelSource};

/// A model and the record of its reading.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedModel {
    /// What it means.
    pub model: HardwareModel,
    /// Every value that was read, in alphabetical order of keys.
    pub values: Vec<EffectiveValue>,
    /// Files that were read, the lowest base first; built-in models have none.
    pub files: Vec<PathBuf>,
}

/// One value of a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EffectiveValue {
    /// Dotted key, as `raster.sweeps`.
    pub key: String,
    /// The value as written.
    pub value: String,
    /// File and line, as `hardware-models/ideal.toml:8`.
    pub origin: String,
}

impl HardwareModel {
    /// The model that is ideal in every part; it is always there.
    pub fn ideal() -> Self {
        let source = ModelSource::BuiltIn("ideal".into());
        Self::load(&source, &[], &[]).expect("a test reads the built-in model").model
    }

    /// Reads a model file, its bases, overlays (each over those before it) and single settings `(key, value)`,
    /// which have the last word.
    ///
    /// # Errors
    /// Every fault of all layers.
    pub fn read(
        path: &Path,
        overlays: &[PathBuf],
        sets: &[(String, String)],
    ) -> Result<LoadedModel, ProblemList> {
        Self::load(&ModelSource::File(path.to_owned()), overlays, sets)
    }

    /// As [`read`](Self::read), from wherever the model is.
    ///
    /// # Errors
    /// Every fault of all layers.
    pub fn load(
        source: &ModelSource,
        overlays: &[PathBuf],
        sets: &[(String, String)],
    ) -> Result<LoadedModel, ProblemList> {
        let problems = Problems::new();
        let loaded = layered(source, overlays, sets, &problems).and_then(|layered| {
            let model = model(&layered.layers.root(&problems), layered.name)?;
            let values = layered.layers.origins().into_iter().map(|(key, origin)| EffectiveValue {
                key,
                value: origin.text.clone(),
                origin: origin.to_string(),
            });
            Some(LoadedModel { model, values: values.collect(), files: layered.files })
        });
        problems.resolve(loaded)
    }
}

impl LoadedModel {
    /// The effective model as text: one line a value, with the place that it came from.
    pub fn effective(&self) -> String {
        let width =
            self.values.iter().map(|value| value.key.len() + value.value.len()).max().unwrap_or(0) + 3;
        let line = |value: &EffectiveValue| {
            let setting = format!("{} = {}", value.key, value.value);
            format!("{setting:width$}  # {}\n", value.origin)
        };
        self.values.iter().map(line).collect()
    }
}
