//! Voids filled before the fit: nearly harmonic, so between the heights around them.
//!
//! A fit over a void alone is as ill-conditioned as the void is wide. Here every place gets a height first: data
//! are averaged into ever coarser grids, void cells never, until each cell has one; on the way back each void
//! cell starts from the coarser grid and is relaxed to the mean of its neighbours. All values are convex
//! combinations of data (after a plane is taken out), so they cannot overshoot. The fit then follows them weakly.

use rayon::prelude::*;

use crate::fit::Place;
use crate::patch::Patch;

/// Relaxations a grid: enough for waves of the few cells that the coarser grid could not carry.
const SWEEPS: usize = 12;

/// The plane of least squares through the used samples: height at the origin (m) and slopes north and east.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanPlane {
    /// Height at the origin of the patch axes (m).
    pub height: f64,
    /// Rise over run to the north and to the east.
    pub slope: [f64; 2],
}

impl MeanPlane {
    /// Height above a place (m).
    pub fn at(&self, [north, east]: [f64; 2]) -> f64 {
        self.height + self.slope[0] * north + self.slope[1] * east
    }
}

/// Mean plane of the used samples, and heights above it at all places: data where used, filled elsewhere.
pub fn fill(patch: &Patch, places: &[Place]) -> (MeanPlane, Vec<f64>) {
    let plane = mean_plane(patch, places);
    let columns = patch.count[1];
    let above = |(index, height): (usize, &f64)| {
        let place = patch.place(index / columns, index % columns);
        if places[index] == Place::Used { height - plane.at(place) } else { f64::NAN }
    };
    let mut heights: Vec<f64> = patch.heights.par_iter().enumerate().map(above).collect();
    fill_grid(&mut heights, patch.count);
    (plane, heights)
}

fn mean_plane(patch: &Patch, places: &[Place]) -> MeanPlane {
    // Coordinates about the middle and in half sizes: the sums stay well scaled.
    let half = [0, 1].map(|k| (0.5 * (patch.count[k] - 1) as f64 * patch.step[k]).max(patch.step[k]));
    let middle = [0, 1].map(|k| patch.first[k] + half[k]);
    let columns = patch.count[1];
    let line_sums = |line: usize| {
        let mut sums = [0.0; 9];
        for column in (0..columns).filter(|column| places[line * columns + column] == Place::Used) {
            let place = patch.place(line, column);
            let [x, y] = [0, 1].map(|k| (place[k] - middle[k]) / half[k]);
            let h = patch.heights[line * columns + column];
            let terms = [1.0, x, y, x * x, x * y, y * y, h, h * x, h * y];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        }
        sums
    };
    let lines: Vec<[f64; 9]> = (0..patch.count[0]).into_par_iter().map(line_sums).collect();
    let mut sums = [0.0; 9];
    lines.iter().for_each(|line| sums.iter_mut().zip(line).for_each(|(sum, term)| *sum += term));
    let [n, x, y, xx, xy, yy, h, hx, hy] = sums;
    let n = n.max(1.0);
    let (xx, xy, yy) = (xx - x * x / n, xy - x * y / n, yy - y * y / n);
    let (hx, hy) = (hx - h * x / n, hy - h * y / n);
    let determinant = xx * yy - xy * xy;
    // Samples on one line do not tell a plane: then its slopes are 0.
    let slope = if determinant > 1e-9 * n * n {
        [(hx * yy - hy * xy) / determinant, (hy * xx - hx * xy) / determinant]
    } else {
        [0.0; 2]
    };
    let height = (h - slope[0] * x - slope[1] * y) / n;
    let slope = [0, 1].map(|k| slope[k] / half[k]);
    MeanPlane { height: height - slope[0] * middle[0] - slope[1] * middle[1], slope }
}

/// Fills the NaN of a grid; without any height it becomes 0.
pub(crate) fn fill_grid(heights: &mut [f64], count: [usize; 2]) {
    let voids: Vec<usize> = (0..heights.len()).filter(|&index| heights[index].is_nan()).collect();
    if voids.is_empty() {
        return;
    }
    if heights.len() == 1 {
        heights[0] = 0.0;
        return;
    }
    let (mut coarse, shape) = averaged(heights, count);
    fill_grid(&mut coarse, shape);
    for &index in &voids {
        heights[index] = between(&coarse, shape, [index / count[1], index % count[1]]);
    }
    for _ in 0..SWEEPS {
        let relaxed: Vec<f64> = voids.par_iter().map(|&index| neighbours(heights, count, index)).collect();
        voids.iter().zip(relaxed).for_each(|(&index, height)| heights[index] = height);
    }
}

