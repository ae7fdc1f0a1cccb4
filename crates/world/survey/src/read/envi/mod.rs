//! ENVI rasters: a header in text, and unpacked samples in a file beside it.

mod header;
mod place;
pub mod words;

use std::path::{Path, PathBuf};

use landscape::LUNOID_RADIUS;

use self::header::Header;
use super::bands;
use super::beside::{going_on, in_folder, with_ending};
use super::gate;
use super::kind::Kind;
use super::opened::Opened;
use super::options::ReadOptions;
use super::raw::Raw;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::words::Decider;
use crate::elevation::Grid;
use crate::error::SurveyError;

/// Endings that files of samples have; the empty one is that of a name without an ending.
const ENDINGS: [&str; 9] = ["", ".img", ".dat", ".bin", ".raw", ".bsq", ".bil", ".bip", ".dem"];

/// Whether a file begins like a header.
pub fn is_header(start: &[u8]) -> bool {
    start.strip_prefix(b"ENVI").is_some_and(|rest| rest.first().is_none_or(u8::is_ascii_whitespace))
}

/// The header beside a file of samples: `NAME.hdr`, or the whole name with `.hdr` behind it.
pub fn header_of(path: &Path) -> Result<Option<PathBuf>, SurveyError> {
    let behind = Some(going_on(path, ".hdr")).filter(|path| path.is_file());
    for header in [behind, with_ending(path, "hdr")?].into_iter().flatten() {
        if is_header(&gate::front(&header, 8)?) {
            return Ok(Some(header));
        }
    }
    Ok(None)
}

/// The file of samples that a header is beside of.
fn samples_of(header: &Path) -> Result<PathBuf, SurveyError> {
    let stem = header.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let names = ENDINGS.map(|ending| format!("{stem}{ending}"));
    let found = names.iter().map(|name| in_folder(header, name)).collect::<Result<Vec<_>, _>>()?;
    let mut found: Vec<PathBuf> = found.into_iter().flatten().filter(|found| found.is_file()).collect();
    let (place, expected) = ("file of the samples", names.join(", "));
    match found.len() {
        0 => {
            let advice = "put the samples beside their header, or name the file of the samples";
            Err(field(header, place, "none in the folder of the header", expected, advice))
        }
        1 => Ok(found.remove(0)),
        _ => {
            let names = found.iter().filter_map(|found| found.file_name()).map(|name| name.to_string_lossy());
            let names = names.collect::<Vec<_>>().join(", ");
            Err(field(header, place, names, format!("one of {expected}"), "name the file of the samples"))
        }
    }
}

/// Opens the samples of a header; `samples` is their file where it is known.
pub fn open(path: &Path, samples: Option<&Path>, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let mut decider = Decider::new(path, options);
    let header = Header::read(path, &mut decider)?;
    let file = samples.map_or_else(|| samples_of(path), |file| Ok(file.to_path_buf()))?;
    let bands = usize::try_from(header.count("bands")?.unwrap_or(1)).unwrap_or(usize::MAX);
    let names = header.list("band names").unwrap_or_default();
    let name = |band: usize| names.get(band).map(|name| (*name).to_owned());
    let likely: &[usize] = if bands == 1 { &[0] } else { &[] };
    let band = bands::chosen(&file, options, bands, likely, name)?;
    let raw = raw(&header, &file, [band, bands])?;
    let mut notes = Vec::new();
    let (affine, frame) = place::place(&header, options, [raw.lines, raw.columns], &mut decider, &mut notes)?;
    notes.extend(decider.finish()?);
    notes.push("the header does not name the unit of its heights: metres are assumed".into());
    let sphere = frame.sphere().unwrap_or(LUNOID_RADIUS);
    let said = said(&header, raw.kind, [band, bands], sphere, &mut notes)?;
    Ok(Opened {
        grid: Grid { lines: raw.lines, columns: raw.columns, affine, frame },
        path: path.to_path_buf(),
        title: name(band).unwrap_or_default(),
        sources: vec![path.to_path_buf(), file],
        notes,
        conversion: Conversion::new(path, options, said)?,
        samples: Box::new(raw),
    })
}

/// Where the samples of a band stand.
fn raw(header: &Header, file: &Path, [band, bands]: [usize; 2]) -> Result<Raw, SurveyError> {
    let size = [header.needed("lines")?, header.needed("samples")?];
    check_raster(file, size[0], size[1])?;
    let kind = kind(header)?;
    let (sample, band, bands) = (kind.bytes as u64, band as u64, bands as u64);
    let line = size[1].saturating_mul(sample);
    // From line to line, from sample to sample, from band to band.
    let [block_step, sample_step, band_step] =
        match header.get("interleave").map(str::to_ascii_lowercase).as_deref() {
            Some("bsq") => [line, sample, line.saturating_mul(size[0])],
            Some("bil") => [line.saturating_mul(bands), sample, line],
            Some("bip") => [line.saturating_mul(bands), sample.saturating_mul(bands), sample],
            Some(_) => return Err(header.wrong("interleave", "bsq, bil or bip")),
            None if bands == 1 => [line, sample, 0],
            None => return Err(header.missing("interleave")),
        };
    let first = header.count("header offset")?.unwrap_or(0).saturating_add(band_step.saturating_mul(band));
    let raw = Raw::lines_of(file, size.map(|count| count as usize), kind, first);
    let raw = Raw { block_step, sample_step, ..raw };
    raw.check()?;
    Ok(raw)
}

fn kind(header: &Header) -> Result<Kind, SurveyError> {
    let little = match header.count("byte order")? {
        Some(0) => Some(true),
        Some(1) => Some(false),
        Some(_) => return Err(header.wrong("byte order", "0 or 1")),
        None => None,
    };
    let order = || little.ok_or_else(|| header.missing("byte order"));
    Ok(match header.needed("data type")? {
        1 => Kind::integer(1, false, true),
        2 => Kind::integer(2, true, order()?),
        3 => Kind::integer(4, true, order()?),
        4 => Kind::real(4, order()?),
        5 => Kind::real(8, order()?),
        12 => Kind::integer(2, false, order()?),
        13 => Kind::integer(4, false, order()?),
        14 => Kind::integer(8, true, order()?),
        15 => Kind::integer(8, false, order()?),
        _ => return Err(header.wrong("data type", "1, 2, 3, 4, 5, 12, 13, 14 or 15")),
    })
}

/// What the header says about the stored numbers.
fn said(
    header: &Header,
    kind: Kind,
    band: [usize; 2],
    sphere: f64,
    notes: &mut Vec<String>,
) -> Result<Said, SurveyError> {
    let void = match header.get("data ignore value") {
        Some(text) => {
            let number = text.parse::<f64>().ok().filter(|number| !number.is_nan() || kind.real);
            Some(number.ok_or_else(|| header.wrong("data ignore value", "a number"))?)
        }
        None => None,
    };
    if let Some(void) = void.filter(|void| !kind.can_hold(*void)) {
        notes.push(format!("data ignore value: no sample can hold {void}"));
    }
    Ok(Said {
        voids: void.into_iter().map(|void| [void; 2]).collect(),
        scale: header.of_band("data gain values", band)?.unwrap_or(1.0),
        offset: header.of_band("data offset values", band)?.unwrap_or(0.0),
        sphere,
        stored: kind.stored(),
        ..Said::default()
    })
}
