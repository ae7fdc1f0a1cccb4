//! The core of a cube: where its samples stand, and what they mean.

use std::path::{Path, PathBuf};

use super::{BAND_BIN, CORE, DIMENSIONS, PIXELS};
use crate::error::SurveyError;
use crate::read::beside::{in_folder, is_plain};
use crate::read::kind::Kind;
use crate::read::label::{Label, Value, is_nothing, plain};
use crate::read::options::ReadOptions;
use crate::read::raw::Raw;
use crate::read::refusal::check_raster;
use crate::read::samples::Said;
use crate::read::{bands, unit};

/// The file of the samples: that of the label, or one in its folder.
pub fn file(label: &Label) -> Result<PathBuf, SurveyError> {
    let Some(pointer) = label.find(CORE, "^CORE") else { return Ok(label.path.to_path_buf()) };
    let name = label.text(CORE, "^CORE")?.unwrap_or_default();
    let found = if is_plain(name) { in_folder(label.path, name)? } else { None };
    found.ok_or_else(|| label.wrong(pointer, "a file that is in the folder of the label"))
}

/// The samples of the only band or of the chosen one, with that band, from 0, and how many there are.
pub fn raw(label: &Label, file: &Path, options: &ReadOptions) -> Result<(Raw, [usize; 2]), SurveyError> {
    let needed = |object: &str, keyword: &str| {
        let missing = || label.missing(keyword);
        label.count(object, keyword)?.ok_or_else(missing)
    };
    let [lines, columns] = [needed(DIMENSIONS, "LINES")?, needed(DIMENSIONS, "SAMPLES")?];
    check_raster(file, lines, columns)?;
    let bands = label.count(DIMENSIONS, "BANDS")?.unwrap_or(1) as usize;
    let band = bands::of_raw(file, options, bands)?;
    let kind = kind(label)?;
    let start = needed(CORE, "STARTBYTE")?;
    if let Some(statement) = label.find(CORE, "STARTBYTE").filter(|_| start == 0) {
        return Err(label.wrong(statement, "bytes counted from 1"));
    }
    let block = block(label, columns)?;
    let blocks = lines.div_ceil(block[0]).saturating_mul(columns.div_ceil(block[1]));
    let sample_step = kind.bytes as u64;
    let block_step = block[0].saturating_mul(block[1]).saturating_mul(sample_step);
    let before = blocks.saturating_mul(block_step).saturating_mul(band as u64);
    let raw = Raw {
        path: file.to_path_buf(),
        lines: lines as usize,
        columns: columns as usize,
        kind,
        block: block.map(|size| size as usize),
        first: (start - 1).saturating_add(before),
        block_step,
        sample_step,
    };
    raw.check()?;
    Ok((raw, [band, bands]))
}

/// Lines and samples of a block: a line, or a tile.
fn block(label: &Label, columns: u64) -> Result<[u64; 2], SurveyError> {
    let format = label.find(CORE, "FORMAT").ok_or_else(|| label.missing("FORMAT"))?;
    match label.text(CORE, "FORMAT")?.unwrap_or_default().to_ascii_uppercase().as_str() {
        "BANDSEQUENTIAL" => Ok([1, columns]),
        "TILE" => {
            let size = |keyword: &str| {
                let found = label.count(CORE, keyword)?;
                found.filter(|size| *size > 0).ok_or_else(|| label.missing(&format!("{keyword} above 0")))
            };
            Ok([size("TILELINES")?, size("TILESAMPLES")?])
        }
        _ => Err(label.wrong(format, "BandSequential or Tile")),
    }
}

fn kind(label: &Label) -> Result<Kind, SurveyError> {
    let order = match label.text(PIXELS, "BYTEORDER")?.unwrap_or("Lsb").to_ascii_uppercase().as_str() {
        "LSB" => Some(true),
        "MSB" => Some(false),
        _ => None,
    };
    let little = match (order, label.find(PIXELS, "BYTEORDER")) {
        (None, Some(statement)) => return Err(label.wrong(statement, "Lsb or Msb")),
        (order, _) => order.unwrap_or(true),
    };
    let kind = label.find(PIXELS, "TYPE").ok_or_else(|| label.missing("TYPE"))?;
    Ok(match label.text(PIXELS, "TYPE")?.unwrap_or_default().to_ascii_uppercase().as_str() {
        "UNSIGNEDBYTE" => Kind::integer(1, false, little),
        "UNSIGNEDWORD" => Kind::integer(2, false, little),
        "SIGNEDWORD" => Kind::integer(2, true, little),
        "UNSIGNEDINTEGER" => Kind::integer(4, false, little),
        "SIGNEDINTEGER" => Kind::integer(4, true, little),
        "REAL" => Kind::real(4, little),
        _ => {
            let expected = "UnsignedByte, UnsignedWord, SignedWord, UnsignedInteger, SignedInteger or Real";
            return Err(label.wrong(kind, expected));
        }
    })
}

