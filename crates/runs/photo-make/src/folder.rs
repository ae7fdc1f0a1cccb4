//! The folder of a photograph.

use std::io::Write;
use std::path::Path;

use files::{Folder, Npy, NpyData, write_atomic, write_npy};
use picture::write_png;
use serde_json::Value;

use crate::points::points;
use crate::{ElevationGrid, Made, WriteError};

/// Names of the files, in the order of writing: the record comes last, when all others stand.
pub const FILES: [&str; 6] =
    ["photo.png", "camera.json", "ground.npy", "elevation.asc", "points.csv", "photo.json"];

/// Writes all files of a photograph into `path`, which is made if it is not there. Each file is whole or not there.
///
/// # Errors
/// If the folder cannot be made or claimed, or a file cannot be written.
pub fn write_folder(
    path: &Path,
    made: &Made,
    grid: &ElevationGrid,
    record: &Value,
) -> Result<(), WriteError> {
    let folder = Folder::claim(path, &[], |name| FILES.contains(&name))?;
    folder.remove_leftovers(|name| FILES.contains(&name))?;
    let [photo, camera, ground, elevation, control, about] = FILES.map(|name| folder.join(name));
    let text =
        |path: &Path, text: &str| write_atomic(path, |out: &mut dyn Write| out.write_all(text.as_bytes()));
    // A folder whose record is gone is not taken for a whole one.
    if about.exists() {
        folder.remove(FILES[5])?;
    }
    write_png(&photo, &made.picture, &[picture::SOFTWARE])?;
    text(&camera, &made.file.write())?;
    write_npy(&ground, &array(made))?;
    text(&elevation, &grid.text(made))?;
    text(&control, &points(made))?;
    text(&about, &format!("{record:#}\n"))?;
    Ok(())
}

/// East, north, up (m) of each pixel's ground: lines x columns x 3, NaN where there is none.
fn array(made: &Made) -> Npy {
    let none = [f64::NAN; 3];
    let values = made.ground.iter().flat_map(|point| point.map_or(none, |point| point.to_array()));
    let shape = vec![made.picture.lines(), made.picture.columns(), 3];
    Npy::new(shape, NpyData::F64(values.collect())).expect("three values a pixel")
}
