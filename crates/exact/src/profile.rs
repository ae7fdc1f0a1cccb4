//! Terrain and craters along a line: a polynomial and multiples of distances from craters' centres.
//!
//! Bowls are quadratic in the distance rho from the centre, and rho^2 is quadratic in range; walls and rims have a
//! term linear in rho besides. Over a line rho is convex: it lies below its chord and above its tangent, and its
//! derivative grows. That bounds the sum and its derivative over any part of the line.

use crate::bernstein::{DEPTH, bracketed_root, halves, slope, value};

/// `weight * sqrt((s - nearest)^2 + miss)`: a multiple of the distance from a crater's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// Its factor.
    pub weight: f64,
    /// Range at which the line is nearest to the centre (m).
    pub nearest: f64,
    /// Square of the least distance (m^2).
    pub miss: f64,
}

impl Distance {
    /// Value and derivative with respect to range.
    fn at(&self, range: f64) -> [f64; 2] {
        let along = range - self.nearest;
        let rho = (along * along + self.miss).sqrt();
        let slope = if rho > 0.0 { along / rho } else { 0.0 };
        [self.weight * rho, self.weight * slope]
    }
}

/// What there is between two places of a profile.
struct Bounds {
    /// Values at both ends.
    ends: [f64; 2],
    /// A straight line above all distances together: its values at both ends.
    above: [f64; 2],
    /// Derivative of the distances, least and largest, with respect to the share of the part.
    slopes: [f64; 2],
}

/// The first share of the stretch from `from` to `to` (m) at which the sum of `polynomial` (over the stretch) and
/// `distances` is 0 or above.
pub fn first_reach<const N: usize>(
    polynomial: &[f64; N],
    distances: &[Distance],
    [from, to]: [f64; 2],
) -> Option<f64> {
    if distances.is_empty() {
        return crate::bernstein::first_reach(polynomial);
    }
    Search { distances, from, length: to - from }.first(polynomial, 0.0, 1.0, DEPTH)
}

struct Search<'a> {
    distances: &'a [Distance],
    from: f64,
    length: f64,
}

impl Search<'_> {
    fn first<const N: usize>(&self, c: &[f64; N], low: f64, width: f64, depth: u32) -> Option<f64> {
        let bounds = self.bounds(low, width);
        if c[0] + bounds.ends[0] >= 0.0 {
            return Some(low);
        }
        let rises = (1..N).map(|k| (N - 1) as f64 * (c[k] - c[k - 1]));
        let (least, most) = rises.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), r| (l.min(r), m.max(r)));
        if most + bounds.slopes[1] <= 0.0 || stays_below(c, bounds.above) {
            return None;
        }
        if least + bounds.slopes[0] > 0.0 {
            let reached = c[N - 1] + bounds.ends[1] >= 0.0;
            return reached.then(|| low + width * self.only_root(c, low, width));
        }
        if depth == 0 {
            return Some(low);
        }
        let (left, right) = halves(c);
        let half = 0.5 * width;
        self.first(&left, low, half, depth - 1).or_else(|| self.first(&right, low + half, half, depth - 1))
    }

    fn bounds(&self, low: f64, width: f64) -> Bounds {
        let [from, to] = [low, low + width].map(|share| self.from + share * self.length);
        let half = 0.5 * (to - from);
        let mut bounds = Bounds { ends: [0.0; 2], above: [0.0; 2], slopes: [0.0; 2] };
        for distance in self.distances {
            let [first, middle, last] = [from, from + half, to].map(|range| distance.at(range));
            let tangent = [middle[0] - half * middle[1], middle[0] + half * middle[1]];
            let ends = [first[0], last[0]];
            let above = if distance.weight > 0.0 { ends } else { tangent };
            let slopes = [first[1].min(last[1]), first[1].max(last[1])];
            for end in 0..2 {
                bounds.ends[end] += ends[end];
                bounds.above[end] += above[end];
                bounds.slopes[end] += 2.0 * half * slopes[end];
            }
        }
        bounds
    }

    fn only_root<const N: usize>(&self, c: &[f64; N], low: f64, width: f64) -> f64 {
        bracketed_root(0.5, |share| {
            let range = self.from + (low + width * share) * self.length;
            let mut sum = [value(c, share), slope(c, share)];
            for distance in self.distances {
                let [value, slope] = distance.at(range);
                sum[0] += value;
                sum[1] += width * self.length * slope;
            }
            sum
        })
    }
}

fn stays_below<const N: usize>(c: &[f64; N], above: [f64; 2]) -> bool {
    let share = |k: usize| k as f64 / (N - 1) as f64;
    (0..N).all(|k| c[k] + above[0] + share(k) * (above[1] - above[0]) < 0.0)
}

#[cfg(test)]
mod tests {
    use super::{Distance, first_reach};
    use crate::bernstein::value;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]
        #[test]
        fn no_root_before_the_first(
            c in proptest::array::uniform11(-2.0..1.0f64),
            distances in proptest::collection::vec((-3.0..3.0f64, -1.0..4.0f64, 0.0..1.0f64), 1..4),
        ) {
            let distances: Vec<Distance> = distances
                .into_iter()
                .map(|(weight, nearest, miss)| Distance { weight, nearest, miss: miss * miss })
                .collect();
            let sum = |x: f64| {
                value(&c, x) + distances.iter().map(|each| each.at(1.0 + 2.0 * x)[0]).sum::<f64>()
            };
            let found = first_reach(&c, &distances, [1.0, 3.0]);
            let end = found.unwrap_or(1.0);
            for step in 0..=2000 {
                let x = f64::from(step) / 2000.0;
                prop_assert!(x > end - 1e-9 || sum(x) < 1e-12, "{} before {:?}", x, found);
            }
            if let Some(x) = found {
                prop_assert!(x == 0.0 && sum(x) >= 0.0 || sum(x).abs() < 1e-9, "{} at {}", sum(x), x);
            }
        }
    }

    #[test]
    fn a_crest_that_only_just_reaches() {
        // 1 - |s - 1| - 1 touches 0 at s = 1: lowered it does not reach, raised it does.
        let crest = [Distance { weight: -1.0, nearest: 1.0, miss: 0.0 }];
        let level = |height: f64| first_reach(&[height; 11], &crest, [0.0, 3.0]);
        assert_eq!(level(-1e-13), None);
        assert!((level(1e-6).unwrap() - (1.0 - 1e-6) / 3.0).abs() < 1e-12);
    }
}
