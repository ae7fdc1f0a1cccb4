//! Posts of the ground, cut into tiles.

use std::sync::Arc;

use crate::TileError;

/// Largest order of a tile: 4097 posts a side.
const LARGEST_ORDER: u32 = 12;

/// A tile by its column and row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Tile {
    /// Column of the tile, from 0 on the left.
    pub column: usize,
    /// Row of the tile, from 0 at the bottom.
    pub row: usize,
}

/// Heights of a rectangular grid of posts, cut into tiles of `2^n` cells a side.
#[derive(Debug, Clone, PartialEq)]
pub struct Terrain {
    order: u32,
    places: [Vec<f64>; 2],
    heights: Arc<Vec<f64>>,
}

/// The two vertices between which vertex i, j of a level lies at the next one; `None` if that level has it too.
pub fn parents([i, j]: [usize; 2]) -> Option<[[usize; 2]; 2]> {
    match (i % 2, j % 2) {
        (0, 0) => None,
        (_, 0) => Some([[i - 1, j], [i + 1, j]]),
        (0, _) => Some([[i, j + 1], [i, j - 1]]),
        _ => Some([[i - 1, j + 1], [i + 1, j - 1]]),
    }
}

impl Terrain {
    /// The terrain of posts at places `x` and `y` (m, rising) with `heights` (m), row by row from the bottom, in tiles of the order `order`.
    ///
    /// # Errors
    /// If the posts make no whole tiles, or a height is no number.
    pub fn new(order: u32, places: [Vec<f64>; 2], heights: Vec<f64>) -> Result<Self, TileError> {
        Self::shared(order, places, heights.into())
    }

    /// The same over heights that others hold too.
    ///
    /// # Errors
    /// Those of [`Terrain::new`].
    pub fn shared(order: u32, [x, y]: [Vec<f64>; 2], heights: Arc<Vec<f64>>) -> Result<Self, TileError> {
        if !(1..=LARGEST_ORDER).contains(&order) {
            return Err(TileError::Order(order));
        }
        let side = 1 << order;
        for (axis, places) in [('x', &x), ('y', &y)] {
            if places.len() <= side || (places.len() - 1) % side != 0 {
                return Err(TileError::Posts { axis, posts: places.len(), side });
            }
            if let Some(before) = places.windows(2).position(|pair| pair[1].is_nan() || pair[1] <= pair[0]) {
                return Err(TileError::Places { axis, index: before + 1 });
            }
        }
        let expected = x.len() * y.len();
        if heights.len() != expected {
            return Err(TileError::Heights { found: heights.len(), expected });
        }
        match heights.iter().position(|height| !height.is_finite()) {
            Some(void) => Err(TileError::Void(void)),
            None => Ok(Self { order, places: [x, y], heights }),
        }
    }

    /// Order n of the tiles.
    pub fn order(&self) -> u32 {
        self.order
    }

    /// Lowest and highest places (m) of the posts.
    pub fn extent(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|end| [0, 1].map(|axis| self.places[axis][end * (self.places[axis].len() - 1)]))
    }

    /// Places of the posts along x and along y (m, rising).
    pub fn posts_along(&self) -> [&[f64]; 2] {
        self.places.each_ref().map(Vec::as_slice)
    }

    /// How many posts there are.
    pub fn posts(&self) -> u64 {
        self.heights.len() as u64
    }

    /// Cells of a side of a tile at a level.
    pub fn cells(&self, level: usize) -> usize {
        1 << (self.order as usize - level)
    }

    /// How many tiles there are in a row and in a column.
    pub fn counts(&self) -> [usize; 2] {
        [0, 1].map(|axis| (self.places[axis].len() - 1) >> self.order)
    }

    /// All tiles, row by row.
    pub fn tiles(&self) -> impl Iterator<Item = Tile> + use<> {
        let [columns, rows] = self.counts();
        (0..rows).flat_map(move |row| (0..columns).map(move |column| Tile { column, row }))
    }

    /// Number of a tile in the order of [`tiles`](Self::tiles).
    pub fn number(&self, tile: Tile) -> usize {
        tile.row * self.counts()[0] + tile.column
    }

    /// Place (m) of vertex i, j of a tile at a level.
    pub fn place(&self, tile: Tile, level: usize, [i, j]: [usize; 2]) -> [f64; 2] {
        let [column, row] = self.post(tile, level, [i, j]);
        [self.places[0][column], self.places[1][row]]
    }

    /// Height (m) of the post of vertex i, j of a tile at a level.
    pub fn height(&self, tile: Tile, level: usize, at: [usize; 2]) -> f64 {
        let [column, row] = self.post(tile, level, at);
        self.heights[row * self.places[0].len() + column]
    }

    /// Mean height (m) of the two vertices between which vertex i, j of a tile lies at the next level; `None` if that level has it too. The
    /// level must not be the coarsest that tiles can have.
    pub fn mean(&self, tile: Tile, level: usize, [i, j]: [usize; 2]) -> Option<f64> {
        let [a, b] = parents([i, j])?.map(|at| self.height(tile, level, at));
        Some((a + b) / 2.0)
    }

    /// How far (m, upwards) a vertex lies above where it will lie when its level has become the next one.
    pub fn delta(&self, tile: Tile, level: usize, at: [usize; 2]) -> f64 {
        self.mean(tile, level, at).map_or(0.0, |mean| self.height(tile, level, at) - mean)
    }

    /// Place and height (m) of the middle post of a tile.
    pub fn middle(&self, tile: Tile) -> [f64; 3] {
        let half = self.cells(0) / 2;
        let [x, y] = self.place(tile, 0, [half, half]);
        [x, y, self.height(tile, 0, [half, half])]
    }

    /// The tile that holds a place (m), the nearest where none does, and where in it, in cells of level 0.
    pub fn locate(&self, place: [f64; 2]) -> (Tile, [f64; 2]) {
        let counts = self.counts();
        let [(column, x), (row, y)] = [0, 1].map(|axis| {
            let places = &self.places[axis];
            let cell = places.partition_point(|&post| post <= place[axis]).clamp(1, places.len() - 1) - 1;
            let share = (place[axis] - places[cell]) / (places[cell + 1] - places[cell]);
            let tile = (cell >> self.order).min(counts[axis] - 1);
            (tile, (cell - (tile << self.order)) as f64 + share.clamp(0.0, 1.0))
        });
        (Tile { column, row }, [x, y])
    }

    fn post(&self, tile: Tile, level: usize, [i, j]: [usize; 2]) -> [usize; 2] {
        [(tile.column << self.order) + (i << level), (tile.row << self.order) + (j << level)]
    }
}
