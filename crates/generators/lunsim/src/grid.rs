//! The ground grid, row by row: heights with the drop of the lunoid (block 10), slopes by central differences (blocks
//! 9, 11, 12, 18).

use landscape::Landscape;
use rayon::prelude::*;
use scenario::Curvature;

use crate::area::ViewedArea;
use crate::observer::Observer;

/// A place that lies farther than this (m) outside the map is not drawn; nearer it is rounding.
const EDGE: f64 = 1e-6;

/// What lies at a point of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cover {
    /// Beyond the map: a turned grid reaches over its corners.
    Nothing,
    /// Ground outside all craters.
    Terrain,
    /// Ground inside a crater.
    Crater,
}

/// Heights over the viewed area, `size` x `size` points; row 0 is the nearest, column 0 the leftmost.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    /// Points in a row, and rows.
    pub size: usize,
    /// Range increments along the line of sight and across it (m).
    pub steps: [f64; 2],
    /// Heights above the tangent plane of the observer's foot point, the drop taken off (m).
    pub heights: Vec<f64>,
    /// Cover at each point of the grid.
    pub covers: Vec<Cover>,
    /// Whose drop is taken off.
    pub curvature: Curvature,
    origin: [f64; 2],
}

impl Grid {
    /// The grid over `area`.
    pub fn new(
        landscape: &Landscape,
        observer: &Observer,
        area: &ViewedArea,
        size: usize,
        curvature: Curvature,
    ) -> Self {
        let step = |[low, high]: [f64; 2]| (high - low) / (size - 1) as f64;
        let (steps, origin) = ([step(area.along), step(area.across)], [area.along[0], area.across[0]]);
        let grid = Self { size, steps, heights: Vec::new(), covers: Vec::new(), origin, curvature };
        let point = |index: usize| {
            let place = grid.place(index / size, index % size);
            let (height, cover) = ground(landscape, observer.on_map(place));
            (height - grid.drop(place), cover)
        };
        let (heights, covers) = (0..size * size).into_par_iter().with_min_len(size).map(point).unzip();
        Self { heights, covers, ..grid }
    }

    /// Place of a point in the observer's axes (m).
    pub fn place(&self, row: usize, column: usize) -> [f64; 2] {
        [self.origin[0] + row as f64 * self.steps[0], self.origin[1] + column as f64 * self.steps[1]]
    }

    /// Where on the map the ground of point `index` is looked up: at its place, or at the nearest place of the map.
    pub fn inside(&self, landscape: &Landscape, observer: &Observer, index: usize) -> [f64; 2] {
        nearest(landscape, observer.on_map(self.place(index / self.size, index % self.size)))
    }

    /// The drop of the lunoid at a place in the observer's axes (m).
    pub fn drop(&self, [along, across]: [f64; 2]) -> f64 {
        self.curvature.drop((along * along + across * across).sqrt())
    }

    /// Slopes at a point: parallel to the line of sight, transverse.
    pub fn slopes(&self, row: usize, column: usize) -> [f64; 2] {
        let at = |row: usize, column: usize| self.heights[row * self.size + column];
        let (rows, columns) = (self.around(row), self.around(column));
        let rise = |high: f64, low: f64, [before, after]: [usize; 2], step: f64| {
            (high - low) / ((after - before) as f64 * step)
        };
        [
            rise(at(rows[1], column), at(rows[0], column), rows, self.steps[0]),
            rise(at(row, columns[1]), at(row, columns[0]), columns, self.steps[1]),
        ]
    }

    /// The neighbours of a row or column: the edges lack one, and take themselves instead.
    fn around(&self, index: usize) -> [usize; 2] {
        [index.saturating_sub(1), (index + 1).min(self.size - 1)]
    }
}

/// Height (m) of a place of the map and what lies there; beyond the map, that of its nearest place.
fn ground(landscape: &Landscape, [x, y]: [f64; 2]) -> (f64, Cover) {
    let [inside_x, inside_y] = nearest(landscape, [x, y]);
    let height = landscape.terrain_at(inside_x, inside_y).map_or(0.0, |terrain| terrain.height);
    let rise = landscape.features().at(inside_x, inside_y);
    let is_outside = (x - inside_x).abs() > EDGE || (y - inside_y).abs() > EDGE;
    let cover = match (is_outside, rise.present) {
        (true, _) => Cover::Nothing,
        (false, true) => Cover::Crater,
        (false, false) => Cover::Terrain,
    };
    (height + rise.height, cover)
}

/// The place of the map that is nearest to a place (north, east; m).
fn nearest(landscape: &Landscape, [x, y]: [f64; 2]) -> [f64; 2] {
    let [south, west, north, east] = landscape.level().extent();
    [x.clamp(south, north), y.clamp(west, east)]
}

#[cfg(test)]
mod tests {
    use super::{Cover, Grid};
    use scenario::Curvature;

    /// Slopes of a tilted plane are its own at every point, those with one neighbour too.
    #[test]
    fn a_tilted_plane_has_one_slope_up_to_its_edges() {
        let size = 9;
        let height =
            |index: usize| 3.0 + 0.25 * 4.0 * (index / size) as f64 - 0.5 * 2.0 * (index % size) as f64;
        let grid = Grid {
            size,
            steps: [4.0, 2.0],
            heights: (0..size * size).map(height).collect(),
            covers: vec![Cover::Terrain; size * size],
            origin: [0.0; 2],
            curvature: Curvature::None,
        };
        for index in 0..size * size {
            assert_eq!(grid.slopes(index / size, index % size), [0.25, -0.5], "point {index}");
        }
    }
}
