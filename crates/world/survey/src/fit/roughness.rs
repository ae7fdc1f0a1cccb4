//! Energy of a bent plate over one region, in region units.
//!
//! The reflections u -> 1 - u and v -> 1 - v leave the energy as it is, so in words that are even or odd under
//! them the 36 x 36 matrix falls into four blocks of 9 x 9: a quarter of the work.

use landscape::basis::{FAR, NEAR};

/// Words of the four corners of a region: `[3 i + p][3 j + q]`.
pub type RegionWords = [[f64; 6]; 6];

/// A symmetric matrix over the six words of one axis.
pub type AxisMatrix = [[f64; 6]; 6];

type Block = [[f64; 9]; 9];

/// Integral over [0, 1] of the products of `order`-th derivatives of the six basis functions.
pub fn axis_matrix(order: usize) -> AxisMatrix {
    let functions: Vec<Vec<f64>> = NEAR.iter().chain(&FAR).map(|c| derivative(c, order)).collect();
    std::array::from_fn(|a| std::array::from_fn(|b| integral_of_product(&functions[a], &functions[b])))
}

fn derivative(coefficients: &[f64], order: usize) -> Vec<f64> {
    (0..order).fold(coefficients.to_vec(), |c, _| {
        c.iter().enumerate().skip(1).map(|(power, &value)| power as f64 * value).collect()
    })
}

fn integral_of_product(a: &[f64], b: &[f64]) -> f64 {
    let terms = a
        .iter()
        .enumerate()
        .flat_map(|(i, &x)| b.iter().enumerate().map(move |(j, &y)| x * y / (i + j + 1) as f64));
    terms.sum()
}

/// The energy as blocks by symmetry: index `2 * (odd in u) + (odd in v)`.
#[derive(Debug)]
pub struct Roughness([Block; 4]);

impl Roughness {
    /// `weight` times the integral of `h_uu^2 + 2 h_uv^2 + h_vv^2`.
    pub fn new(weight: f64) -> Self {
        let [m, k1, k2] = [0, 1, 2].map(|order| by_symmetry(&axis_matrix(order)));
        let terms = [(1.0, &k2, &m), (2.0, &k1, &k1), (1.0, &m, &k2)];
        let entry = |of: usize, a: usize, b: usize| {
            let term = |(factor, u, v): &(f64, &[AxisBlock; 2], &[AxisBlock; 2])| {
                factor * u[of / 2][a / 3][b / 3] * v[of % 2][a % 3][b % 3]
            };
            weight * terms.iter().map(term).sum::<f64>()
        };
        let block = |of: usize| std::array::from_fn(|a| std::array::from_fn(|b| entry(of, a, b)));
        Self(std::array::from_fn(block))
    }

    /// Half the gradient of the energy at `words`.
    pub fn apply(&self, words: &RegionWords) -> RegionWords {
        let mut blocks = split(words);
        for (matrix, block) in self.0.iter().zip(&mut blocks) {
            *block = product(matrix, block);
        }
        join(&blocks)
    }
}

fn product(matrix: &Block, vector: &[f64; 9]) -> [f64; 9] {
    let mut out = [0.0; 9];
    for (row, &value) in matrix.iter().zip(vector) {
        // The matrix is symmetric: its rows serve as columns, and the sums stay independent.
        for a in 0..9 {
            out[a] += row[a] * value;
        }
    }
    out
}

type AxisBlock = [[f64; 3]; 3];

/// Sign of derivative p under reflection.
const SIGN: [f64; 3] = [1.0, -1.0, 1.0];

/// The matrix between the even and between the odd functions `(g_0p +- (-1)^p g_1p) / 2`.
fn by_symmetry(matrix: &AxisMatrix) -> [AxisBlock; 2] {
    [1.0, -1.0].map(|parity: f64| {
        std::array::from_fn(|p| {
            std::array::from_fn(|q| {
                let (s, t) = (parity * SIGN[p], parity * SIGN[q]);
                let sum =
                    matrix[p][q] + t * matrix[p][3 + q] + s * matrix[3 + p][q] + s * t * matrix[3 + p][3 + q];
                0.25 * sum
            })
        })
    })
}

