//! The arrays of a sample, and the picture of one that is read back.

use std::io::{Cursor, Read};
use std::path::Path;

use drive::{Codes, TruthPlane};
use files::{Npy, NpyError};
use limits::Limit;
use picture::{AnyPicture, ColourPicture, Depth, GreyPicture};

use crate::DatasetError;

/// Name of the array of the picture.
pub(crate) const PICTURE: &str = "picture";
/// Name of the array that says whose ground a pixel shows.
pub(crate) const SPLIT: &str = "split";
/// Name of the array of pixels that a fault changed.
pub(crate) const CHANGED: &str = "changed";

/// The codes of a picture: lines, columns, and 3 behind them for colour.
pub(crate) fn of_picture(picture: &AnyPicture) -> Result<Npy, NpyError> {
    let mut shape = vec![picture.lines(), picture.columns()];
    let codes = codes(picture);
    shape.extend(picture.is_colour().then_some(3));
    Npy::new(shape, codes)
}

/// Codes of 8 bits, line by line; those of a pixel side by side.
pub(crate) fn codes(picture: &AnyPicture) -> Vec<u8> {
    let bytes = |codes: &[u16]| codes.iter().map(|code| *code as u8).collect();
    match picture.grey() {
        Some(grey) => bytes(grey.codes()),
        None => bytes(picture.to_colour().codes()),
    }
}

/// A plane of truth as it is written.
pub(crate) fn of_plane(plane: TruthPlane) -> Result<Npy, NpyError> {
    match plane.values {
        Codes::Numbers(numbers) => Npy::new(plane.shape, numbers),
        Codes::Codes(codes) => Npy::new(plane.shape, codes),
    }
}

/// The array `name` in the file `path` of a sample.
///
/// # Errors
/// If the file cannot be read or has no such array.
pub fn read_array(path: &Path, name: &str) -> Result<Npy, DatasetError> {
    let refuse = |reason: String| DatasetError::Record { path: path.to_owned(), reason };
    let bytes = files::read_all(path, Limit::BankBytes)?;
    let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|error| refuse(error.to_string()))?;
    let mut array = Vec::new();
    let mut entry = zip.by_name(&format!("{name}.npy")).map_err(|error| refuse(error.to_string()))?;
    entry.read_to_end(&mut array).map_err(|error| refuse(error.to_string()))?;
    Npy::parse(&array).map_err(|error| refuse(format!("array {name}: {error}")))
}

/// The picture in the file `path` of a sample.
pub(crate) fn read_picture(path: &Path) -> Result<AnyPicture, DatasetError> {
    let refuse = |reason: String| DatasetError::Record { path: path.to_owned(), reason };
    let (shape, data) = read_array(path, PICTURE)?.into_parts();
    let codes: Vec<u16> = data.to_f64().into_iter().map(|code| code as u16).collect();
    let made = match shape[..] {
        [lines, columns] => GreyPicture::new(columns, lines, Depth::Eight, codes).map(AnyPicture::from),
        [lines, columns, 3] => ColourPicture::new(columns, lines, Depth::Eight, codes).map(AnyPicture::from),
        _ => return Err(refuse("its picture has neither one code a pixel nor three".into())),
    };
    made.map_err(|error| refuse(error.to_string()))
}

/// Names of the arrays in the file `path` of a sample, in their order.
pub(crate) fn names(path: &Path) -> Result<Vec<String>, DatasetError> {
    let refuse = |error: zip::result::ZipError| DatasetError::Record {
        path: path.to_owned(),
        reason: error.to_string(),
    };
    let bytes = files::read_all(path, Limit::BankBytes)?;
    let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).map_err(refuse)?;
    let count = zip.len();
    let name = |at: usize| Ok(zip.by_index(at)?.name()?.trim_end_matches(".npy").to_owned());
    (0..count).map(name).collect::<Result<_, _>>().map_err(refuse)
}
