//! One region as a Bernstein patch: bounds above it, and its profile along a straight stretch.
//!
//! The 36 words of 5.1 are Hermite data of degree (5, 5); the same surface has 36 control heights over the places
//! `(i, j) / 5`. Cut down to the rectangle whose diagonal is the stretch, its control heights add up along the
//! anti-diagonals to the profile of degree 10.

use crate::{CornerWords, Level};

use crate::bernstein::{Coefficients, DEGREE};

/// Control heights `[i][j]` (m), i to the north, j to the east.
#[derive(Debug, Clone)]
pub struct Patch([[f64; 6]; 6]);

/// A plane that the ground of a region nowhere rises above: `c + u * north + v * east` (m; u, v in regions).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UpperPlane {
    c: f64,
    north: f64,
    east: f64,
}

impl UpperPlane {
    /// Height at a local place (m).
    pub fn height(&self, [u, v]: [f64; 2]) -> f64 {
        self.c + u * self.north + v * self.east
    }

    /// Its largest height over the region (m).
    pub fn highest(&self) -> f64 {
        self.c + self.north.max(0.0) + self.east.max(0.0)
    }
}

impl Patch {
    /// The patch of a stored region.
    pub fn new(level: &Level, region: [usize; 2]) -> Self {
        let corners = level.region(region);
        let mut controls = [[0.0; 6]; 6];
        for i in 0..2 {
            for j in 0..2 {
                place(&mut controls, corners[i][j], i, j);
            }
        }
        Self(controls)
    }

    /// A plane above the region, close to it where the region bends little: over control places a plane's control
    /// heights are its heights, so the largest difference of control heights bounds the difference of surfaces.
    pub fn upper_plane(&self) -> UpperPlane {
        let b = &self.0;
        let north = 0.5 * (b[5][0] + b[5][5] - b[0][0] - b[0][5]);
        let east = 0.5 * (b[0][5] + b[5][5] - b[0][0] - b[5][0]);
        let (mut c, mut largest) = (f64::NEG_INFINITY, 0.0_f64);
        for i in 0..6 {
            for j in 0..6 {
                c = c.max(b[i][j] - north * i as f64 / 5.0 - east * j as f64 / 5.0);
                largest = largest.max(b[i][j].abs());
            }
        }
        // Rounding of the lines above, and of places that leave the region by a rounding error.
        UpperPlane { c: c + 1e-13 * largest, north, east }
    }

    /// Height along the straight stretch between two local places, degree 10 in the share of the stretch.
    pub fn along(&self, from: [f64; 2], to: [f64; 2]) -> Coefficients {
        let by_u = times_controls(&restriction(from[0], to[0]), &self.0);
        let by_v = restriction(from[1], to[1]);
        let mut sums = [0.0; DEGREE + 1];
        for k in 0..6 {
            for m in 0..6 {
                let control: f64 = (0..6).map(|j| by_u[k][j] * by_v[m][j]).sum();
                sums[k + m] += BINOMIAL_5[k] * BINOMIAL_5[m] * control;
            }
        }
        std::array::from_fn(|n| sums[n] / BINOMIAL_10[n])
    }
}

const BINOMIAL_5: [f64; 6] = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];
const BINOMIAL_10: Coefficients = [1.0, 10.0, 45.0, 120.0, 210.0, 252.0, 210.0, 120.0, 45.0, 10.0, 1.0];

/// Hermite to Bernstein: weights of value, first and second derivative in the three control heights next to an end.
const HERMITE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [1.0, 0.2, 0.0], [1.0, 0.4, 0.05]];

/// The nine control heights around corner (i, j), counted from it; odd derivatives turn at a far end.
fn place(controls: &mut [[f64; 6]; 6], words: &CornerWords, i: usize, j: usize) {
    let sign = |end: usize| if end == 0 { 1.0 } else { -1.0 };
    for a in 0..3 {
        let weights = [1.0, sign(i) * HERMITE[a][1], HERMITE[a][2]];
        let by_u: [f64; 3] = std::array::from_fn(|q| (0..3).map(|p| weights[p] * words[3 * p + q]).sum());
        for b in 0..3 {
            let height = by_u[0] + sign(j) * HERMITE[b][1] * by_u[1] + HERMITE[b][2] * by_u[2];
            controls[if i == 0 { a } else { 5 - a }][if j == 0 { b } else { 5 - b }] = height;
        }
    }
}

/// `[k][i]`: weight of control i of a quintic on `[0, 1]` in control k of the same quintic on `[a, b]`, which is
/// the coefficient of `x^i` in `(1 - a + a x)^(5-k) (1 - b + b x)^k` (blossom).
pub fn restriction(a: f64, b: f64) -> [[f64; 6]; 6] {
    let mut rows = [[0.0; 6]; 6];
    rows[0][0] = 1.0;
    for degree in 0..5 {
        rows[degree + 1] = times_linear(&rows[degree], b);
        for row in &mut rows[..=degree] {
            *row = times_linear(row, a);
        }
    }
    rows
}

fn times_linear(row: &[f64; 6], r: f64) -> [f64; 6] {
    let mut product = row.map(|value| (1.0 - r) * value);
    for i in 1..6 {
        product[i] += r * row[i - 1];
    }
    product
}

fn times_controls(weights: &[[f64; 6]; 6], controls: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let mut product = [[0.0; 6]; 6];
    for k in 0..6 {
        for i in 0..6 {
            for j in 0..6 {
                product[k][j] += weights[k][i] * controls[i][j];
            }
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::Patch;
    use crate::Level;
    use crate::bernstein::Coefficients;
    use proptest::prelude::*;

    fn level(words: Vec<f64>) -> Level {
        let corners = words.chunks(9).map(|nine| nine.try_into().unwrap()).collect();
        Level::new(40.0, [0.0; 2], [2, 2], corners).unwrap()
    }

    fn value(c: &Coefficients, x: f64) -> f64 {
        let mut row = c.to_vec();
        while row.len() > 1 {
            row = row.windows(2).map(|pair| pair[0] + x * (pair[1] - pair[0])).collect();
        }
        row[0]
    }

    proptest! {
        #[test]
        fn the_profile_is_the_direct_sum(
            words in proptest::collection::vec(-10.0..10.0f64, 36),
            ends in proptest::array::uniform4(0.0..1.0f64),
        ) {
            let level = level(words);
            let patch = Patch::new(&level, [0, 0]);
            let (from, to) = ([ends[0], ends[1]], [ends[2], ends[3]]);
            let profile = patch.along(from, to);
            let bounds = patch.upper_plane();
            for step in 0..=16 {
                let x = f64::from(step) / 16.0;
                let at = [from[0] + x * (to[0] - from[0]), from[1] + x * (to[1] - from[1])];
                let expected = level.height_and_slopes([0, 0], at)[0];
                prop_assert!((value(&profile, x) - expected).abs() < 1e-13);
                prop_assert!(bounds.height(at) >= expected);
            }
        }
    }

    #[test]
    fn the_plane_above_a_plane_is_the_plane() {
        let corner = |m: f64, n: f64| [5.0 + 3.0 * m - 2.0 * n, -2.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let words = [corner(0.0, 0.0), corner(0.0, 1.0), corner(1.0, 0.0), corner(1.0, 1.0)].concat();
        let plane = Patch::new(&level(words), [0, 0]).upper_plane();
        assert!((plane.height([0.3, 0.6]) - (5.0 + 0.9 - 1.2)).abs() < 1e-11);
    }
}
