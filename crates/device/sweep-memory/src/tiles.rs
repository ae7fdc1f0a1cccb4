//! Pictures in tiles, and the sweeps that a tile is read from: all that the read beam needs at a time.

use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::View;
use crate::read_out::{cell_of, centre, nearest};
use crate::turned::Turned;
use crate::upright::Upright;

/// Columns that are read together: their sweeps stay in the cache.
pub(crate) const TILE: usize = 32;

/// Room for rounding where the sweeps of a tile are told by its corners (sweeps).
const ROUNDING: f64 = 1e-6;

/// Sweeps of a store, side by side.
#[derive(Debug, Clone, Copy)]
pub struct Sweeps<'a> {
    /// Number of the first.
    pub first: usize,
    /// What each of them has written.
    pub cells: &'a [&'a [f32]],
}

impl<'a> Sweeps<'a> {
    /// What sweep `number` has written.
    #[inline(always)]
    pub(crate) fn cells(&self, number: usize) -> &'a [f32] {
        self.cells[number - self.first]
    }
}

/// Some columns of a picture.
#[derive(Debug)]
pub struct Tile<'a> {
    /// Columns of the picture that the tile covers.
    pub columns: Range<usize>,
    /// All lines, from the top.
    pub rows: Vec<&'a mut [f32]>,
}

impl<'a> Tile<'a> {
    /// The columns of the tile that holds column `column` of a picture `columns` wide.
    pub fn columns_beside(column: usize, columns: usize) -> Range<usize> {
        let first = column / TILE * TILE;
        first..columns.min(first + TILE)
    }

    /// The tiles of a picture (row by row, `columns` wide), from left to right; none of one that nobody wants, which has no
    /// columns.
    pub fn all(picture: &'a mut [f32], columns: usize) -> Vec<Self> {
        let height = picture.len().checked_div(columns).unwrap_or(0);
        let columns = if height == 0 { 0 } else { columns };
        let tile =
            |first| Self { columns: first..columns.min(first + TILE), rows: Vec::with_capacity(height) };
        let mut tiles: Vec<Self> = (0..columns).step_by(TILE).map(tile).collect();
        for row in picture.chunks_exact_mut(columns.max(1)) {
            tiles.iter_mut().zip(row.chunks_mut(TILE)).for_each(|(tile, part)| tile.rows.push(part));
        }
        tiles
    }
}

/// What sweeps are read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Memory {
    /// Any raster; a pixel lies between two sweeps and takes their mean by distance, which is the spot of the reading beam.
    ScanConverter,
    /// As it was written: column n is sweep n.
    Digital,
    /// The same on a screen whose yoke turns, or which shows a part of the raster: sweep n is column n of the raster,
    /// and a pixel shows the cell of the raster in which its centre lies.
    DigitalTurned,
}

/// How a picture is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Memory that the picture is read from.
    pub memory: Memory,
    /// Where its pixels lie.
    pub view: View,
    /// Cells of a sweep.
    pub cells: usize,
    /// Columns of the picture.
    pub columns: usize,
    /// Lines of the picture.
    pub lines: usize,
}