/// Means of the heights of 2 x 2 cells, NaN where all are void.
fn averaged(heights: &[f64], [lines, columns]: [usize; 2]) -> (Vec<f64>, [usize; 2]) {
    let shape = [lines.div_ceil(2), columns.div_ceil(2)];
    let cell = |index: usize| {
        let (line, column) = (index / shape[1] * 2, index % shape[1] * 2);
        let (mut sum, mut held) = (0.0, 0);
        for line in line..(line + 2).min(lines) {
            for height in &heights[line * columns + column..line * columns + (column + 2).min(columns)] {
                if !height.is_nan() {
                    sum += height;
                    held += 1;
                }
            }
        }
        if held > 0 { sum / f64::from(held) } else { f64::NAN }
    };
    ((0..shape[0] * shape[1]).into_par_iter().map(cell).collect(), shape)
}

/// Bilinear from the grid with half as many cells.
fn between(coarse: &[f64], shape: [usize; 2], fine: [usize; 2]) -> f64 {
    // The centre of a fine cell lies a quarter of a coarse cell from that of its parent.
    let [(a, b), (c, d)] = [0, 1].map(|k| {
        let parent = fine[k] / 2;
        let other =
            if fine[k].is_multiple_of(2) { parent.saturating_sub(1) } else { (parent + 1).min(shape[k] - 1) };
        (parent, other)
    });
    let at = |line: usize, column: usize| coarse[line * shape[1] + column];
    0.5625 * at(a, c) + 0.1875 * (at(a, d) + at(b, c)) + 0.0625 * at(b, d)
}

/// Mean of the up to four neighbours.
fn neighbours(heights: &[f64], [lines, columns]: [usize; 2], index: usize) -> f64 {
    let (line, column) = (index / columns, index % columns);
    let (mut sum, mut count) = (0.0, 0);
    let mut take = |there: bool, index: usize| {
        if there {
            sum += heights[index];
            count += 1;
        }
    };
    take(line > 0, index.wrapping_sub(columns));
    take(line + 1 < lines, index + columns);
    take(column > 0, index.wrapping_sub(1));
    take(column + 1 < columns, index + 1);
    sum / f64::from(count)
}

#[cfg(test)]
mod tests {
    use super::{fill, fill_grid};
    use crate::fit::Place;
    use crate::patch::Patch;

    fn disc(side: usize, radius: f64, height: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let at = |index: usize| {
            let (x, y) = ((index / side) as f64, (index % side) as f64);
            let (a, b) = (x - 0.5 * side as f64, y - 0.5 * side as f64);
            if a * a + b * b < radius * radius { f64::NAN } else { height(x, y) }
        };
        (0..side * side).map(at).collect()
    }

    #[test]
    fn a_filled_void_stays_between_its_neighbours() {
        let mut heights = disc(101, 40.0, |x, y| if (x + y) as i64 % 3 == 0 { 5.0 } else { -2.0 });
        fill_grid(&mut heights, [101, 101]);
        assert!(heights.iter().all(|h| (-2.0..=5.0).contains(h)));
    }

    #[test]
    fn a_harmonic_field_comes_back_nearly() {
        let field = |x: f64, y: f64| x * x - y * y;
        let mut heights = disc(64, 20.0, field);
        fill_grid(&mut heights, [64, 64]);
        let worst = (0..64 * 64)
            .map(|i| (heights[i] - field((i / 64) as f64, (i % 64) as f64)).abs())
            .fold(0.0, f64::max);
        assert!(worst < 0.03 * 64.0 * 64.0, "{worst}");
    }

    #[test]
    fn a_plane_is_taken_out_exactly() {
        let (count, step, first) = ([20, 30], [2.0, 3.0], [0.5, 0.25]);
        let mut heights = Vec::new();
        for index in 0..600 {
            let (x, y) = (0.5 + (index / 30) as f64 * 2.0, 0.25 + (index % 30) as f64 * 3.0);
            heights.push(if index % 7 == 0 { f64::NAN } else { 100.0 + 0.3 * x - 0.2 * y });
        }
        let places: Vec<Place> =
            heights.iter().map(|h| if h.is_nan() { Place::Void } else { Place::Used }).collect();
        let patch = Patch { first, step, count, heights, file_first: [0; 2], file_step: [1; 2] };
        let (plane, filled) = fill(&patch, &places);
        assert!((plane.height - 100.0).abs() < 1e-11 && (plane.slope[0] - 0.3).abs() < 1e-13);
        assert!((plane.slope[1] + 0.2).abs() < 1e-13);
        assert!(filled.iter().all(|h| h.abs() < 1e-11));
    }
}
