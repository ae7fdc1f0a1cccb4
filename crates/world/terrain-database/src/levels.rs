//! How far each level of a tile lies from level 0.

use crate::contents::Contents;
use crate::database::Tile;
use crate::tiling::Tiling;

/// Errors and bounds of a tile.
pub(crate) fn tile(of: &Contents, tiling: Tiling, number: usize) -> Tile {
    let view = View { of, tiling, corner: tiling.place(number).map(|at| at << tiling.order) };
    let errors = (0..=tiling.order).map(|level| if level == 0 { 0.0 } else { view.error(level) }).collect();
    Tile { errors, bounds: view.bounds() }
}

/// A tile with all posts of its borders.
struct View<'c> {
    of: &'c Contents,
    tiling: Tiling,
    corner: [usize; 2],
}

impl View<'_> {
    /// Heights of a row of posts (m), from the west to the east border.
    fn row(&self, row: usize) -> &[f64] {
        let first = (self.corner[1] + row) * self.tiling.posts()[0] + self.corner[0];
        &self.of.heights[first..=first + self.tiling.side()]
    }

    fn bounds(&self) -> [f64; 2] {
        let all = (0..=self.tiling.side()).flat_map(|row| self.row(row));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &height| {
            [low.min(height), high.max(height)]
        })
    }

    /// Largest distance of the surface of a level from the posts (m). Posts stand evenly in a tile, so shares count posts.
    fn error(&self, level: u32) -> f64 {
        let (step, side) = (1 << level, self.tiling.side());
        let cells = (0..side).step_by(step);
        let cells = cells.flat_map(|row| (0..side).step_by(step).map(move |column| [column, row]));
        cells.map(|cell| self.error_in(cell, step)).fold(0.0, f64::max)
    }

    /// The same in a cell of `step` posts, which is cut from top left to bottom right.
    fn error_in(&self, [column, row]: [usize; 2], step: usize) -> f64 {
        let [bottom, top] = [row, row + step].map(|row| {
            let row = self.row(row);
            [row[column], row[column + step]]
        });
        let mut error = 0.0_f64;
        for j in 0..=step {
            let heights = &self.row(row + j)[column..=column + step];
            for (i, height) in heights.iter().enumerate() {
                let [u, v] = [i, j].map(|at| at as f64 / step as f64);
                let level = if i + j <= step {
                    bottom[0] + u * (bottom[1] - bottom[0]) + v * (top[0] - bottom[0])
                } else {
                    top[1] + (1.0 - u) * (top[0] - top[1]) + (1.0 - v) * (bottom[1] - top[1])
                };
                error = error.max((level - height).abs());
            }
        }
        error
    }
}
