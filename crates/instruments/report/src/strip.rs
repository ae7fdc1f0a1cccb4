//! Small frames that are part of the page: its contact sheet, and all that is left of the run when it is mailed alone.

use std::path::Path;

use picture::{AnyPicture, Limits, read_any_png};
use replay::picture_name;

use crate::ReportError;
use crate::run::Run;

/// Most frames of the strip.
pub const STRIP_FRAMES: u64 = 24;
/// Their columns, at most.
const COLUMNS: usize = 320;

/// A small frame of the contact sheet.
#[derive(Debug)]
pub(crate) struct Small {
    /// Index of its picture.
    pub picture: u64,
    /// `data:` URL of a PNG.
    pub url: String,
    pub columns: usize,
    pub lines: usize,
}

/// Frames spread evenly from the first to the last.
pub(crate) fn strip(folder: &Path, run: &Run) -> Result<Vec<Small>, ReportError> {
    let chosen = spread(run.first_picture(), run.pictures(), STRIP_FRAMES);
    chosen.into_iter().map(|picture| small(folder, picture, run)).collect()
}

pub(crate) fn spread(first: u64, pictures: u64, most: u64) -> Vec<u64> {
    let count = pictures.min(most);
    (0..count).map(|index| first + index * (pictures - 1) / (count - 1).max(1)).collect()
}

fn small(folder: &Path, picture: u64, run: &Run) -> Result<Small, ReportError> {
    let path = folder.join(picture_name(picture));
    let whole = read_any_png(&path, &Limits::default())?.to_eight_bits();
    let shrunk =
        fitted(&whole, run, COLUMNS).map_err(|source| ReportError::Strip { path: path.clone(), source })?;
    let png = shrunk.encode_png(&[]).map_err(|source| ReportError::Strip { path, source })?;
    let (columns, lines) = (shrunk.columns(), shrunk.lines());
    Ok(Small { picture, url: text::data_url("image/png", &png), columns, lines })
}

/// The picture in the form of the screen, at most `most` columns wide: few sweeps are wide ones.
pub(crate) fn fitted(
    picture: &AnyPicture,
    run: &Run,
    most: usize,
) -> Result<AnyPicture, picture::PictureError> {
    let columns = picture.columns().min(most);
    let lines = (columns as f64 / run.aspect()).round().max(1.0) as usize;
    match columns == picture.columns() {
        true => Ok(picture.clone()),
        false => picture.shrink(columns, lines),
    }
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn first_and_last_are_among_them() {
        assert_eq!(spread(5, 1, 24), [5]);
        assert_eq!(spread(0, 3, 24), [0, 1, 2]);
        let many = spread(30, 300, 24);
        assert_eq!((many.len(), many[0], many[23]), (24, 30, 329));
        assert!(many.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
