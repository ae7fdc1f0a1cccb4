//! Elevation files into memory.

mod geotiff;
mod npy;
mod page;
mod pds3;
mod samples;
mod unit;
mod words;

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use quantities::degrees;

use crate::elevation::{Affine, Elevation};
use crate::error::SurveyError;

pub use self::page::{VOCABULARIES, words_page};
pub use self::words::{Fate, Vocabulary, Word};

/// What the user knows better than the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ReadOptions {
    /// Band with the heights, from 1; needed where a file has several.
    pub band: Option<usize>,
    /// Metres a stored unit; in place of the file's own scale.
    pub scale: Option<f64>,
    /// Metres added after scaling; in place of the file's own offset.
    pub offset: Option<f64>,
    /// Stored values that mark voids; in place of the file's own. Empty: the file's own.
    pub no_data: Vec<f64>,
    /// Metres from line to line and from column to column, for files without a place.
    pub spacing: Option<[f64; 2]>,
    /// Whether the first line is the southernmost, for files without a place. Default false: the northernmost.
    pub first_line_south: bool,
    /// Names of tags, keys and keywords that are not known here and that change neither heights nor their place:
    /// `KEYWORD` or `object:NAME` of a label, `tag:NUMBER`, `key:NUMBER` or `item:NAME` of a TIFF.
    pub ignore: Vec<String>,
}

impl ReadOptions {
    fn check(&self) -> Result<(), SurveyError> {
        let refuse = |option, found: String, expected: &str| {
            Err(SurveyError::Option { option, found, expected: expected.to_string() })
        };
        if let Some(scale) = self.scale.filter(|scale| !scale.is_finite() || *scale == 0.0) {
            return refuse("scale", scale.to_string(), "a finite number other than 0");
        }
        if let Some(offset) = self.offset.filter(|offset| !offset.is_finite()) {
            return refuse("offset", offset.to_string(), "a finite number of metres");
        }
        let bad = |spacing: &[f64; 2]| !spacing.iter().all(|step| step.is_finite() && *step > 0.0);
        if let Some(spacing) = self.spacing.filter(bad) {
            return refuse("spacing", format!("{spacing:?}"), "two lengths above 0 m");
        }
        Ok(())
    }

    /// Refuses options for files without a place, of one that has it.
    fn expect_no_place(&self) -> Result<(), SurveyError> {
        let given = [
            ("spacing", self.spacing.map(|[north, east]| format!("{north},{east}"))),
            ("first line south", self.first_line_south.then(|| "true".to_owned())),
        ];
        let given = given.into_iter().find_map(|(option, found)| Some((option, found?)));
        given.map_or(Ok(()), |(option, found)| {
            let expected = "nothing: the file itself says where its samples lie".to_owned();
            Err(SurveyError::Option { option, found, expected })
        })
    }

    /// Place of the samples of a file that says nothing about it.
    fn own_place(&self, lines: usize) -> Option<Affine> {
        let [north, east] = self.spacing?;
        Some(if self.first_line_south {
            Affine { first: [0.0; 2], step: [north, east] }
        } else {
            Affine { first: [(lines - 1) as f64 * north, 0.0], step: [-north, east] }
        })
    }
}

/// Reads a GeoTIFF, a PDS3 image (by image or label) or a `.npy` array; the first bytes decide which.
///
/// # Errors
/// If the file is missing, damaged, of another kind, without finite heights, or needs an option.
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let path = path.as_ref();
    options.check()?;
    let start = first_bytes(path)?;
    let mut elevation = match start.as_slice() {
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => geotiff::read(path, options)?,
        [0x93, b'N', b'U', b'M', b'P', b'Y', ..] => npy::read(path, options)?,
        _ if pds3::is_label(&start) => pds3::read(path, options)?,
        _ => match pds3::label_beside(path)? {
            Some(label) => pds3::read(&label, options)?,
            None => return Err(unknown(path, &start)),
        },
    };
    check_globe(path, &elevation)?;
    let seams = elevation.seams();
    if seams > 0 {
        elevation.notes.push(format!(
            "the last column stands where the first does, and has other heights in {seams} lines: the first counts"
        ));
    }
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    elevation.title = if elevation.title.is_empty() { stem } else { format!("{stem}: {}", elevation.title) };
    if elevation.range().is_none() {
        let count = elevation.lines * elevation.columns;
        return Err(SurveyError::AllVoid { what: path.display().to_string(), count });
    }
    Ok(elevation)
}

/// Refuses places that are on no globe, as those of a file whose metres are said to be degrees.
fn check_globe(path: &Path, elevation: &Elevation) -> Result<(), SurveyError> {
    let ([south, west, north, east], step) = (elevation.extent(), elevation.affine.step.map(f64::abs));
    let reach = [south.abs().max(north.abs()) - step[0], east - west - step[1]].map(degrees);
    let is_globe = matches!(elevation.frame, crate::Frame::Geographic { .. });
    if !is_globe || (reach[0] < 90.0 && reach[1] < 360.0) {
        return Ok(());
    }
    let edges = [south, west, north, east].map(|edge| format!("{:.4}", degrees(edge)));
    let found = format!("south {}, west {}, north {}, east {} deg", edges[0], edges[1], edges[2], edges[3]);
    let expected = "latitudes from -90 to 90 and one turn of longitudes";
    Err(field(
        path,
        "place of the samples",
        found,
        expected,
        "the file does not hold degrees: correct its place",
    ))
}

fn first_bytes(path: &Path) -> Result<Vec<u8>, SurveyError> {
    let failed = |source| SurveyError::Read { path: path.to_path_buf(), source };
    let file = File::open(path).map_err(failed)?;
    if !file.metadata().map_err(failed)?.is_file() {
        return Err(SurveyError::NotAFile(path.to_path_buf()));
    }
    let mut start = Vec::new();
    file.take(64).read_to_end(&mut start).map_err(failed)?;
    Ok(start)
}

fn unknown(path: &Path, start: &[u8]) -> SurveyError {
    let found = match start {
        [] => "nothing: the file is empty".to_string(),
        _ => start.iter().take(8).map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "),
    };
    SurveyError::UnknownFormat { path: path.to_path_buf(), found }
}

/// Refuses rasters that cannot carry a fit; gives the number of samples.
fn check_raster(path: &Path, lines: u64, columns: u64) -> Result<usize, SurveyError> {
    if lines < 2 || columns < 2 {
        return Err(SurveyError::Empty { path: path.to_path_buf(), lines, columns });
    }
    let count = usize::try_from(lines).ok().zip(usize::try_from(columns).ok());
    count.and_then(|(lines, columns)| lines.checked_mul(columns)).ok_or_else(|| SurveyError::Field {
        path: path.to_path_buf(),
        place: "raster size".into(),
        found: format!("{lines} x {columns}"),
        expected: "a number of samples that this machine can count".into(),
        advice: "the header is damaged: fetch the file again".into(),
    })
}

fn field(
    path: &Path,
    place: impl Into<String>,
    found: impl Into<String>,
    expected: impl Into<String>,
    advice: impl Into<String>,
) -> SurveyError {
    SurveyError::Field {
        path: PathBuf::from(path),
        place: place.into(),
        found: found.into(),
        expected: expected.into(),
        advice: advice.into(),
    }
}
