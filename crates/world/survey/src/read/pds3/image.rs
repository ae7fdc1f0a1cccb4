//! The samples of a PDS3 image.

use std::path::{Path, PathBuf};

use landscape::LUNOID_RADIUS;

use super::{IMAGE, kind, map, special};
use crate::elevation::Grid;
use crate::error::SurveyError;
use crate::read::beside::{in_folder, is_plain};
use crate::read::kind::Kind;
use crate::read::label::{Label, Statement, Value, plain};
use crate::read::opened::Opened;
use crate::read::options::ReadOptions;
use crate::read::raw::Raw;
use crate::read::refusal::check_raster;
use crate::read::samples::{Conversion, Said};
use crate::read::{bands, unit};

/// File and first byte of the image, from the pointer `^IMAGE`.
pub fn locate(label: &Label) -> Result<(PathBuf, u64), SurveyError> {
    let mut pointers = label.statements.iter().filter(|statement| statement.keyword == "^IMAGE");
    let pointer = pointers.next().ok_or_else(|| label.missing("^IMAGE"))?;
    if let Some(second) = pointers.next() {
        return Err(label.wrong(second, "one ^IMAGE in a label"));
    }
    let parts = match &pointer.value {
        Value::List(parts) => parts.as_slice(),
        single => std::slice::from_ref(single),
    };
    let expected = "a file name, a record number, or both";
    let (mut name, mut start) = (None, 0);
    for part in parts {
        let Value::Plain { text, unit } = part else { return Err(label.wrong(pointer, expected)) };
        match (text.parse::<u64>(), unit.as_deref()) {
            (Ok(0), _) => return Err(label.wrong(pointer, "records and bytes counted from 1")),
            (Ok(byte), Some(unit)) if unit.eq_ignore_ascii_case("BYTES") => start = byte - 1,
            (Ok(record), None) => {
                let bytes = record_bytes(label, pointer)?;
                start = (record - 1).checked_mul(bytes).ok_or_else(|| label.wrong(pointer, expected))?;
            }
            (Err(_), None) if name.is_none() => name = Some(text),
            _ => return Err(label.wrong(pointer, expected)),
        }
    }
    let name = name.or_else(|| name_of_file(label, pointer));
    let Some(name) = name else { return Ok((label.path.to_path_buf(), start)) };
    if !is_plain(name) {
        return Err(label.wrong(pointer, "a file in the folder of the label"));
    }
    let found = in_folder(label.path, name)?;
    found
        .map(|file| (file, start))
        .ok_or_else(|| label.wrong(pointer, "a file that is in the folder of the label"))
}

/// Bytes of a record of the file that holds the image: as its own object says, else as the label does.
fn record_bytes(label: &Label, pointer: &Statement) -> Result<u64, SurveyError> {
    let missing = || label.missing("RECORD_BYTES");
    let statement = label.around(pointer, "RECORD_BYTES").ok_or_else(missing)?;
    label.count_of(statement)?.ok_or_else(missing)
}

/// The file that an object around the pointer names. A name at the top of a label is that of the label's own file.
fn name_of_file<'a>(label: &'a Label, pointer: &Statement) -> Option<&'a String> {
    match &label.around(pointer, "FILE_NAME").filter(|statement| !statement.blocks.is_empty())?.value {
        Value::Plain { text, .. } => Some(text),
        Value::List(_) => None,
    }
}

/// Opens band 1, or the chosen band of a band-sequential image.
pub fn open(label: &Label, file: &Path, start: u64, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let bands = label.count(IMAGE, "BANDS")?.unwrap_or(1).max(1) as usize;
    expect_sequential(label, bands)?;
    let band = bands::of_raw(file, options, bands)?;
    let raw = raw(label, file, start, band)?;
    let mut notes = Vec::new();
    let (affine, frame) = map::place(label, options, [raw.lines, raw.columns], &mut notes)?;
    let sphere = frame.sphere().unwrap_or(LUNOID_RADIUS);
    let said = said(label, raw.kind, [band, bands], sphere, &mut notes)?;
    Ok(Opened {
        grid: Grid { lines: raw.lines, columns: raw.columns, affine, frame },
        path: label.path.to_path_buf(),
        title: label.text(IMAGE, "NAME")?.unwrap_or_default().to_string(),
        sources: vec![file.to_path_buf()],
        notes,
        conversion: Conversion::new(label.path, options, said)?,
        samples: Box::new(raw),
    })
}

