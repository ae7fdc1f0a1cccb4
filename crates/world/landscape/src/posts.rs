//! Ground as posts in tiles, for generators that draw levels of detail.

use std::sync::Arc;

/// Heights on a grid of posts, beside the bank: the same ground with what no bank can hold.
#[derive(Debug, Clone, PartialEq)]
pub struct Posts {
    /// Order n of the tiles: `2^n` cells a side.
    pub order: u32,
    /// Places of rows to the north and of columns to the east (m), rising.
    pub places: [Vec<f64>; 2],
    /// Heights (m), row by row from the south, each row from the west.
    pub heights: Arc<Vec<f64>>,
    /// Ends of the ranges of levels (m) with the shares (0 to 1) over which they morph, the finest first; empty where none are stored.
    pub ranges: Vec<[f64; 2]>,
    /// Share of full light on each post, 0 to 1, as it was worked out once for one sun; none where it is not stored.
    pub light: Option<Vec<f32>>,
    /// Albedo of each post, 0 to 1; none where it is not stored.
    pub albedo: Option<Vec<f32>>,
}

impl Posts {
    /// South, west, north, east border (m).
    pub fn extent(&self) -> [f64; 4] {
        let ends =
            |axis: usize, end: fn(&[f64]) -> Option<&f64>| end(&self.places[axis]).copied().unwrap_or(0.0);
        let (first, last) = (<[f64]>::first, <[f64]>::last);
        [ends(0, first), ends(1, first), ends(0, last), ends(1, last)]
    }
}
