//! How posts are cut into tiles, and which posts the block of a tile has.

use std::ops::Range;

/// Largest order of a tile: 4097 posts a side.
pub(crate) const MOST_ORDER: u32 = 12;

/// Tiles of `2^order` cells a side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Tiling {
    /// Order n of a tile.
    pub order: u32,
    /// Number of tiles in a row and in a column.
    pub counts: [usize; 2],
}

impl Tiling {
    /// Cells of a side of a tile.
    pub fn side(self) -> usize {
        1 << self.order
    }

    /// Posts along x and along y.
    pub fn posts(self) -> [usize; 2] {
        self.counts.map(|count| (count << self.order) + 1)
    }

    /// Number of all tiles.
    pub fn tiles(self) -> usize {
        self.counts[0] * self.counts[1]
    }

    /// Column and row of a tile by its number.
    pub fn place(self, tile: usize) -> [usize; 2] {
        [tile % self.counts[0], tile / self.counts[0]]
    }

    /// Posts along an axis that the block of a tile in this column (axis 0) or row (axis 1) has: its own without its last, which is the
    /// first of the next tile.
    pub fn own(self, axis: usize, at: usize) -> Range<usize> {
        let end = (at + 1) << self.order;
        at << self.order..end + usize::from(at + 1 == self.counts[axis])
    }

    /// Column and row of the tile whose block has a post, by the post's column and row.
    pub fn owner(self, post: [usize; 2]) -> [usize; 2] {
        [0, 1].map(|axis| (post[axis] >> self.order).min(self.counts[axis] - 1))
    }
}
