//! Several pictures in one.

use std::ops::Range;

use crate::error::PictureError;
use crate::grey::{Depth, GreyPicture};

/// Pixels between two pictures of a sheet.
pub const GAP: usize = 4;

/// A picture to put others into.
struct Sheet {
    columns: usize,
    lines: usize,
    depth: Depth,
    codes: Vec<u16>,
}

impl Sheet {
    fn new(columns: usize, lines: usize, depth: Depth) -> Self {
        // A quarter grey stands out from a black sky and from white ground.
        Self { columns, lines, depth, codes: vec![depth.white() / 4; columns * lines] }
    }

    fn put(&mut self, picture: &GreyPicture, column: usize, line: usize) {
        for row in 0..picture.lines() {
            let start = (line + row) * self.columns + column;
            self.codes[start..start + picture.columns()].copy_from_slice(picture.line(row));
        }
    }

    fn into_picture(self) -> GreyPicture {
        GreyPicture::from_parts(self.columns, self.lines, self.depth, self.codes)
    }
}

/// Pictures of one size side by side, [`GAP`] pixels apart.
///
/// # Errors
/// [`PictureError::NoPictures`], [`PictureError::Unlike`].
pub fn beside(pictures: &[&GreyPicture]) -> Result<GreyPicture, PictureError> {
    grid(pictures, pictures.len())
}

/// Up to `grid_columns` small pictures a row, in reading order, each `cell_columns` wide and as high as the
/// first picture's form asks, [`GAP`] pixels apart.
///
/// # Errors
/// [`PictureError::NoPictures`], [`PictureError::Unlike`].
pub fn contact_sheet(
    pictures: &[&GreyPicture],
    grid_columns: usize,
    cell_columns: usize,
) -> Result<GreyPicture, PictureError> {
    let first = first_of(pictures)?;
    let cell_lines = (first.lines() * cell_columns + first.columns() / 2) / first.columns();
    let cells: Result<Vec<_>, _> =
        pictures.iter().map(|picture| shrink(picture, cell_columns, cell_lines.max(1))).collect();
    let cells = cells?;
    grid(&cells.iter().collect::<Vec<_>>(), grid_columns)
}

fn first_of<'a>(pictures: &[&'a GreyPicture]) -> Result<&'a GreyPicture, PictureError> {
    let first = *pictures.first().ok_or(PictureError::NoPictures)?;
    match pictures.iter().find(|picture| picture.kind() != first.kind()) {
        Some(unlike) => Err(PictureError::Unlike { found: unlike.kind(), expected: first.kind() }),
        None => Ok(first),
    }
}

fn grid(pictures: &[&GreyPicture], grid_columns: usize) -> Result<GreyPicture, PictureError> {
    let cell = first_of(pictures)?;
    let across = grid_columns.min(pictures.len());
    if across == 0 {
        return Err(PictureError::NoPictures);
    }
    let down = pictures.len().div_ceil(across);
    let pitch = (cell.columns() + GAP, cell.lines() + GAP);
    let mut sheet = Sheet::new(across * pitch.0 - GAP, down * pitch.1 - GAP, cell.depth());
    for (index, picture) in pictures.iter().enumerate() {
        sheet.put(picture, index % across * pitch.0, index / across * pitch.1);
    }
    Ok(sheet.into_picture())
}

/// The picture at another size: each new pixel is the mean of the codes of the area it covers, rounded.
///
/// # Errors
/// [`PictureError::Size`] when there would be no pixel.
pub fn shrink(picture: &GreyPicture, columns: usize, lines: usize) -> Result<GreyPicture, PictureError> {
    if columns == 0 || lines == 0 {
        return Err(PictureError::Size { columns, lines, codes: 0 });
    }
    // Whole numbers throughout: one old pixel is `columns` x `lines` units, one new pixel `area` units.
    let area = (picture.columns() * picture.lines()) as u64;
    let across: Vec<_> = (0..columns).map(|column| overlaps(column, picture.columns(), columns)).collect();
    let mut codes = Vec::with_capacity(columns * lines);
    for line in 0..lines {
        let down = overlaps(line, picture.lines(), lines);
        let sums = across.iter().map(|across| weighted_sum(picture, across, &down));
        codes.extend(sums.map(|sum| ((sum + area / 2) / area) as u16));
    }
    Ok(GreyPicture::from_parts(columns, lines, picture.depth(), codes))
}

/// The old pixels that new pixel `index` covers, each with its share of it in units.
fn overlaps(index: usize, old: usize, new: usize) -> Vec<(usize, u64)> {
    let covered = index * old..(index + 1) * old;
    let pixels: Range<usize> = covered.start / new..covered.end.div_ceil(new);
    let share = |pixel: usize| covered.end.min((pixel + 1) * new) - covered.start.max(pixel * new);
    pixels.map(|pixel| (pixel, share(pixel) as u64)).collect()
}

fn weighted_sum(picture: &GreyPicture, across: &[(usize, u64)], down: &[(usize, u64)]) -> u64 {
    let line_sum = |line: usize| -> u64 {
        let codes = picture.line(line);
        across.iter().map(|(column, share)| u64::from(codes[*column]) * share).sum()
    };
    down.iter().map(|(line, share)| line_sum(*line) * share).sum()
}
