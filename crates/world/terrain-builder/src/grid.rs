//! Posts of a landscape: tiles of `2^n + 1` posts a side, the last tile of a row or column stretched to fit.

use limits::Limit;

use crate::frame::Frame;
use crate::refused::{Refused, expect};

/// Largest tile exponent: 4096 cells a side.
pub const MOST_EXPONENT: u32 = 12;

/// Posts along one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Place of the first post (m).
    pub first: f64,
    /// Nominal distance between posts (m).
    pub resolution: f64,
    /// Cells of nominal size: the number that covers the range.
    pub cells: usize,
    /// A tile has `2^exponent` cells a side.
    pub exponent: u32,
}

impl Axis {
    fn new(first: f64, length: f64, resolution: f64, exponent: u32) -> Self {
        // A range that is a whole number of cells but for rounding has no further cell.
        let cells = (length / resolution - 1e-9).ceil().max(1.0) as usize;
        Self { first, resolution, cells, exponent }
    }

    /// Cells of a tile along one side.
    pub fn tile_cells(&self) -> usize {
        1 << self.exponent
    }

    /// Number of tiles along the axis.
    pub fn tiles(&self) -> usize {
        self.cells.div_ceil(self.tile_cells())
    }

    /// Number of posts; tiles share the posts of their borders.
    pub fn posts(&self) -> usize {
        self.tiles() * self.tile_cells() + 1
    }

    /// Spacing of a tile as a share of the nominal: below 1 only for the last tile, where cells are left over.
    pub fn spacing_factor(&self, tile: usize) -> f64 {
        let left_over = self.cells % self.tile_cells();
        if tile + 1 == self.tiles() && left_over > 0 {
            left_over as f64 / self.tile_cells() as f64
        } else {
            1.0
        }
    }

    /// Place of a post (m).
    pub fn place(&self, post: usize) -> f64 {
        let last = (self.tiles() - 1) * self.tile_cells();
        let beyond = post.saturating_sub(last) as f64 * self.spacing_factor(self.tiles() - 1);
        self.first + (post.min(last) as f64 + beyond) * self.resolution
    }
}

/// Posts of a landscape, row by row from the south, each row from the west.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Posts to the north: the rows.
    pub north: Axis,
    /// Posts to the east: the columns.
    pub east: Axis,
}

impl Grid {
    /// The grid that covers a frame from its south-west corner, `resolution` (m) between posts, tiles of `2^exponent` cells.
    ///
    /// # Errors
    /// If the resolution is not above 0 m, the exponent is above 12, or the posts are more than [`Limit::Corners`].
    pub fn new(frame: &Frame, resolution: f64, exponent: u32) -> Result<Self, Refused> {
        let is_length = (1e-3..=1e7).contains(&resolution);
        expect(is_length, "resolution_m", resolution, "a length from 0.001 m to 1e7 m")?;
        expect(exponent <= MOST_EXPONENT, "tile_exponent", exponent, "a whole number from 0 to 12")?;
        let ([south, west], [to_north, to_east]) = (frame.corner(), frame.size());
        let north = Axis::new(south, to_north, resolution, exponent);
        let east = Axis::new(west, to_east, resolution, exponent);
        let posts = north.posts() as f64 * east.posts() as f64;
        let found = format!("{resolution}, {posts} posts,");
        let expected = "a coarser one: the limit `corners` allows fewer posts";
        expect(posts <= Limit::Corners.value() as f64, "resolution_m", found, expected)?;
        Ok(Self { north, east })
    }

    /// Rows and columns of posts.
    pub fn size(&self) -> [usize; 2] {
        [self.north.posts(), self.east.posts()]
    }

    /// Place of a post: north, east (m).
    pub fn place(&self, row: usize, column: usize) -> [f64; 2] {
        [self.north.place(row), self.east.place(column)]
    }

    /// South-west and north-east corner: north, east (m).
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let [rows, columns] = self.size();
        [self.place(0, 0), self.place(rows - 1, columns - 1)]
    }
}
