//! A model as read: what it means, and where each value came from.

use std::path::{Path, PathBuf};

use diagnostics::{Origin, ProblemList, Problems};

use crate::layering::layered;
use crate::written::{delays_as_written, model};
use crate::{HardwareModel, ModelSource};

/// A model and the record of its reading.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedModel {
    /// Hardware model that the file means.
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
    /// The value as written; the list of delays in one line.
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
            let origins = layered.layers.origins().into_iter();
            let values = origins.map(|(key, origin)| EffectiveValue::new(key, &origin, &model)).collect();
            Some(LoadedModel { model, values, files: layered.files })
        });
        problems.resolve(loaded)
    }
}

impl EffectiveValue {
    fn new(key: String, origin: &Origin, model: &HardwareModel) -> Self {
        let value = match key.as_str() {
            // May be spread over many tables of a file.
            "loader.delay" => delays_as_written(&model.loader.delays),
            _ => origin.text.clone(),
        };
        Self { key, value, origin: origin.to_string() }
    }
}

impl LoadedModel {
    /// The effective model as text, one line a value, with the place that it came from. The text is itself a
    /// model file, complete and without base.
    pub fn effective(&self) -> String {
        let line = |value: &EffectiveValue| {
            let setting = format!("{} = {}", value.key, value.value);
            format!("{setting:40} # {}\n", value.origin)
        };
        self.values.iter().filter(|value| value.key != "base").map(line).collect()
    }
}
