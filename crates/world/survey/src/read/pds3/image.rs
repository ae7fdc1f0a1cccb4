//! The samples of a PDS3 image.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Component, Path, PathBuf};

use super::label::Value;
use super::{Label, in_folder, map};
use crate::elevation::Elevation;
use crate::error::SurveyError;
use crate::read::samples::Conversion;
use crate::read::{ReadOptions, check_raster};

/// File and first byte of the image, from the pointer `^IMAGE`.
pub fn locate(label: &Label) -> Result<(PathBuf, u64), SurveyError> {
    let pointer = label.find("", "^IMAGE").ok_or_else(|| label.missing("^IMAGE"))?;
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
                let bytes = label.count("", "RECORD_BYTES")?.ok_or_else(|| label.missing("RECORD_BYTES"))?;
                start = (record - 1).checked_mul(bytes).ok_or_else(|| label.wrong(pointer, expected))?;
            }
            (Err(_), None) if name.is_none() => name = Some(text),
            _ => return Err(label.wrong(pointer, expected)),
        }
    }
    let Some(name) = name else { return Ok((label.path.to_path_buf(), start)) };
    // A label may come from anywhere: it must not choose files outside its folder.
    let plain = Path::new(name).components().eq([Component::Normal(name.as_ref())]);
    if !plain || name.contains(['/', '\\', ':']) {
        return Err(label.wrong(pointer, "a file in the folder of the label"));
    }
    let found = in_folder(label.path, name)?;
    found
        .map(|file| (file, start))
        .ok_or_else(|| label.wrong(pointer, "a file that is in the folder of the label"))
}

/// Reads band 1, or the chosen band of a band-sequential image.
pub fn read(label: &Label, file: &Path, start: u64, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let of_image = |keyword: &str| label.count("IMAGE", keyword);
    let needed = |keyword: &str| of_image(keyword)?.ok_or_else(|| label.missing(keyword));
    let (lines, columns) = (needed("LINES")?, needed("LINE_SAMPLES")?);
    let count = check_raster(file, lines, columns)?;
    let kind = Kind::of(label)?;
    let prefix = of_image("LINE_PREFIX_BYTES")?.unwrap_or(0);
    let suffix = of_image("LINE_SUFFIX_BYTES")?.unwrap_or(0);
    let band = chosen_band(label, file, options)?;

    let line_bytes =
        columns.checked_mul(kind.bytes as u64).and_then(|n| n.checked_add(prefix)?.checked_add(suffix));
    let line_bytes = line_bytes.ok_or_else(|| label.missing("LINE_SAMPLES that can be counted"))?;
    let before = (band as u64).saturating_mul(lines).saturating_mul(line_bytes).saturating_add(start);
    let expected = lines.saturating_mul(line_bytes).saturating_add(before);
    let failed = |source| SurveyError::Read { path: file.to_path_buf(), source };
    let mut source = File::open(file).map_err(failed)?;
    let found = source.metadata().map_err(failed)?.len();
    if found < expected {
        let place = format!("image of {lines} lines of {line_bytes} bytes from byte {before}");
        return Err(SurveyError::Truncated { path: file.to_path_buf(), place, found, expected });
    }

    let conversion = conversion(label, options, kind)?;
    source.seek(SeekFrom::Start(before)).map_err(failed)?;
    let (mut source, mut line) = (BufReader::new(source), vec![0; line_bytes as usize]);
    let mut heights = Vec::with_capacity(count);
    for number in 0..lines as usize {
        source.read_exact(&mut line).map_err(failed)?;
        let samples = &line[prefix as usize..line.len() - suffix as usize];
        for (column, bytes) in samples.chunks_exact(kind.bytes).enumerate() {
            let value = kind.number(bytes);
            heights.push(conversion.height(value).ok_or_else(|| SurveyError::NotFinite {
                path: file.to_path_buf(),
                line: number,
                column,
                value,
            })?);
        }
    }
    let mut notes = Vec::new();
    let (affine, frame) = map::place(label, options, lines as usize, &mut notes)?;
    let mut elevation = Elevation::new(lines as usize, columns as usize, heights, affine, frame);
    elevation.title = label.text("IMAGE", "NAME").unwrap_or_default().to_string();
    elevation.sources = vec![file.to_path_buf()];
    elevation.notes = notes;
    Ok(elevation)
}

