//! A ray from each post along the triangles of the mesh: exact for the mesh.
//!
//! Cells are cut from their north-west to their south-east corner. Along a ray the ground is straight between the edges that the ray
//! crosses, so it is enough to look at the crossings: with the sides of each cell, and with its diagonal.

use glam::DVec3;
use rayon::prelude::*;

use crate::heights::Heights;

/// Posts that the ground hides from the sun, row by row.
pub fn shadows(heights: &Heights, sun: DVec3) -> Vec<bool> {
    let grid = heights.grid();
    let [rows, columns] = grid.size();
    let level = (sun.x * sun.x + sun.y * sun.y).sqrt();
    let field = Field {
        heights,
        north: (0..rows).map(|row| grid.north.place(row)).collect(),
        east: (0..columns).map(|column| grid.east.place(column)).collect(),
        way: [sun.x / level, sun.y / level],
        rise: sun.z / level,
        highest: heights.range()[1],
    };
    let row = |row: usize| {
        let field = &field;
        (0..columns).map(move |column| field.is_hidden([row, column]))
    };
    (0..rows).into_par_iter().flat_map_iter(row).collect()
}

struct Field<'h> {
    heights: &'h Heights,
    north: Vec<f64>,
    east: Vec<f64>,
    /// Unit vector towards the sun in the plane: north, east.
    way: [f64; 2],
    /// Rise of the ray over a level metre.
    rise: f64,
    highest: f64,
}

impl Field<'_> {
    fn places(&self, axis: usize) -> &[f64] {
        if axis == 0 { &self.north } else { &self.east }
    }

    fn is_hidden(&self, post: [usize; 2]) -> bool {
        let from = [self.north[post[0]], self.east[post[1]]];
        let height = self.heights.post(post[0], post[1]);
        let Some(mut cell) = self.first_cell(post) else { return false };
        let mut done = 0.0;
        loop {
            let exits = [0, 1].map(|axis| self.exit(axis, cell[axis], from[axis]));
            let axis = usize::from(exits[1] < exits[0]);
            let exit = exits[axis];
            let ray = |at: f64| height + at * self.rise;
            if self.diagonal(cell, from, [done, exit]).is_some_and(|(at, ground)| ground > ray(at)) {
                return true;
            }
            let at = [0, 1].map(|axis| from[axis] + exit * self.way[axis]);
            if self.side(cell, axis, at) > ray(exit) {
                return true;
            }
            match self.next(cell[axis], axis) {
                Some(next) if ray(exit) <= self.highest => cell[axis] = next,
                _ => return false,
            }
            done = exit;
        }
    }

    /// The cell into which the ray leaves its post; none where it leaves the grid.
    fn first_cell(&self, post: [usize; 2]) -> Option<[usize; 2]> {
        let cell = |axis: usize| {
            let last = self.places(axis).len() - 1;
            if self.way[axis] > 0.0 {
                (post[axis] < last).then_some(post[axis])
            } else if self.way[axis] < 0.0 {
                post[axis].checked_sub(1)
            } else {
                Some(post[axis].min(last - 1))
            }
        };
        Some([cell(0)?, cell(1)?])
    }

    fn next(&self, cell: usize, axis: usize) -> Option<usize> {
        if self.way[axis] > 0.0 {
            (cell + 2 < self.places(axis).len()).then_some(cell + 1)
        } else {
            cell.checked_sub(1)
        }
    }

    /// Way (m) to the side at which the ray leaves a cell along one axis.
    fn exit(&self, axis: usize, cell: usize, from: f64) -> f64 {
        let way = self.way[axis];
        if way == 0.0 {
            return f64::INFINITY;
        }
        (self.places(axis)[cell + usize::from(way > 0.0)] - from) / way
    }

    /// Share of the way across a cell along one axis.
    fn share(&self, axis: usize, cell: usize, at: f64) -> f64 {
        let places = self.places(axis);
        ((at - places[cell]) / (places[cell + 1] - places[cell])).clamp(0.0, 1.0)
    }

    /// Height (m) of the side of a cell at which the ray leaves it along `axis`.
    fn side(&self, cell: [usize; 2], axis: usize, at: [f64; 2]) -> f64 {
        let line = cell[axis] + usize::from(self.way[axis] > 0.0);
        let other = 1 - axis;
        let share = self.share(other, cell[other], at[other]);
        let post = |along: usize| match axis {
            0 => self.heights.post(line, along),
            _ => self.heights.post(along, line),
        };
        let [low, high] = [cell[other], cell[other] + 1].map(post);
        low + share * (high - low)
    }

    /// Way (m) to the diagonal and its height there, where the ray crosses it between two ways.
    fn diagonal(&self, cell: [usize; 2], from: [f64; 2], ways: [f64; 2]) -> Option<(f64, f64)> {
        let shares =
            |way: f64| [0, 1].map(|axis| self.share(axis, cell[axis], from[axis] + way * self.way[axis]));
        let side = |[north, east]: [f64; 2]| north + east - 1.0;
        let [first, last] = ways.map(|way| side(shares(way)));
        if first * last >= 0.0 {
            return None;
        }
        let way = ways[0] + (ways[1] - ways[0]) * first / (first - last);
        let [_, east] = shares(way);
        let north_west = self.heights.post(cell[0] + 1, cell[1]);
        let south_east = self.heights.post(cell[0], cell[1] + 1);
        Some((way, north_west + east * (south_east - north_west)))
    }
}
