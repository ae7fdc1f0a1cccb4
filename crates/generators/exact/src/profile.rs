//! Terrain and craters along a line: a polynomial, multiples of distances from craters' centres, and the sphere.
//!
//! Bowls are quadratic in the distance rho from the centre, and rho^2 is quadratic in range; walls and rims have a
//! term linear in rho besides. Over a line rho is convex: it lies below its chord and above its tangent, and its
//! derivative grows. What the sphere takes off is concave: it lies above its chord and below its tangent, and its
//! derivative falls. That bounds the sum and its derivative over any part of the line.

use landscape::bernstein::{DEPTH, bracketed_root, halves, slope, value};

use crate::bend::{Bend, below_plane};

/// `weight * sqrt((s - nearest)^2 + miss)`: a multiple of the distance from a crater's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// Factor of the distance, of either sign.
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

/// What a profile has besides its polynomial.
#[derive(Debug, Clone, Copy)]
pub struct Terms<'a> {
    /// Distances from centres of craters.
    pub distances: &'a [Distance],
    /// The bend; a parabola is in the polynomial already.
    pub bend: Bend,
}

impl Terms<'_> {
    fn are_nothing(&self) -> bool {
        self.distances.is_empty() && self.bend != Bend::Sphere
    }

    /// Value and derivative with respect to range, added to those of `sum`.
    fn add_at(&self, range: f64, scale: f64, sum: &mut [f64; 2]) {
        let mut add = |[value, slope]: [f64; 2]| {
            sum[0] += value;
            sum[1] += scale * slope;
        };
        self.distances.iter().for_each(|distance| add(distance.at(range)));
        if self.bend == Bend::Sphere {
            add(below_plane(range));
        }
    }
}

/// What there is between two places of a profile.
struct Bounds {
    /// Values at both ends.
    ends: [f64; 2],
    /// A straight line above all terms together: its values at both ends.
    above: [f64; 2],
    /// Derivative of the terms, least and largest, with respect to the share of the part.
    slopes: [f64; 2],
}

/// A term at the begin, in the middle and at the end of a part: value and derivative with respect to range.
struct Term([[f64; 2]; 3]);

impl Bounds {
    /// Adds a term whose graph is `convex`, or else concave, over a part twice `half` (m) long.
    fn add(&mut self, Term([first, middle, last]): Term, half: f64, convex: bool) {
        let tangent = [middle[0] - half * middle[1], middle[0] + half * middle[1]];
        let ends = [first[0], last[0]];
        let above = if convex { ends } else { tangent };
        let slopes = [first[1].min(last[1]), first[1].max(last[1])];
        for end in 0..2 {
            self.ends[end] += ends[end];
            self.above[end] += above[end];
            self.slopes[end] += 2.0 * half * slopes[end];
        }
    }
}

/// The first share of the stretch from `from` to `to` (m) at which the sum of `polynomial` (over the stretch) and
/// `terms` is 0 or above.
pub fn first_reach<const N: usize>(
    polynomial: &[f64; N],
    terms: &Terms,
    [from, to]: [f64; 2],
) -> Option<f64> {
    if terms.are_nothing() {
        return landscape::bernstein::first_reach(polynomial);
    }
    Search { terms, from, length: to - from }.first(polynomial, 0.0, 1.0, DEPTH)
}

struct Search<'a> {
    terms: &'a Terms<'a>,
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
        let places = [from, from + half, to];
        for distance in self.terms.distances {
            bounds.add(Term(places.map(|range| distance.at(range))), half, distance.weight > 0.0);
        }
        if self.terms.bend == Bend::Sphere {
            bounds.add(Term(places.map(below_plane)), half, false);
        }
        bounds
    }

    fn only_root<const N: usize>(&self, c: &[f64; N], low: f64, width: f64) -> f64 {
        bracketed_root(0.5, |share| {
            let range = self.from + (low + width * share) * self.length;
            let mut sum = [value(c, share), slope(c, share)];
            self.terms.add_at(range, width * self.length, &mut sum);
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
    use super::{Distance, Terms, first_reach};
    use crate::bend::{Bend, below_plane};
    use landscape::bernstein::value;
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
            let found = first_reach(&c, &Terms { distances: &distances, bend: Bend::FLAT }, [1.0, 3.0]);
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
        let terms = Terms { distances: &crest, bend: Bend::FLAT };
        let level = |height: f64| first_reach(&[height; 11], &terms, [0.0, 3.0]);
        assert_eq!(level(-1e-13), None);
        assert!((level(1e-6).unwrap() - (1.0 - 1e-6) / 3.0).abs() < 1e-12);
    }
    /// A ray that just clears the sphere, one that just does not, one that goes deep.
    #[test]
    fn the_sphere_under_a_straight_ray() {
        let terms = Terms { distances: &[], bend: Bend::Sphere };
        let [from, to] = [1000.0, 1.7e6];
        let touch = 5e5;
        let [at, slope] = below_plane(touch);
        let reach = |lift: f64| {
            let under = |share: f64| -(at + slope * (from + share * (to - from) - touch)) - lift;
            let line: [f64; 11] = std::array::from_fn(|k| under(k as f64 / 10.0));
            first_reach(&line, &terms, [from, to]).map(|share| from + share * (to - from))
        };
        assert_eq!(reach(1e-6), None);
        for depth in [1e-3, 1.0, 1e4] {
            let range = reach(-depth).unwrap();
            let under = below_plane(range)[0] - (at + slope * (range - touch) - depth);
            assert!(range < touch && under.abs() < 1e-8, "{depth}: {range} {under}");
        }
    }
}
