//! Elevation files into memory.

mod ascii;
mod bands;
mod beside;
mod doubts;
mod dted;
mod earth;
mod envi;
mod gate;
mod geotiff;
mod hgt;
mod isis;
mod kind;
mod label;
mod map;
mod npy;
mod opened;
mod options;
mod page;
mod pds3;
mod pds4;
mod raw;
mod refusal;
mod samples;
pub(crate) mod stretch;
mod unit;
mod wkt;
mod words;

use std::path::{Path, PathBuf};

use quantities::degrees;

use self::refusal::{field, visible};
use crate::elevation::{Elevation, Frame, Grid};
use crate::error::SurveyError;

pub(crate) use self::doubts::listed;
pub(crate) use self::map::around;
pub use self::opened::Opened;
pub use self::options::ReadOptions;
pub use self::page::{VOCABULARIES, words_page};
pub use self::stretch::Window;
pub use self::words::{Fate, Vocabulary, Word};

/// Bytes by which the kind of a file is told.
const FIRST_BYTES: u64 = 64;

/// Reads a whole elevation file: [`open()`], then [`Opened::all`].
///
/// # Errors
/// If the file is missing, damaged, of another kind, without finite heights, or needs an option.
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    open(path, options)?.all()
}

/// Opens a GeoTIFF, a PDS3 image or PDS4 array (by data or label), an ISIS cube, an ENVI raster (by header or samples), an Arc
/// ASCII grid, a DTED cell, a `.npy` array or an SRTM tile. The ending `.hgt` makes a tile; else the first bytes decide.
///
/// # Errors
/// If the file is missing, its header is damaged or of another kind, or an option is needed.
pub fn open(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let path = path.as_ref();
    options.check()?;
    let start = gate::front(path, FIRST_BYTES)?;
    let mut opened = match start.as_slice() {
        _ if hgt::is_tile(path) => hgt::open(path, options)?,
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => geotiff::open(path, options)?,
        [0x93, b'N', b'U', b'M', b'P', b'Y', ..] => npy::open(path, options)?,
        _ if dted::is_dted(&start) => dted::open(path, options)?,
        _ if pds3::is_label(&start) => pds3::open(path, options)?,
        _ if pds4::is_label(&start) => pds4::open(path, options)?,
        _ if isis::is_cube(&start) => isis::open(path, options)?,
        _ if envi::is_header(&start) => envi::open(path, None, options)?,
        _ if ascii::is_grid(&start) => ascii::open(path, options)?,
        _ => by_label(path, &start, options)?,
    };
    check_globe(path, &opened.grid)?;
    opened.notes.extend(beyond_the_map(&opened.grid));
    opened.notes.extend(other_metadata(&opened.sources));
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let title = if opened.title.is_empty() { stem } else { format!("{stem}: {}", opened.title) };
    opened.title = visible(&title);
    opened.path = path.to_path_buf();
    Ok(opened)
}

/// Opens samples that say nothing about themselves by the label or header beside them.
fn by_label(path: &Path, start: &[u8], options: &ReadOptions) -> Result<Opened, SurveyError> {
    if let Some(label) = beside::with_ending(path, "lbl")? {
        let is_cube = isis::is_cube(&gate::front(&label, FIRST_BYTES)?);
        return if is_cube { isis::open(&label, options) } else { pds3::open(&label, options) };
    }
    if let Some(label) = beside::with_ending(path, "xml")?.filter(|label| label != path) {
        return pds4::open(&label, options);
    }
    match envi::header_of(path)? {
        Some(header) => envi::open(&header, Some(path), options),
        None => Err(unknown(path, start)),
    }
}

/// Notes on metadata of GDAL's beside the files, which are not read.
fn other_metadata(sources: &[PathBuf]) -> Vec<String> {
    let beside = sources.iter().map(|path| beside::going_on(path, ".aux.xml")).filter(|path| path.is_file());
    let note = |path: PathBuf| {
        format!("{} is not read: it may hold a no-data value, a scale or a place", path.display())
    };
    beside.map(note).collect()
}

/// A note on corners of the samples that lie beyond the sphere of their map, as those of a file whose unit is another one. An
/// orthographic picture of a whole globe has such corners too.
fn beyond_the_map(grid: &Grid) -> Option<String> {
    let Frame::Plane(Some(projection)) = grid.frame else { return None };
    let [south, west, north, east] = grid.extent();
    let corners = [[south, west], [south, east], [north, west], [north, east]];
    let beyond = corners.iter().filter(|corner| projection.inverse(**corner).is_none()).count();
    (beyond > 0).then(|| {
        format!(
            "{beyond} of the 4 corners lie beyond the map of a sphere of radius {} m: they have no latitude and longitude; the unit \
             of the map may be another one",
            projection.radius
        )
    })
}

/// Refuses places that are on no globe, as those of a file whose metres are said to be degrees.
fn check_globe(path: &Path, grid: &Grid) -> Result<(), SurveyError> {
    let ([south, west, north, east], step) = (grid.extent(), grid.affine.step.map(f64::abs));
    let reach = [south.abs().max(north.abs()) - step[0], east - west - step[1]].map(degrees);
    let is_globe = matches!(grid.frame, Frame::Geographic { .. });
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

fn unknown(path: &Path, start: &[u8]) -> SurveyError {
    let found = match start {
        [] => "nothing: the file is empty".to_string(),
        [0x89, b'P', b'N', b'G', ..] => {
            "the mark of a PNG picture, which has no heights in metres".to_string()
        }
        [0xff, 0xd8, 0xff, ..] => "the mark of a JPEG picture, which has no heights in metres".to_string(),
        _ => start.iter().take(8).map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "),
    };
    SurveyError::UnknownFormat { path: path.to_path_buf(), found }
}
