//! Grounds of which height and slope are known everywhere.

use landscape::{BankError, CornerWords, Level};
use serde::Deserialize;

use crate::formula::basis::direct_sum;

/// Ground that a scene is drawn over.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum CartridgeGround {
    /// `height + slope_north x + slope_east y`.
    Plane {
        /// At the origin (m).
        height_m: f64,
        /// Slope to the north.
        slope_north: f64,
        /// Slope to the east.
        slope_east: f64,
    },
    /// `sum c[i][j] X^i Y^j`, `X = (x - centre) / unit` to the north, `Y` to the east. Up to degree 5 in each it is
    /// what the array can hold.
    Polynomial {
        /// North and east of the point around which it is written (m).
        centre_m: [f64; 2],
        /// Length that X and Y are counted in (m).
        unit_m: f64,
        /// Coefficients (m): row i has those of `X^i`.
        coefficients_m: Vec<Vec<f64>>,
    },
    /// Heights of the rows of corners from south to north, level at each row, the same along each row.
    Rows {
        /// One height a row (m).
        heights_m: Vec<f64>,
    },
    /// All words 0 but one, which takes each place of `words` at each of `corners` in turn.
    OneWord {
        /// Corners, each to the north and to the east.
        corners: Vec<[usize; 2]>,
        /// Words `3 p + q`: orders of the derivative to the north and to the east.
        words: Vec<usize>,
        /// Value of the word (m).
        value_m: f64,
    },
    /// `f(m,n;p,q) = ((17m + 29n + 37p + 43q + 11mp + 5nq + 3pq + 13mn) mod 23) - 11` (check table 23.2b).
    Lattice,
}

/// Corners either way at most, and corners of a polynomial's rows at most.
const MOST_CORNERS: usize = 4096;

impl CartridgeGround {
    /// Each ground that is meant, alone.
    pub fn variants(&self) -> Vec<Self> {
        let Self::OneWord { corners, words, value_m } = self else { return vec![self.clone()] };
        let at = |&corner: &[usize; 2]| {
            let one = move |&word: &usize| Self::OneWord {
                corners: vec![corner],
                words: vec![word],
                value_m: *value_m,
            };
            words.iter().map(one).collect::<Vec<_>>()
        };
        corners.iter().flat_map(at).collect()
    }

    /// Whether its numbers fit together and fit on so many corners.
    pub fn check(&self, corners: [usize; 2]) -> Result<(), String> {
        if corners.iter().any(|&count| count > MOST_CORNERS) || corners[0] * corners[1] > MOST_CORNERS * 256 {
            return Err(format!(
                "corners = {corners:?}: expected at most {MOST_CORNERS} each, a million in all"
            ));
        }
        match self {
            Self::Rows { heights_m } if heights_m.len() != corners[0] => Err(format!(
                "ground.heights_m has {} heights: expected {}, one a row",
                heights_m.len(),
                corners[0]
            )),
            Self::OneWord { words, .. } if words.iter().any(|&word| word > 8) => {
                Err("ground.words: expected 0 to 8, that is 3 p + q".into())
            }
            Self::Polynomial { unit_m, coefficients_m, .. } => {
                let is_small = coefficients_m.len() <= 6 && coefficients_m.iter().all(|row| row.len() <= 6);
                if *unit_m > 0.0 && is_small {
                    return Ok(());
                }
                Err("ground: expected unit_m above 0 and at most 6 rows of 6 coefficients, degree 5".into())
            }
            _ => Ok(()),
        }
    }

    /// The level that stores it, from the origin on.
    pub fn level(&self, region_size: f64, corners: [usize; 2]) -> Result<Level, BankError> {
        let place = |index: usize| [index / corners[1], index % corners[1]];
        let words = (0..corners[0] * corners[1]).map(|index| self.words(place(index), region_size)).collect();
        Level::new(region_size, [0.0; 2], corners, words)
    }

    /// The nine words of a corner, `3 p + q`.
    pub fn words(&self, [m, n]: [usize; 2], region_size: f64) -> CornerWords {
        let mut words = [0.0; 9];
        match self {
            Self::Plane { .. } | Self::Polynomial { .. } => {
                let place = [m, n].map(|index| index as f64 * region_size);
                for (word, value) in words.iter_mut().enumerate() {
                    let orders = [word / 3, word % 3];
                    let scale = (0..orders[0] + orders[1]).fold(1.0, |scale, _| scale * region_size);
                    *value = scale * self.derivative(orders, place);
                }
            }
            Self::Rows { heights_m } => words[0] = heights_m.get(m).copied().unwrap_or(0.0),
            Self::OneWord { corners, words: places, value_m } => {
                if corners[0] == [m, n] {
                    words[places[0]] = *value_m;
                }
            }
            Self::Lattice => words = lattice(m, n),
        }
        words
    }

    /// Derivative of a plane or polynomial at a place (m), `orders` to the north and to the east.
    fn derivative(&self, orders: [usize; 2], [x, y]: [f64; 2]) -> f64 {
        match self {
            Self::Plane { height_m, slope_north, slope_east } => match orders {
                [0, 0] => height_m + slope_north * x + slope_east * y,
                [1, 0] => *slope_north,
                [0, 1] => *slope_east,
                _ => 0.0,
            },
            Self::Polynomial { centre_m, unit_m, coefficients_m } => {
                let [x, y] = [(x - centre_m[0]) / unit_m, (y - centre_m[1]) / unit_m];
                let in_y = |row: &Vec<f64>| horner(row, orders[1], y);
                let rows: Vec<f64> = coefficients_m.iter().map(in_y).collect();
                let units = (0..orders[0] + orders[1]).fold(1.0, |units, _| units * unit_m);
                horner(&rows, orders[0], x) / units
            }
            _ => 0.0,
        }
    }

    /// Height (m) and slopes to the north and east at a place (m): a polynomial as it is written, else the direct sum of
    /// the four corners' words.
    pub fn surface(&self, place: [f64; 2], region_size: f64, corners: [usize; 2]) -> [f64; 3] {
        match self {
            Self::Plane { .. } | Self::Polynomial { .. } => {
                [[0, 0], [1, 0], [0, 1]].map(|orders| self.derivative(orders, place))
            }
            _ => {
                // Pointers clamp at the edge of what is stored (6.5).
                let clamp = |index: i64, count: usize| index.clamp(0, count as i64 - 1) as usize;
                let words =
                    |[m, n]: [i64; 2]| self.words([clamp(m, corners[0]), clamp(n, corners[1])], region_size);
                direct_sum(words, place.map(|length| length / region_size), region_size)
            }
        }
    }
}

/// Derivative of some order of `c[0] + c[1] t + ...`.
fn horner(coefficients: &[f64], order: usize, t: f64) -> f64 {
    let factor = |power: usize| (0..order).fold(1.0, |factor, k| factor * (power - k) as f64);
    let powers = (order..coefficients.len()).rev();
    powers.fold(0.0, |sum, power| sum * t + coefficients[power] * factor(power))
}

fn lattice(m: usize, n: usize) -> CornerWords {
    std::array::from_fn(|k| {
        let (p, q) = (k / 3, k % 3);
        let sum = 17 * m + 29 * n + 37 * p + 43 * q + 11 * m * p + 5 * n * q + 3 * p * q + 13 * m * n;
        (sum % 23) as f64 - 11.0
    })
}
