//! A picture that lies in a georeferenced raster, as a photograph with its map file.

use std::io::Write;
use std::path::Path;

use files::{Folder, write_atomic};
use photo_camera::Light;
use picture::{Depth, GreyPicture, PictureError, write_png};
use quantities::degrees;
use serde_json::{Value, json};
use survey::{Affine, Elevation, Frame};

use crate::WriteError;

/// Names of the files of an imported photograph.
pub const IMPORTED_FILES: [&str; 2] = ["photo.png", "camera.json"];

/// A photograph of 16 bits, whose codes are the light of a raster, and its map file.
#[derive(Debug, Clone)]
pub struct Imported {
    /// Codes of the photograph, white for the brightest value that was asked for.
    pub picture: GreyPicture,
    /// What stands in the map file.
    pub map: Value,
    /// Value that is shown white.
    pub white: f64,
    /// Number of values above white or below 0, which are shown white and black.
    pub cut: usize,
    /// Lines and columns without any value that are left out: north, south, west and east in the order of the file.
    pub left_out: [usize; 4],
}

/// Why a raster makes no photograph.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// Values are missing inside the picture.
    #[error(
        "{count} of its pixels have no value, the first in line {line}, column {column}: expected a value everywhere but in whole lines and \
         columns at the edges; cut the raster, or name its marks with --no-data"
    )]
    Holes {
        /// Number of pixels without a value.
        count: usize,
        /// Line of the first one, from 0.
        line: usize,
        /// Its column, from 0.
        column: usize,
    },
    /// No value is above 0.
    #[error("its largest value is {largest}: expected light, above 0; give --scale or --offset")]
    Dark {
        /// Largest value of the raster.
        largest: f64,
    },
    /// The codes make no picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// The photograph of a raster. `white` is the value that is shown white; its largest if there is none.
///
/// # Errors
/// If values are missing inside, or none is above 0.
pub fn import(raster: &Elevation, white: Option<f64>, light: &Light) -> Result<Imported, ImportError> {
    let left_out = empty_edges(raster);
    let [above, below, left, right] = left_out;
    let (lines, columns) = (raster.lines - above - below, raster.columns - left - right);
    let places = (0..lines).flat_map(|line| (0..columns).map(move |column| [above + line, left + column]));
    let values: Vec<f64> =
        places.map(|[line, column]| raster.height(line, column).unwrap_or(f64::NAN)).collect();
    if let Some(first) = values.iter().position(|value| value.is_nan()) {
        let count = values.iter().filter(|value| value.is_nan()).count();
        return Err(ImportError::Holes {
            count,
            line: above + first / columns,
            column: left + first % columns,
        });
    }
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if largest <= 0.0 {
        return Err(ImportError::Dark { largest });
    }
    let white = white.unwrap_or(largest);
    let full = f64::from(Depth::Sixteen.white());
    let code = |value: &f64| (value / white * full).round().clamp(0.0, full) as u16;
    let cut = values.iter().filter(|value| **value > white || **value < 0.0).count();
    let picture = GreyPicture::new(columns, lines, Depth::Sixteen, values.iter().map(code).collect())?;
    let map = map(raster.frame, raster.affine, [above, left], light);
    Ok(Imported { picture, map, white, cut, left_out })
}

/// Lines and columns at the edges that have no value at all: first and last lines, first and last columns.
fn empty_edges(raster: &Elevation) -> [usize; 4] {
    let has = |line: usize, column: usize| raster.height(line, column).is_some();
    let line = |line: &usize| (0..raster.columns).any(|column| has(*line, column));
    let column = |column: &usize| (0..raster.lines).any(|line| has(line, *column));
    let before = |found: Option<usize>| found.unwrap_or(0);
    let after = |count: usize, found: Option<usize>| found.map_or(0, |last| count - 1 - last);
    [
        before((0..raster.lines).find(line)),
        after(raster.lines, (0..raster.lines).rev().find(line)),
        before((0..raster.columns).find(column)),
        after(raster.columns, (0..raster.columns).rev().find(column)),
    ]
}

/// The map file: pixels of the picture to the coordinates of the raster, metres or degrees. `corner` is the line and column of its first pixel.
fn map(frame: Frame, Affine { first, step }: Affine, corner: [usize; 2], light: &Light) -> Value {
    let (unit, of): (&str, fn(f64) -> f64) = match frame {
        Frame::Plane(_) => ("m", |metres| metres),
        Frame::Geographic { .. } => ("deg", degrees),
    };
    // The centre of the first pixel is (0.5, 0.5).
    let start = [0, 1].map(|axis| of(first[axis] + step[axis] * (corner[axis] as f64 - 0.5)));
    let mut map = json!({
        "format": 1,
        "camera": "map",
        "unit": unit,
        "east_of_pixel": [of(step[1]), 0.0, start[1]],
        "north_of_pixel": [0.0, of(step[0]), start[0]],
    });
    if let Some(sun) = light.sun() {
        map["sun_azimuth_elevation_rad"] = json!(sun);
    }
    if let Some(grey) = light.grey() {
        map["grey_white_gamma"] = json!(grey);
    }
    map
}

/// Writes both files of a photograph into `path`, which is made if it is not there. Each file is whole or not there.
///
/// # Errors
/// If the folder cannot be made or claimed, or a file cannot be written.
pub fn write_imported(path: &Path, imported: &Imported) -> Result<(), WriteError> {
    let is_ours = |name: &str| IMPORTED_FILES.contains(&name);
    let folder = Folder::claim(path, &[], is_ours)?;
    folder.remove_leftovers(is_ours)?;
    let [photo, map] = IMPORTED_FILES.map(|name| folder.join(name));
    write_png(&photo, &imported.picture, &[picture::SOFTWARE])?;
    let text = format!("{:#}\n", imported.map);
    write_atomic(&map, |out: &mut dyn Write| out.write_all(text.as_bytes()))?;
    Ok(())
}
