//! Several pictures in one.

use std::ops::Range;

use crate::error::PictureError;
use crate::pixels::{Depth, Picture};

/// Pixels between two pictures of a sheet.
pub const GAP: usize = 4;

/// A picture to put others into.
struct Sheet<const CHANNELS: usize> {
    columns: usize,
    lines: usize,
    depth: Depth,
    codes: Vec<u16>,
}

impl<const CHANNELS: usize> Sheet<CHANNELS> {
    fn new(columns: usize, lines: usize, depth: Depth) -> Self {
        // A quarter grey stands out from a black sky and from white ground.
        Self { columns, lines, depth, codes: vec![depth.white() / 4; columns * lines * CHANNELS] }
    }

    fn put(&mut self, picture: &Picture<CHANNELS>, column: usize, line: usize) {
        for row in 0..picture.lines() {
            let (start, codes) = (((line + row) * self.columns + column) * CHANNELS, picture.line(row));
            self.codes[start..start + codes.len()].copy_from_slice(codes);
        }
    }

    fn into_picture(self) -> Picture<CHANNELS> {
        Picture::from_parts(self.columns, self.lines, self.depth, self.codes)
    }
}

/// Pictures of one size side by side, [`GAP`] pixels apart.
///
/// # Errors
/// [`PictureError::NoPictures`], [`PictureError::Unlike`].
pub fn beside<const CHANNELS: usize>(
    pictures: &[&Picture<CHANNELS>],
) -> Result<Picture<CHANNELS>, PictureError> {
    grid(pictures, pictures.len())
}

/// Up to `grid_columns` small pictures a row, in reading order, each `cell_columns` wide and as high as the
/// first picture's form asks, [`GAP`] pixels apart.
///
/// # Errors
/// [`PictureError::NoPictures`], [`PictureError::Unlike`].
pub fn contact_sheet<const CHANNELS: usize>(
    pictures: &[&Picture<CHANNELS>],
    grid_columns: usize,
    cell_columns: usize,
) -> Result<Picture<CHANNELS>, PictureError> {
    let first = first_of(pictures)?;
    let cell_lines = (first.lines() * cell_columns + first.columns() / 2) / first.columns();
    let cells: Result<Vec<_>, _> =
        pictures.iter().map(|picture| shrink(picture, cell_columns, cell_lines.max(1))).collect();
    let cells = cells?;
    grid(&cells.iter().collect::<Vec<_>>(), grid_columns)
}

fn first_of<'a, const CHANNELS: usize>(
    pictures: &[&'a Picture<CHANNELS>],
) -> Result<&'a Picture<CHANNELS>, PictureError> {
    let first = *pictures.first().ok_or(PictureError::NoPictures)?;
    match pictures.iter().find(|picture| picture.kind() != first.kind()) {
        Some(unlike) => Err(PictureError::Unlike { found: unlike.kind(), expected: first.kind() }),
        None => Ok(first),
    }
}

fn grid<const CHANNELS: usize>(
    pictures: &[&Picture<CHANNELS>],
    grid_columns: usize,
) -> Result<Picture<CHANNELS>, PictureError> {
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
pub fn shrink<const CHANNELS: usize>(
    picture: &Picture<CHANNELS>,
    columns: usize,
    lines: usize,
) -> Result<Picture<CHANNELS>, PictureError> {
    if columns == 0 || lines == 0 {
        return Err(PictureError::Size { columns, lines, codes: 0 });
    }
    // Whole numbers throughout: one old pixel is `columns` x `lines` units, one new pixel `area` units.
    let area = (picture.columns() * picture.lines()) as u64;
    let across: Vec<_> = (0..columns).map(|column| overlaps(column, picture.columns(), columns)).collect();
    let mut codes = Vec::with_capacity(columns * lines * CHANNELS);
    for line in 0..lines {
        let down = overlaps(line, picture.lines(), lines);
        let channels = |across| (0..CHANNELS).map(move |channel| (channel, across));
        let sums = across.iter().flat_map(channels);
        let sums = sums.map(|(channel, across)| weighted_sum(picture, channel, across, &down));
        codes.extend(sums.map(|sum| ((sum + area / 2) / area) as u16));
    }
    Ok(Picture::from_parts(columns, lines, picture.depth(), codes))
}

/// The old pixels that new pixel `index` covers, each with its share of it in units.
fn overlaps(index: usize, old: usize, new: usize) -> Vec<(usize, u64)> {
    let covered = index * old..(index + 1) * old;
    let pixels: Range<usize> = covered.start / new..covered.end.div_ceil(new);
    let share = |pixel: usize| covered.end.min((pixel + 1) * new) - covered.start.max(pixel * new);
    pixels.map(|pixel| (pixel, share(pixel) as u64)).collect()
}

fn weighted_sum<const CHANNELS: usize>(
    picture: &Picture<CHANNELS>,
    channel: usize,
    across: &[(usize, u64)],
    down: &[(usize, u64)],
) -> u64 {
    let line_sum = |line: usize| -> u64 {
        let pixels = picture.line(line).as_chunks::<CHANNELS>().0;
        across.iter().map(|(column, share)| u64::from(pixels[*column][channel]) * share).sum()
    };
    down.iter().map(|(line, share)| line_sum(*line) * share).sum()
}