impl Reading {
    /// The sweeps that some columns are read from; a few that they do not touch may be among them.
    pub fn sweeps(&self, columns: &Range<usize>) -> Range<usize> {
        let all = self.view.fan.sweeps as usize;
        if self.memory == Memory::Digital {
            return columns.clone();
        }
        // Where pixels lie is a quotient of linear functions over the picture: outermost at the corners of the tile.
        let corners = [columns.start, columns.end - 1].map(|column| {
            [0, self.lines - 1].map(|line| {
                let tube = self.memory == Memory::ScanConverter;
                self.view.source([self.columns, self.lines], self.cells, [column, line], tube)[0]
            })
        });
        let [first, last] =
            corners.iter().flatten().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
                [low.min(*place), high.max(*place)]
            });
        let [first, last] =
            [first - ROUNDING, last + ROUNDING].map(|place| place.clamp(0.0, (all - 1) as f64) as usize);
        // The cubic of a turned picture takes one sweep more on either side than the two around a place.
        first.saturating_sub(1)..all.min(last + 3)
    }

    /// Reads a tile from its [`sweeps`](Self::sweeps).
    pub fn read(&self, sweeps: Sweeps<'_>, tile: &mut Tile<'_>) {
        let Self { ref view, columns, lines, .. } = *self;
        match self.memory {
            Memory::ScanConverter if view.is_level(self.cells, lines) => {
                Upright { sweeps, lines, view, columns }.read(tile);
            }
            Memory::ScanConverter => {
                Turned { sweeps, lines: self.cells, view, columns, height: lines }.read(tile);
            }
            Memory::Digital => {
                for (line, row) in tile.rows.iter_mut().enumerate() {
                    let sweeps = tile.columns.clone().map(|sweep| sweeps.cells(sweep));
                    row.iter_mut().zip(sweeps).for_each(|(pixel, cells)| *pixel = cells[line]);
                }
            }
            Memory::DigitalTurned => self.read_cells(sweeps, tile),
        }
    }

    fn read_cells(&self, sweeps: Sweeps<'_>, tile: &mut Tile<'_>) {
        let Self { ref view, cells, columns, lines, .. } = *self;
        let (upright, all) = (view.upright(), view.fan.sweeps as usize);
        for (line, row) in tile.rows.iter_mut().enumerate() {
            let y = view.field.tan_half_height * centre(line, lines);
            for (column, pixel) in tile.columns.clone().zip(&mut **row) {
                let [x, y] = upright(view.field.tan_half_width * centre(column, columns), y);
                let sweep = nearest(cell_of(x, view.raster.tan_half_width, all), all);
                let cell = nearest(cell_of(y, view.raster.tan_half_height, cells), cells);
                *pixel = sweep.zip(cell).map_or(0.0, |(sweep, cell)| sweeps.cells(sweep)[cell]);
            }
        }
    }

    /// Reads a whole store, which holds its cells sweep by sweep, into `picture` (row by row).
    pub fn read_all(&self, store: &[f32], picture: &mut [f32]) {
        let cells: Vec<&[f32]> = store.chunks_exact(self.cells).collect();
        let sweeps = Sweeps { first: 0, cells: &cells };
        Tile::all(picture, self.columns).into_par_iter().for_each(|mut tile| self.read(sweeps, &mut tile));
    }
}

impl Memory {
    /// Reads a store of `cells` values a sweep into `picture` (row by row, `columns` wide).
    pub fn read(self, store: &[f32], cells: usize, columns: usize, view: &View, picture: &mut [f32]) {
        let lines = picture.len() / columns;
        Reading { memory: self, view: *view, cells, columns, lines }.read_all(store, picture);
    }
}

#[cfg(test)]
mod tests {
    use super::{Memory, Reading, Sweeps, Tile};
    use crate::View;
    use proptest::prelude::{prop_assert_eq, proptest};
    use proptest::sample::select;
    use scenario::{FieldOfView, Projection};
    use sweep_program::Fan;

    #[test]
    fn a_picture_that_nobody_wants_has_no_tiles() {
        assert!(Tile::all(&mut [], 0).is_empty());
        assert!(Tile::all(&mut [], 40).is_empty());
    }

    proptest! {
        /// Tiles that have but their own sweeps: level, pitched, turned pictures, in and beyond the raster.
        #[test]
        fn a_tile_asks_for_no_sweep_but_its_own(
            sweeps in 1..150usize, [columns, lines] in [1..200usize, 1..40usize], cells in 1..60usize,
            pitch in -0.5..0.5f64, yoke in -0.5..0.5f64, upright: bool, part in 0.6..2.0f64,
            memory in select(vec![Memory::ScanConverter, Memory::DigitalTurned]),
        ) {
            let field = FieldOfView { tan_half_width: 0.47, tan_half_height: 0.27 };
            let (yoke, part, cells) = if upright { (0.0, 1.0, lines) } else { (yoke, part, cells) };
            let raster = FieldOfView { tan_half_width: 0.47 * part, tan_half_height: 0.27 * part };
            let fan = Fan::covering(Projection::Exact, pitch, &raster, sweeps as u32).unwrap();
            let view = View { fan, projection: Projection::Exact, pitch, raster, field, yoke };
            let reading = Reading { memory, view, cells, columns, lines };
            let store: Vec<f32> = (0..sweeps * cells).map(|cell| libm::sinf(cell as f32)).collect();
            let (mut whole, mut picture) = (vec![0.0; columns * lines], vec![9.0; columns * lines]);
            memory.read(&store, cells, columns, &view, &mut whole);
            for mut tile in Tile::all(&mut picture, columns) {
                let own = reading.sweeps(&tile.columns);
                let stored: Vec<&[f32]> = own.clone().map(|sweep| &store[sweep * cells..][..cells]).collect();
                reading.read(Sweeps { first: own.start, cells: &stored }, &mut tile);
            }
            prop_assert_eq!(picture, whole);
        }
    }
}
