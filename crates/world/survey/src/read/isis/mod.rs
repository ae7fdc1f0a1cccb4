//! ISIS cubes: a label in text, attached to the samples or in a file of its own (ISIS 8, "Cube format").

mod core;
mod place;
pub mod words;

use std::path::Path;

use landscape::LUNOID_RADIUS;

use super::gate;
use super::label::Label;
use super::opened::Opened;
use super::options::ReadOptions;
use super::samples::Conversion;
use super::words::Decider;
use crate::elevation::Grid;
use crate::error::SurveyError;

/// The object of the samples.
const CORE: &str = "CORE";
/// The group of their number.
const DIMENSIONS: &str = "DIMENSIONS";
/// The group of how they are stored.
const PIXELS: &str = "PIXELS";
/// The group of the bands.
const BAND_BIN: &str = "BANDBIN";
/// The group of their place.
const MAPPING: &str = "MAPPING";

/// Most bytes of a label; those of cubes have some ten thousand.
const LABEL_BYTES: u64 = 1 << 22;

/// Whether a file begins like a cube: `Object = IsisCube`.
pub fn is_cube(start: &[u8]) -> bool {
    let start = String::from_utf8_lossy(start).to_ascii_lowercase();
    let words: String = start.split_whitespace().collect();
    words.starts_with("object=isiscube")
}

/// Opens the core of a cube.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let bytes = gate::front(path, LABEL_BYTES)?;
    let mut decider = Decider::new(path, options);
    let label = Label::of(path, &words::DIALECT, &bytes, &mut decider)?;
    let mut notes = decider.finish()?;
    let file = core::file(&label)?;
    let (raw, band) = core::raw(&label, &file, options)?;
    let (affine, frame) = place::place(&label, options, raw.lines, &mut notes)?;
    let said = core::said(&label, raw.kind, band, frame.sphere().unwrap_or(LUNOID_RADIUS), &mut notes)?;
    let mut sources = vec![path.to_path_buf()];
    sources.extend(Some(file).filter(|file| file != path));
    Ok(Opened {
        grid: Grid { lines: raw.lines, columns: raw.columns, affine, frame },
        path: path.to_path_buf(),
        title: core::of_band(&label, "NAME", band)?.unwrap_or_default(),
        sources,
        notes,
        conversion: Conversion::new(path, options, said)?,
        samples: Box::new(raw),
    })
}