fn chosen_band(label: &Label, file: &Path, options: &ReadOptions) -> Result<usize, SurveyError> {
    let count = label.count("IMAGE", "BANDS")?.unwrap_or(1).max(1) as usize;
    let list = || (1..=count.min(100)).map(|band| band.to_string()).collect::<Vec<_>>().join(", ");
    let sequential = label.text("IMAGE", "BAND_STORAGE_TYPE").is_none_or(|kind| kind == "BAND_SEQUENTIAL");
    match options.band {
        _ if count > 1 && !sequential => {
            let statement = label.find("IMAGE", "BAND_STORAGE_TYPE");
            Err(statement.map_or_else(|| label.missing("BANDS"), |s| label.wrong(s, "BAND_SEQUENTIAL")))
        }
        Some(chosen) if (1..=count).contains(&chosen) => Ok(chosen - 1),
        Some(chosen) => {
            Err(SurveyError::NoSuchBand { path: file.to_path_buf(), chosen, count, list: list() })
        }
        None if count == 1 => Ok(0),
        None => Err(SurveyError::BandNotChosen { path: file.to_path_buf(), count, list: list() }),
    }
}

/// How a sample is stored.
#[derive(Debug, Clone, Copy)]
struct Kind {
    bytes: usize,
    real: bool,
    signed: bool,
    little: bool,
}

impl Kind {
    fn of(label: &Label) -> Result<Self, SurveyError> {
        let kind = label.find("IMAGE", "SAMPLE_TYPE").ok_or_else(|| label.missing("SAMPLE_TYPE"))?;
        let bits = label.count("IMAGE", "SAMPLE_BITS")?.ok_or_else(|| label.missing("SAMPLE_BITS"))?;
        let name = label.text("IMAGE", "SAMPLE_TYPE").unwrap_or_default().to_ascii_uppercase();
        let (real, little) = match name.as_str() {
            "PC_REAL" => (true, true),
            "IEEE_REAL" | "REAL" | "FLOAT" | "MAC_REAL" | "SUN_REAL" => (true, false),
            _ if name.ends_with("INTEGER") => {
                (false, ["LSB_", "PC_", "VAX_"].iter().any(|prefix| name.starts_with(prefix)))
            }
            _ => {
                return Err(
                    label.wrong(kind, "LSB_INTEGER, MSB_INTEGER (also unsigned), PC_REAL or IEEE_REAL")
                );
            }
        };
        let fits = if real { [32, 64].contains(&bits) } else { [8, 16, 32].contains(&bits) };
        if !fits {
            let statement = label.find("IMAGE", "SAMPLE_BITS").unwrap_or(kind);
            return Err(label.wrong(statement, "8, 16 or 32 for integers, 32 or 64 for reals"));
        }
        Ok(Self { bytes: bits as usize / 8, real, signed: !name.contains("UNSIGNED"), little })
    }

    fn number(self, bytes: &[u8]) -> f64 {
        let mut word = [0; 8];
        for (index, &byte) in bytes.iter().enumerate() {
            word[if self.little { index } else { bytes.len() - 1 - index }] = byte;
        }
        self.number_of_bits(u64::from_le_bytes(word))
    }

    fn number_of_bits(self, bits: u64) -> f64 {
        match (self.real, self.bytes, self.signed) {
            (true, 4, _) => f64::from(f32::from_bits(bits as u32)),
            (true, _, _) => f64::from_bits(bits),
            (false, 1, true) => f64::from(bits as u8 as i8),
            (false, 2, true) => f64::from(bits as u16 as i16),
            (false, _, true) => f64::from(bits as u32 as i32),
            (false, _, false) => bits as f64,
        }
    }
}

fn conversion(label: &Label, options: &ReadOptions, kind: Kind) -> Result<Conversion, SurveyError> {
    let mut voids = Vec::new();
    for keyword in ["MISSING_CONSTANT", "MISSING", "NULL", "CORE_NULL", "INVALID_CONSTANT"] {
        if let Some(text) = label.text("IMAGE", keyword) {
            voids.extend(special(label, keyword, text, kind)?);
        }
    }
    let unit = match label.text("IMAGE", "UNIT").map(str::to_ascii_uppercase).as_deref() {
        Some("KILOMETER" | "KILOMETERS" | "KM") => 1000.0,
        _ => 1.0,
    };
    let scale = label.plain_number("IMAGE", "SCALING_FACTOR")?.unwrap_or(1.0);
    let offset = label.plain_number("IMAGE", "OFFSET")?.map(|offset| offset * unit);
    let conversion = Conversion::new(label.path, options, voids, Some(scale * unit), offset)?;
    Ok(if kind.real && kind.bytes == 4 { conversion.rounded_to_f32() } else { conversion })
}

/// A special value: a number, or `16#FF7FFFFB#`, the stored bits.
fn special(label: &Label, keyword: &str, text: &str, kind: Kind) -> Result<Option<f64>, SurveyError> {
    let mut digits = text.split('#');
    if let (Some("16"), Some(digits)) = (digits.next(), digits.next()) {
        let bits = u64::from_str_radix(digits, 16).ok();
        let statement = label.find("IMAGE", keyword).ok_or_else(|| label.missing(keyword))?;
        return bits
            .map(|bits| Some(kind.number_of_bits(bits)))
            .ok_or_else(|| label.wrong(statement, "16#DIGITS#"));
    }
    label.plain_number("IMAGE", keyword)
}
