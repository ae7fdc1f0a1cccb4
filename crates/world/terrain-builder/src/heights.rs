//! Heights and slopes on the posts of a grid.

use glam::DVec3;

use crate::grid::Grid;

/// A height for each post of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Heights {
    grid: Grid,
    /// Row by row from the south, each from the west (m).
    values: Vec<f64>,
    /// Places of the rows and of the columns (m).
    places: [Vec<f64>; 2],
}

impl Heights {
    /// Heights row by row from the south, each from the west (m). Missing ones are 0.
    pub fn new(grid: Grid, mut values: Vec<f64>) -> Self {
        let [rows, columns] = grid.size();
        values.resize(rows * columns, 0.0);
        let places =
            [&grid.north, &grid.east].map(|axis| (0..axis.posts()).map(|post| axis.place(post)).collect());
        Self { grid, values, places }
    }

    /// Posts of the heights.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// All heights (m), row by row from the south, each from the west.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Height of a post (m).
    pub fn post(&self, row: usize, column: usize) -> f64 {
        self.values[row * self.places[1].len() + column]
    }

    /// Lowest and highest post (m).
    pub fn range(&self) -> [f64; 2] {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        self.values.iter().fold(start, |[low, high], &height| [low.min(height), high.max(height)])
    }

    /// Rise over run to the north and to the east at a post, by the posts beside it; at the border by the post itself and its
    /// neighbour.
    pub fn slope(&self, row: usize, column: usize) -> [f64; 2] {
        let [north, east] = &self.places;
        let beside = |at: usize, places: &[f64]| [at.saturating_sub(1), (at + 1).min(places.len() - 1)];
        let ([south, to_north], [west, to_east]) = (beside(row, north), beside(column, east));
        [
            (self.post(to_north, column) - self.post(south, column)) / (north[to_north] - north[south]),
            (self.post(row, to_east) - self.post(row, west)) / (east[to_east] - east[west]),
        ]
    }

    /// Unit normal at a post: north, east, up.
    pub fn normal(&self, row: usize, column: usize) -> DVec3 {
        let [north, east] = self.slope(row, column);
        DVec3::new(-north, -east, 1.0).normalize()
    }

    /// Largest difference to other heights on the same posts (m).
    pub fn largest_difference(&self, other: &Self) -> f64 {
        self.values.iter().zip(&other.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }
}
