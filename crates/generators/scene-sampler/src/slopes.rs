//! Slopes of the posts of a map, listed or found from heights.

use std::sync::Arc;

/// Slopes of the posts of a map (to the north, to the east; m/m), row by row: posts along the second axis follow one another.
#[derive(Debug, Clone)]
pub enum Slopes {
    /// As they are listed.
    Listed(Arc<Vec<[f32; 2]>>),
    /// Those to the posts around each, found where they are asked for: heights of many posts need no second list beside them.
    Between {
        /// Places of the posts along both axes (m).
        places: Arc<[Vec<f64>; 2]>,
        /// Heights of the posts (m), in the same order.
        heights: Arc<Vec<f64>>,
    },
}

impl Slopes {
    /// Slopes of the post in a row and a column. There must be one.
    pub(crate) fn at(&self, [row, column]: [usize; 2], columns: usize) -> [f32; 2] {
        match self {
            Self::Listed(slopes) => slopes[row * columns + column],
            Self::Between { places, heights } => {
                slopes_between(places, [row, column], |row, column| heights[row * columns + column])
            }
        }
    }

    /// How many posts they are of.
    pub(crate) fn posts(&self) -> usize {
        match self {
            Self::Listed(slopes) => slopes.len(),
            Self::Between { heights, .. } => heights.len(),
        }
    }
}

/// Slopes to the north and to the east (m/m) at the post in a row and a column, by the `height` (m) of the posts around it.
pub fn slopes_between(
    [rows, columns]: &[Vec<f64>; 2],
    [row, column]: [usize; 2],
    height: impl Fn(usize, usize) -> f64,
) -> [f32; 2] {
    let around = |places: &[f64], at: usize| (at.saturating_sub(1), (at + 1).min(places.len() - 1));
    let ((south, north), (west, east)) = (around(rows, row), around(columns, column));
    let to_north = (height(north, column) - height(south, column)) / (rows[north] - rows[south]);
    let to_east = (height(row, east) - height(row, west)) / (columns[east] - columns[west]);
    [to_north as f32, to_east as f32]
}