/// Where the samples of a band stand, if the file is long enough.
fn raw(label: &Label, file: &Path, start: u64, band: usize) -> Result<Raw, SurveyError> {
    let of_image = |keyword: &str| label.count(IMAGE, keyword);
    let needed = |keyword: &str| of_image(keyword)?.ok_or_else(|| label.missing(keyword));
    let size = [needed("LINES")?, needed("LINE_SAMPLES")?];
    check_raster(file, size[0], size[1])?;
    let kind = kind::of(label)?;
    let around = [of_image("LINE_PREFIX_BYTES")?, of_image("LINE_SUFFIX_BYTES")?];
    let [before, behind] = around.map(Option::unwrap_or_default);
    let raw = Raw::lines_of(file, size.map(|count| count as usize), kind, 0);
    let line = raw.block_step.saturating_add(before).saturating_add(behind);
    let of_band = (band as u64).saturating_mul(size[0]).saturating_mul(line);
    let raw = Raw { block_step: line, first: start.saturating_add(of_band).saturating_add(before), ..raw };
    raw.check()?;
    Ok(raw)
}

/// Several bands must stand one behind the other.
fn expect_sequential(label: &Label, bands: usize) -> Result<(), SurveyError> {
    let storage = label.text(IMAGE, "BAND_STORAGE_TYPE")?;
    let is_sequential = storage.is_none_or(|kind| kind.eq_ignore_ascii_case("BAND_SEQUENTIAL"));
    if bands == 1 || is_sequential {
        return Ok(());
    }
    let statement = label.find(IMAGE, "BAND_STORAGE_TYPE");
    Err(statement.map_or_else(|| label.missing("BANDS"), |s| label.wrong(s, "BAND_SEQUENTIAL")))
}

/// What the label says about the stored numbers.
fn said(
    label: &Label,
    kind: Kind,
    band: [usize; 2],
    sphere: f64,
    notes: &mut Vec<String>,
) -> Result<Said, SurveyError> {
    let unit = label.text(IMAGE, "UNIT")?;
    let known = unit.map_or(Some(1.0), unit::length);
    let unknown_unit = known.is_none().then(|| ["label, UNIT".into(), unit.unwrap_or_default().into()]);
    if unit.is_none() {
        notes.push("the label does not name the unit of its heights: metres are assumed".into());
    }
    let metres = known.unwrap_or(1.0);
    // Scale and offset may have a unit of their own.
    let height = |unit: &str| if unit.is_empty() { Some(metres) } else { unit::length(unit) };
    let of_band = |keyword: &str| label.of_band(IMAGE, keyword, band, plain);
    let end = |keywords: [&str; 2], usual: f64| {
        let ends = [of_band(keywords[0])?, of_band(keywords[1])?];
        Ok::<_, SurveyError>(ends.into_iter().flatten().next().unwrap_or(usual))
    };
    let [low, high] = [f64::NEG_INFINITY, f64::INFINITY];
    Ok(Said {
        voids: special::voids(label, kind, notes)?,
        valid: [
            end(["VALID_MINIMUM", "CORE_VALID_MINIMUM"], low)?,
            end(["VALID_MAXIMUM", "CORE_VALID_MAXIMUM"], high)?,
        ],
        stated: [end(["MINIMUM"; 2], low)?, end(["MAXIMUM"; 2], high)?],
        scale: label.of_band(IMAGE, "SCALING_FACTOR", band, height)?.unwrap_or(metres),
        offset: label.of_band(IMAGE, "OFFSET", band, height)?.unwrap_or(0.0),
        unknown_unit,
        sphere,
        stored: kind.stored(),
    })
}
