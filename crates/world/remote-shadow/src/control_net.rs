//! Bernstein form of a region: control heights, and what they say about its bending.

use landscape::{CornerWords, Level};

/// Control heights of a region (m), `[i][j]` with i to the north; the ground lies within their hull.
type ControlNet = [[f64; 6]; 6];

/// Largest second derivatives of a stretch of ground, without sign (1/m): `[hxx, hxy, hyy]`.
pub(crate) type Bends = [f64; 3];

/// Bending of a region of `level`.
pub(crate) fn bends(level: &Level, region: [usize; 2]) -> Bends {
    let net = control_net(level.region(region));
    let square = level.region_size() * level.region_size();
    let along = |at: &dyn Fn(usize, usize) -> f64| {
        let second = |i: usize, j: usize| (at(i, j) - 2.0 * at(i + 1, j) + at(i + 2, j)).abs();
        20.0 / square * largest((0..4).flat_map(|i| (0..6).map(move |j| (i, j))), second)
    };
    let twist = |i: usize, j: usize| (net[i][j] - net[i + 1][j] - net[i][j + 1] + net[i + 1][j + 1]).abs();
    let mixed = 25.0 / square * largest((0..5).flat_map(|i| (0..5).map(move |j| (i, j))), twist);
    [along(&|i, j| net[i][j]), mixed, along(&|i, j| net[j][i])]
}

fn largest(places: impl Iterator<Item = (usize, usize)>, value: impl Fn(usize, usize) -> f64) -> f64 {
    places.map(|(i, j)| value(i, j)).fold(0.0, f64::max)
}

fn control_net(corners: [[&CornerWords; 2]; 2]) -> ControlNet {
    // Index 3 j + q: the six data along v, each with its control values along u.
    let along_u: [[f64; 6]; 6] = std::array::from_fn(|jq| {
        let (j, q) = (jq / 3, jq % 3);
        bezier(std::array::from_fn(|ip| corners[ip / 3][j][3 * (ip % 3) + q]))
    });
    std::array::from_fn(|i| bezier(std::array::from_fn(|jq| along_u[jq][i])))
}

/// Control values of the quintic with value, slope and second derivative given at 0 and at 1.
fn bezier([f0, d0, s0, f1, d1, s1]: [f64; 6]) -> [f64; 6] {
    [f0, f0 + d0 / 5.0, f0 + 0.4 * d0 + s0 / 20.0, f1 - 0.4 * d1 + s1 / 20.0, f1 - d1 / 5.0, f1]
}

#[cfg(test)]
mod tests {
    use super::bends;
    use landscape::relief::{Relief, Undulation};

    #[test]
    fn a_paraboloid_bends_by_its_coefficients() {
        // h = 0.01 x^2 + 0.02 x y - 0.03 y^2 over one region of 10 m.
        let words = |x: f64, y: f64| {
            let d = 10.0;
            let mut words = [0.0; 9];
            words[0] = 0.01 * x * x + 0.02 * x * y - 0.03 * y * y;
            words[3] = d * (0.02 * x + 0.02 * y);
            words[1] = d * (0.02 * x - 0.06 * y);
            (words[6], words[4], words[2]) = (0.02 * d * d, 0.02 * d * d, -0.06 * d * d);
            words
        };
        let corners = vec![words(0.0, 0.0), words(0.0, 10.0), words(10.0, 0.0), words(10.0, 10.0)];
        let level = landscape::Level::new(10.0, [0.0; 2], [2, 2], corners).unwrap();
        for (found, expected) in bends(&level, [0, 0]).into_iter().zip([0.02, 0.02, 0.06]) {
            assert!((found - expected).abs() < 1e-12, "{found}");
        }
    }

    #[test]
    fn slopes_change_no_faster_than_the_bends_say() {
        let mut relief = Relief::flat(3, [80.0, 80.0], 20.0);
        relief.undulation =
            Some(Undulation { rms_height: 5.0, hurst: 0.9, shortest: 60.0, longest: 200.0, waves: 100 });
        let level = relief.build().unwrap();
        let bends = bends(&level, [1, 2]);
        let step = 1e-3;
        for k in 0..100 {
            let (u, v) = (f64::from(k % 10) / 10.0, f64::from(k / 10) / 10.0);
            let slopes = |u, v| level.height_and_slopes([1, 2], [u, v]);
            let (here, north, east) = (slopes(u, v), slopes(u + step, v), slopes(u, v + step));
            let change = |a: f64, b: f64| (b - a).abs() / (step * 400.0);
            assert!(change(here[1], north[1]) <= bends[0] * 1.001 + 1e-9);
            assert!(change(here[1], east[1]) <= bends[1] * 1.001 + 1e-9);
            assert!(change(here[2], east[2]) <= bends[2] * 1.001 + 1e-9);
        }
    }
}