fn split(words: &RegionWords) -> [[f64; 9]; 4] {
    let mut out = [[0.0; 9]; 4];
    for p in 0..3 {
        for q in 0..3 {
            let (near, far) = (&words[p], &words[3 + p]);
            let fold = |s: f64| [near[q] + s * far[q], SIGN[q] * (near[3 + q] + s * far[3 + q])];
            let (even, odd) = (fold(SIGN[p]), fold(-SIGN[p]));
            out[0][3 * p + q] = even[0] + even[1];
            out[1][3 * p + q] = even[0] - even[1];
            out[2][3 * p + q] = odd[0] + odd[1];
            out[3][3 * p + q] = odd[0] - odd[1];
        }
    }
    out
}

/// Puts the four blocks back together: the adjoint of [`split`].
fn join(blocks: &[[f64; 9]; 4]) -> RegionWords {
    let mut out = [[0.0; 6]; 6];
    for p in 0..3 {
        for q in 0..3 {
            let [even_even, even_odd, odd_even, odd_odd] = blocks;
            let at = 3 * p + q;
            let (ee, eo, oe, oo) = (even_even[at], even_odd[at], odd_even[at], odd_odd[at]);
            let (near, far) = (ee + eo, SIGN[q] * (ee - eo));
            let (odd_near, odd_far) = (oe + oo, SIGN[q] * (oe - oo));
            out[p][q] = near + odd_near;
            out[p][3 + q] = far + odd_far;
            out[3 + p][q] = SIGN[p] * (near - odd_near);
            out[3 + p][3 + q] = SIGN[p] * (far - odd_far);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{RegionWords, Roughness, axis_matrix};

    fn words(seed: u64) -> RegionWords {
        std::array::from_fn(|a| {
            std::array::from_fn(|b| quantities::unit_interval(seed, &[a as u64, b as u64]) - 0.5)
        })
    }

    fn direct(orders: &[(f64, usize, usize)], c: &RegionWords) -> RegionWords {
        let mut out = [[0.0; 6]; 6];
        for &(factor, r, s) in orders {
            let (left, right) = (axis_matrix(r), axis_matrix(s));
            for (a, b, k, l) in (0..1296).map(|i| (i / 216, i / 36 % 6, i / 6 % 6, i % 6)) {
                out[a][b] += factor * left[a][k] * c[k][l] * right[l][b];
            }
        }
        out
    }

    #[test]
    fn mass_of_the_quintic_element() {
        let m = axis_matrix(0);
        for (found, expected) in [(m[0][0], 181.0 / 462.0), (m[1][1], 52.0 / 3465.0), (m[2][2], 1.0 / 9240.0)]
        {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    #[test]
    fn blocks_agree_with_the_direct_product() {
        let c = words(3);
        let expected = direct(&[(0.5, 2, 0), (1.0, 1, 1), (0.5, 0, 2)], &c);
        let found = Roughness::new(0.5).apply(&c);
        for (a, b) in (0..36).map(|i| (i / 6, i % 6)) {
            assert!((found[a][b] - expected[a][b]).abs() < 1e-11, "{a} {b}");
        }
    }

    #[test]
    fn a_plane_costs_the_plate_nothing() {
        // h = 1 + 2 u + 3 v: height and both slopes at the four corners.
        let mut c = [[0.0; 6]; 6];
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            c[3 * i][3 * j] = 1.0 + 2.0 * i as f64 + 3.0 * j as f64;
            c[3 * i + 1][3 * j] = 2.0;
            c[3 * i][3 * j + 1] = 3.0;
        }
        let out = Roughness::new(1.0).apply(&c);
        assert!(out.iter().flatten().all(|v| v.abs() < 1e-11), "{out:?}");
    }
}