/// Least and greatest stored number of a kind that is no special pixel: null, or a saturation of the instrument or of the
/// representation (ISIS, SpecialPixel.h).
fn valid(kind: Kind) -> [f64; 2] {
    match (kind.real, kind.bytes, kind.signed) {
        (true, _, _) => [f64::from(f32::from_bits(0xff7f_fffa)), f64::INFINITY],
        (_, 1, _) => [1.0, 254.0],
        (_, 2, true) => [-32_752.0, 32_767.0],
        (_, 2, false) => [3.0, 65_522.0],
        (_, _, true) => [-8_388_614.0, 2_147_483_647.0],
        (_, _, false) => [3.0, 4_294_967_282.0],
    }
}

/// Ranges of stored numbers that are special pixels.
fn special(kind: Kind) -> Vec<[f64; 2]> {
    let [low, high] = valid(kind);
    // Numbers beside the ends; special pixels of signed integers stand between the end and the lowest heights.
    let below = match (kind.real, kind.bytes, kind.signed) {
        (true, _, _) => [f64::NEG_INFINITY, f64::from(f32::from_bits(0xff7f_fffb))],
        (false, 4, true) => [-8_388_613.0, -8_388_609.0],
        _ => [f64::NEG_INFINITY, low - 1.0],
    };
    let above =
        (high < f64::INFINITY && !(kind.signed && kind.bytes > 1)).then_some([high + 1.0, f64::INFINITY]);
    [below].into_iter().chain(above).collect()
}

/// A word of the group of bands: one for all, or one for each.
pub fn of_band(
    label: &Label,
    keyword: &str,
    [band, bands]: [usize; 2],
) -> Result<Option<String>, SurveyError> {
    let Some(statement) = label.find(BAND_BIN, keyword) else { return Ok(None) };
    let value = match &statement.value {
        Value::List(values) if values.len() == bands => &values[band],
        Value::List(_) => return Err(label.wrong(statement, "one word, or one for each band")),
        value => value,
    };
    Ok(Some(value.text()).filter(|text| !is_nothing(text)))
}

/// What the label says about the stored numbers.
pub fn said(
    label: &Label,
    kind: Kind,
    band: [usize; 2],
    sphere: f64,
    notes: &mut Vec<String>,
) -> Result<Said, SurveyError> {
    let unit = match of_band(label, "UNIT", band)? {
        Some(unit) => Some(unit),
        None => of_band(label, "UNITS", band)?,
    };
    let known = unit.as_deref().map_or(Some(1.0), unit::length);
    if unit.is_none() {
        notes.push("the label does not name the unit of its heights: metres are assumed".into());
    }
    let metres = known.unwrap_or(1.0);
    Ok(Said {
        voids: special(kind),
        scale: label.number(PIXELS, "MULTIPLIER", plain)?.unwrap_or(1.0) * metres,
        offset: label.number(PIXELS, "BASE", plain)?.unwrap_or(0.0) * metres,
        unknown_unit: known.is_none().then(|| ["label, BandBin, Unit".into(), unit.unwrap_or_default()]),
        sphere,
        stored: kind.stored(),
        ..Said::default()
    })
}

#[cfg(test)]
mod tests {
    use super::{Kind, special};

    fn is_special(kind: Kind, stored: f64) -> bool {
        special(kind).iter().any(|[low, high]| (*low..=*high).contains(&stored))
    }

    #[test]
    fn special_pixels_of_all_kinds() {
        let word = |signed| Kind::integer(2, signed, true);
        let long = |signed| Kind::integer(4, signed, true);
        let real = |bits: u32| f64::from(f32::from_bits(bits));
        for (kind, marks, heights) in [
            (Kind::integer(1, false, true), vec![0.0, 255.0], vec![1.0, 254.0]),
            (
                word(true),
                vec![-32768.0, -32767.0, -32766.0, -32765.0, -32764.0],
                vec![-32752.0, 0.0, 32767.0],
            ),
            (word(false), vec![0.0, 1.0, 2.0, 65534.0, 65535.0], vec![3.0, 65522.0]),
            (
                long(true),
                (-8_388_613..=-8_388_609).map(f64::from).collect(),
                vec![-8_388_614.0, -8_388_608.0, 2e9],
            ),
            (long(false), vec![0.0, 1.0, 2.0, 4_294_967_294.0, 4_294_967_295.0], vec![3.0, 4_294_967_282.0]),
            (
                Kind::real(4, true),
                vec![
                    real(0xff7f_fffb),
                    real(0xff7f_fffc),
                    real(0xff7f_fffd),
                    real(0xff7f_fffe),
                    real(0xff7f_ffff),
                ],
                vec![real(0xff7f_fffa), 0.0, -1e30],
            ),
        ] {
            assert!(marks.iter().all(|mark| is_special(kind, *mark)), "{kind:?}");
            assert!(heights.iter().all(|height| !is_special(kind, *height)), "{kind:?}");
        }
    }
}
