//! The samples of a PDS3 image.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Component, Path, PathBuf};

use landscape::LUNOID_RADIUS;

use super::kind::Kind;
use super::label::{Statement, Value};
use super::statements::{FILE, IMAGE, Label, plain};
use super::{in_folder, map, special};
use crate::elevation::Elevation;
use crate::error::SurveyError;
use crate::read::options::ReadOptions;
use crate::read::refusal::check_raster;
use crate::read::samples::{Conversion, Said};
use crate::read::unit;

/// File and first byte of the image, from the pointer `^IMAGE`.
pub fn locate(label: &Label) -> Result<(PathBuf, u64), SurveyError> {
    let pointer = label.find(FILE, "^IMAGE").ok_or_else(|| label.missing("^IMAGE"))?;
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

/// Reads band 1, or the chosen band of a band-sequential image.
pub fn read(label: &Label, file: &Path, start: u64, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let layout = Layout::of(label, file, start, options)?;
    let mut source = layout.open(file)?;
    let mut notes = Vec::new();
    let (affine, frame) = map::place(label, options, [layout.lines, layout.columns], &mut notes)?;
    let sphere = frame.sphere().unwrap_or(LUNOID_RADIUS);
    let said = said(label, &layout, sphere, &mut notes)?;
    let conversion = Conversion::new(label.path, options, said)?;
    let mut heights = layout
        .samples(&mut source)
        .map_err(|source| SurveyError::Read { path: file.to_path_buf(), source })?;
    notes.extend(conversion.convert(file, &mut heights, layout.columns)?);
    let mut elevation = Elevation::new(layout.lines, layout.columns, heights, affine, frame);
    elevation.title = label.text(IMAGE, "NAME")?.unwrap_or_default().to_string();
    elevation.sources = vec![file.to_path_buf()];
    elevation.notes = notes;
    Ok(elevation)
}

/// Where the samples of one band stand in a file.
struct Layout {
    lines: usize,
    columns: usize,
    kind: Kind,
    /// Bytes before and behind the samples of a line.
    around: [usize; 2],
    line_bytes: u64,
    /// First byte of the band.
    before: u64,
    /// The chosen band, from 0, and how many there are.
    band: [usize; 2],
}

impl Layout {
    fn of(label: &Label, file: &Path, start: u64, options: &ReadOptions) -> Result<Self, SurveyError> {
        let of_image = |keyword: &str| label.count(IMAGE, keyword);
        let needed = |keyword: &str| of_image(keyword)?.ok_or_else(|| label.missing(keyword));
        let (lines, columns) = (needed("LINES")?, needed("LINE_SAMPLES")?);
        check_raster(file, lines, columns)?;
        let kind = Kind::of(label)?;
        let around = [of_image("LINE_PREFIX_BYTES")?, of_image("LINE_SUFFIX_BYTES")?];
        let around = around.map(Option::unwrap_or_default);
        let band = chosen_band(label, file, options)?;
        let line_bytes = columns
            .checked_mul(kind.bytes as u64)
            .and_then(|n| n.checked_add(around[0])?.checked_add(around[1]))
            .ok_or_else(|| label.missing("LINE_SAMPLES that can be counted"))?;
        let before = (band[0] as u64).saturating_mul(lines).saturating_mul(line_bytes).saturating_add(start);
        let [lines, columns] = [lines, columns].map(|count| count as usize);
        Ok(Self { lines, columns, kind, around: around.map(|n| n as usize), line_bytes, before, band })
    }

    /// The file at the first byte of the band, if it is long enough.
    fn open(&self, file: &Path) -> Result<File, SurveyError> {
        let failed = |source| SurveyError::Read { path: file.to_path_buf(), source };
        let mut source = File::open(file).map_err(failed)?;
        let found = source.metadata().map_err(failed)?.len();
        let expected = (self.lines as u64).saturating_mul(self.line_bytes).saturating_add(self.before);
        if found < expected {
            let place = format!(
                "image of {} lines of {} bytes from byte {}",
                self.lines, self.line_bytes, self.before
            );
            return Err(SurveyError::Truncated { path: file.to_path_buf(), place, found, expected });
        }
        source.seek(SeekFrom::Start(self.before)).map_err(failed)?;
        Ok(source)
    }

    /// Stored numbers line by line.
    fn samples(&self, source: &mut File) -> std::io::Result<Vec<f64>> {
        let (mut source, mut line) = (BufReader::new(source), vec![0; self.line_bytes as usize]);
        let mut samples = Vec::with_capacity(self.lines * self.columns);
        for _ in 0..self.lines {
            source.read_exact(&mut line)?;
            let held = &line[self.around[0]..line.len() - self.around[1]];
            samples.extend(held.chunks_exact(self.kind.bytes).map(|bytes| self.kind.number(bytes)));
        }
        Ok(samples)
    }
}

/// The chosen band, from 0, and how many there are.
fn chosen_band(label: &Label, file: &Path, options: &ReadOptions) -> Result<[usize; 2], SurveyError> {
    let count = label.count(IMAGE, "BANDS")?.unwrap_or(1).max(1) as usize;
    let list = || (1..=count.min(100)).map(|band| band.to_string()).collect::<Vec<_>>().join(", ");
    let storage = label.text(IMAGE, "BAND_STORAGE_TYPE")?;
    let sequential = storage.is_none_or(|kind| kind.eq_ignore_ascii_case("BAND_SEQUENTIAL"));
    match options.band {
        _ if count > 1 && !sequential => {
            let statement = label.find(IMAGE, "BAND_STORAGE_TYPE");
            Err(statement.map_or_else(|| label.missing("BANDS"), |s| label.wrong(s, "BAND_SEQUENTIAL")))
        }
        Some(chosen) if (1..=count).contains(&chosen) => Ok([chosen - 1, count]),
        Some(chosen) => {
            Err(SurveyError::NoSuchBand { path: file.to_path_buf(), chosen, count, list: list() })
        }
        None if count == 1 => Ok([0, 1]),
        None => Err(SurveyError::BandNotChosen { path: file.to_path_buf(), count, list: list() }),
    }
}

/// What the label says about the stored numbers.
fn said(label: &Label, layout: &Layout, sphere: f64, notes: &mut Vec<String>) -> Result<Said, SurveyError> {
    let kind = layout.kind;
    let unit = label.text(IMAGE, "UNIT")?;
    let known = unit.map_or(Some(1.0), unit::length);
    let unknown_unit = known.is_none().then(|| ["label, UNIT".into(), unit.unwrap_or_default().into()]);
    if unit.is_none() {
        notes.push("the label does not name the unit of its heights: metres are assumed".into());
    }
    let metres = known.unwrap_or(1.0);
    // Scale and offset may have a unit of their own.
    let height = |unit: &str| if unit.is_empty() { Some(metres) } else { unit::length(unit) };
    let of_band = |keyword: &str| label.of_band(keyword, layout.band, plain);
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
        scale: label.of_band("SCALING_FACTOR", layout.band, height)?.unwrap_or(metres),
        offset: label.of_band("OFFSET", layout.band, height)?.unwrap_or(0.0),
        unknown_unit,
        sphere,
        is_f32: kind.real && kind.bytes == 4,
    })
}
