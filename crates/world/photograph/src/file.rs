//! The file beside a photograph: a camera file, or a map file.
//!
//! ```json
//! {
//!   "format": 1,
//!   "camera": "map",
//!   "unit": "m",
//!   "east_of_pixel": [1.0, 0.0, -15473.4],
//!   "north_of_pixel": [0.0, -1.0, 150987.2]
//! }
//! ```
//!
//! The rows are (a, b, c) of `east = a I + b J + c` and of north, in metres, or in degrees with `"unit": "deg"`. The keys of the
//! light are those of a camera file. A file without `camera` is a camera file.

use std::path::Path;

use diagnostics::Problem;
use limits::Limit;
use photo_camera::{CameraFile, Light};
use serde::Deserialize;

use crate::{Map, MapUnit, PhotoError, Placement};

/// Format number of map files.
const FORMAT: u64 = 1;
/// Word of the file for a map.
const MAP: &str = "map";
/// What to do about a text that is no map file.
const HELP: &str = "correct the file at this place; docs/photo.md shows a whole one";

/// What stands in the file beside a photograph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhotoFile {
    /// How the pixels lie on the ground.
    pub placement: Placement,
    /// Sun and grey curve, as far as they are known.
    pub light: Light,
}

impl PhotoFile {
    /// Reads a camera file or a map file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, or is neither.
    pub fn read(path: &Path) -> Result<Self, PhotoError> {
        let bytes = files::read_all(path, Limit::TextBytes)?;
        let text = String::from_utf8_lossy(&bytes);
        read_photo_file(&path.display().to_string(), &text).map_err(PhotoError::Camera)
    }
}

/// The key that tells a map file from a camera file.
#[derive(Deserialize)]
struct Kind {
    #[serde(default)]
    camera: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenMap {
    format: u64,
    #[serde(rename = "camera")]
    _camera: String,
    unit: String,
    east_of_pixel: [f64; 3],
    north_of_pixel: [f64; 3],
    #[serde(default)]
    sun_azimuth_elevation_rad: Option<[f64; 2]>,
    #[serde(default)]
    grey_white_gamma: Option<[f64; 2]>,
}

/// Reads the text of a camera file or of a map file; `name` is the file as the user named it.
///
/// # Errors
///
/// If the text is neither, with line and column; or if a figure makes no camera or map, with its key.
pub fn read_photo_file(name: &str, text: &str) -> Result<PhotoFile, Box<Problem>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    // What is no JSON at all is refused by the reader of camera files.
    let kind = serde_json::from_str::<Kind>(text).ok().and_then(|kind| kind.camera);
    match kind.as_deref() {
        None => {
            let CameraFile { camera, axes, light } = CameraFile::read(name, text)?;
            Ok(PhotoFile { placement: Placement::Camera { camera, axes }, light })
        }
        Some(MAP) => read_map(name, text),
        Some(other) => {
            let title = format!("`camera` is \"{other}\", not \"{MAP}\"");
            let problem = Problem::of_file(name, title).key("camera").found(other).expected(MAP);
            Err(Box::new(problem.help("leave the key out for a camera with perspective")))
        }
    }
}

fn read_map(name: &str, text: &str) -> Result<PhotoFile, Box<Problem>> {
    let written: WrittenMap = serde_json::from_str(text).map_err(|error| {
        let at = format!("{name}:{}:{}", error.line(), error.column());
        let problem = Problem::of_file(at, format!("the map file cannot be read: {error}"));
        Box::new(problem.expected("a map file of format 1").help(HELP))
    })?;
    let refused = |key: &str, title: String| {
        Box::new(Problem::of_file(name, format!("`{key}`: {title}")).key(key).help(HELP))
    };
    if written.format != FORMAT {
        return Err(refused("format", format!("it is {}, not {FORMAT}", written.format)));
    }
    let unit = [MapUnit::Metre, MapUnit::Degree].into_iter().find(|unit| unit.word() == written.unit);
    let unit =
        unit.ok_or_else(|| refused("unit", format!("it is \"{}\", not \"m\" or \"deg\"", written.unit)))?;
    let map = Map::new(written.east_of_pixel, written.north_of_pixel, unit)
        .map_err(|error| refused("east_of_pixel", error.to_string()))?;
    let light = Light::new(written.sun_azimuth_elevation_rad, written.grey_white_gamma)
        .map_err(|(key, error)| refused(key, error.to_string()))?;
    Ok(PhotoFile { placement: Placement::Map(map), light })
}
