//! Overlays that are asked for: those of the hardware model, and those of a generator.

use std::path::{Path, PathBuf};

use diagnostics::{Problems, TomlFile};
use generator::Row;
use hardware_model::{EffectiveValue, LoadedModel, ModelSource};
use limits::Limit;

use crate::keys::{Decides, decides};
use crate::{OpenError, Wishes};

/// An overlay over run parameters and gear of a generator.
pub(crate) struct GeneratorOverlay {
    /// As it was asked for.
    pub asked: PathBuf,
    /// Row of the generator.
    pub row: &'static Row,
    /// Tables that it sets.
    pub file: TomlFile,
    /// Text of the file.
    pub text: String,
}

impl GeneratorOverlay {
    /// The overlay of a generator that a path or a name of the command line means; `None` if it is none of a generator.
    fn of(asked: &Path) -> Result<Option<Self>, OpenError> {
        let name = asked.to_string_lossy();
        let of = |row: &'static Row, name: &str, text: &str| -> Result<Option<Self>, OpenError> {
            let file = registry::overlay(row, name, text)?;
            Ok(Some(Self { asked: asked.to_owned(), row, file, text: text.to_owned() }))
        };
        if files::is_file(asked) {
            let text = files::read_all(asked, Limit::TextBytes)?;
            let parsed = TomlFile::parse_bytes(&name, &text, &Problems::new());
            let row = parsed.as_ref().and_then(registry::overlay_owner);
            return row.map_or(Ok(None), |row| of(row, &name, &String::from_utf8_lossy(&text)));
        }
        let carried = registry::ROWS.iter().find_map(|row| Some((*row, row.fault(&name)?)));
        carried.map_or(Ok(None), |(row, text)| {
            of(row, &format!("built-in faults/{}/{name}.toml", row.name), text)
        })
    }
}

/// The overlays of generators among those of `wishes`.
pub(crate) fn of_generators(wishes: &Wishes) -> Result<Vec<GeneratorOverlay>, OpenError> {
    let found = wishes.overlays.iter().map(|asked| GeneratorOverlay::of(asked));
    Ok(found.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// The others: those of the hardware model.
pub(crate) fn of_model(wishes: &Wishes) -> Result<Vec<PathBuf>, OpenError> {
    let generators = of_generators(wishes)?;
    let is_of_model = |asked: &&PathBuf| !generators.iter().any(|overlay| overlay.asked == **asked);
    Ok(wishes.overlays.iter().filter(is_of_model).cloned().collect())
}

/// Refuses the overlay of a generator that does not draw; `drawn_by` is who does.
pub(crate) fn expect_of(row: Option<&Row>, drawn_by: &str, wishes: &Wishes) -> Result<(), OpenError> {
    match of_generators(wishes)?.iter().find(|overlay| row != Some(overlay.row)) {
        None => Ok(()),
        Some(GeneratorOverlay { asked, row, .. }) => Err(OpenError::Wish(format!(
            "--overlay {}: these are differences of {}, and {drawn_by} draws; leave it out, or give --machine {}",
            asked.display(),
            row.name,
            row.name
        ))),
    }
}

/// Refuses an overlay of the hardware model that sets a part which the generator of `row` does not have; raster, range and laws are
/// those of any generator.
pub(crate) fn expect_no_parts(row: &Row, model: &LoadedModel, wishes: &Wishes) -> Result<(), OpenError> {
    for asked in of_model(wishes)? {
        let name = ModelSource::overlay(&asked).name();
        let is_part = |value: &&EffectiveValue| {
            let is_of_overlay = value.origin.rsplit_once(':').is_some_and(|(file, _)| file == name);
            is_of_overlay && value.key != "format" && matches!(decides(&value.key), Decides::Model)
        };
        if let Some(EffectiveValue { key, origin, .. }) = model.values.iter().find(is_part) {
            return Err(OpenError::Wish(format!(
                "--overlay {}: {origin} sets `{key}`, and {} has no such part; leave the overlay out, or give --machine a hardware model",
                asked.display(),
                row.name
            )));
        }
    }
    Ok(())
}
