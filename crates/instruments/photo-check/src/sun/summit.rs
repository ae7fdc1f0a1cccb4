//! The summit of the overlaps, and how far it moves when tiles are left out.

use std::f64::consts::{PI, TAU};

use landscape::Sun;

use super::counts::{TILES, Tiles};
use super::search::Found;

/// The summit of the closest window in which it stays as tiles are left out, and two standard errors of azimuth and elevation (rad).
pub(super) fn settled(windows: &[Found]) -> Option<(Sun, [f64; 2])> {
    windows.iter().rev().find_map(|window| {
        let (sun, spread) = (window.summit(None)?, spread(window)?);
        let reach = window.reach();
        let stays = (0..2).all(|axis| spread[axis] < reach[axis]);
        stays.then_some((sun, spread))
    })
}

impl Found {
    /// The sun at the summit of the overlaps, without the posts of a tile if one is left out; none where they have no summit within
    /// the window.
    fn summit(&self, left_out: Option<usize>) -> Option<Sun> {
        let overlap = |tiles: &Tiles| tiles.without(left_out).overlap();
        let points: Vec<([f64; 2], f64)> =
            self.tried.iter().filter_map(|(steps, tiles)| Some((*steps, overlap(tiles)?))).collect();
        let sun = self.sun(top(fitted(&points)?)?);
        let is_within = (0..2).all(|axis| apart(sun, self.middle)[axis].abs() <= self.reach()[axis]);
        is_within.then_some(Sun { azimuth: sun.azimuth.rem_euclid(TAU), ..sun })
    }
}

/// Azimuth, by the shorter way, and elevation (rad) from one sun to another.
pub(super) fn apart(sun: Sun, from: Sun) -> [f64; 2] {
    let turn = (sun.azimuth - from.azimuth + PI).rem_euclid(TAU) - PI;
    [turn, sun.elevation - from.elevation]
}

/// Two standard errors of azimuth and elevation (rad), with half of the window's step; none where there is no summit without a tile.
fn spread(found: &Found) -> Option<[f64; 2]> {
    let without: Option<Vec<[f64; 2]>> =
        (0..TILES).map(|tile| Some(apart(found.summit(Some(tile))?, found.middle))).collect();
    let without = without?;
    let count = without.len() as f64;
    let steps = [found.step[0], found.middle.elevation * (found.step[1] - 1.0)];
    Some([0, 1].map(|axis| {
        let mean = without.iter().map(|angles| angles[axis]).sum::<f64>() / count;
        let squares: f64 = without.iter().map(|angles| (angles[axis] - mean) * (angles[axis] - mean)).sum();
        libm::hypot(2.0 * ((count - 1.0) / count * squares).sqrt(), 0.5 * steps[axis])
    }))
}

/// Coefficients of 1, x, y, x^2, x y, y^2 by least squares; none where the points do not tell them.
fn fitted(points: &[([f64; 2], f64)]) -> Option<[f64; 6]> {
    let mut rows = [[0.0; 7]; 6];
    for ([x, y], value) in points {
        let terms = [1.0, *x, *y, x * x, x * y, y * y, *value];
        for (row, term) in rows.iter_mut().zip(terms) {
            row.iter_mut().zip(terms).for_each(|(sum, other)| *sum += term * other);
        }
    }
    solved(rows)
}

/// Solves six equations by elimination with pivots.
fn solved(mut rows: [[f64; 7]; 6]) -> Option<[f64; 6]> {
    for at in 0..6 {
        let pivot = (at..6).max_by(|one, other| rows[*one][at].abs().total_cmp(&rows[*other][at].abs()))?;
        rows.swap(at, pivot);
        let lead = rows[at];
        if lead[at].abs() < 1e-9 {
            return None;
        }
        for (number, row) in rows.iter_mut().enumerate() {
            if number != at {
                let times = row[at] / lead[at];
                row.iter_mut().zip(lead).for_each(|(cell, lead)| *cell -= times * lead);
            }
        }
    }
    Some([0, 1, 2, 3, 4, 5].map(|at| rows[at][6] / rows[at][at]))
}

/// Where a paraboloid has its summit; none where it has none.
fn top([_, x, y, xx, xy, yy]: [f64; 6]) -> Option<[f64; 2]> {
    let determinant = 4.0 * xx * yy - xy * xy;
    let is_summit = determinant > 0.0 && xx < 0.0;
    is_summit.then(|| [(xy * y - 2.0 * yy * x) / determinant, (xy * x - 2.0 * xx * y) / determinant])
}
