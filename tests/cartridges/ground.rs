//! Grounds of which height and slope are known everywhere.

use landscape::Level;
use lunoid_tests::{level_of, plane};
use serde::Deserialize;

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Ground {
    /// `height + slope_north x + slope_east y`.
    Plane { height_m: f64, slope_north: f64, slope_east: f64 },
    /// Heights of the rows of corners from south to north, level at each row, the same along each row.
    Rows { heights_m: Vec<f64> },
    /// All words 0 but one, which takes each place of `words` at each of `corners` in turn.
    OneWord { corners: Vec<[usize; 2]>, words: Vec<usize>, value_m: f64 },
    /// The lattice of check table 23.2b.
    Lattice,
}

impl Ground {
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

    /// The level that stores it, from the origin on.
    pub fn level(&self, region_size: f64, corners: [usize; 2]) -> Level {
        let level =
            |words: &dyn Fn(usize, usize) -> [f64; 9]| level_of(region_size, [0.0; 2], corners, words);
        match self {
            &Self::Plane { height_m, slope_north, slope_east } => {
                level(&plane(region_size, height_m, [slope_north, slope_east]))
            }
            Self::Rows { heights_m } => level(&|m, _| {
                let mut words = [0.0; 9];
                words[0] = heights_m[m];
                words
            }),
            Self::OneWord { corners, words: places, value_m } => level(&|m, n| {
                let mut words = [0.0; 9];
                if corners[0] == [m, n] {
                    words[places[0]] = *value_m;
                }
                words
            }),
            Self::Lattice => level(&lattice),
        }
    }
}

fn lattice(m: usize, n: usize) -> [f64; 9] {
    std::array::from_fn(|k| {
        let (p, q) = (k / 3, k % 3);
        let sum = 17 * m + 29 * n + 37 * p + 43 * q + 11 * m * p + 5 * n * q + 3 * p * q + 13 * m * n;
        (sum % 23) as f64 - 11.0
    })
}
