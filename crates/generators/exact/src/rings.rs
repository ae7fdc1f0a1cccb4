//! One crater along a straight line: within each of its rings a quadratic in range and a multiple of the distance
//! from its centre (section 9).

use features::Crater;

use crate::line::Line;
use crate::profile::Distance;

/// A crater as a line passes it.
#[derive(Debug, Clone, Copy)]
pub struct Passage {
    crater: Crater,
    nearest: f64,
    miss: f64,
}

/// What craters add along a stretch: `constant + linear x + square x^2` in its share x, and distances.
#[derive(Debug, Clone, Default)]
pub struct Added {
    constant: f64,
    linear: f64,
    square: f64,
    /// Sum of the crests that it may come to (m).
    pub crests: f64,
    /// What is not a polynomial.
    pub distances: Vec<Distance>,
}

impl Added {
    /// Makes it the sum of no craters, and keeps its buffer.
    pub fn clear(&mut self) {
        let distances = std::mem::take(&mut self.distances);
        *self = Self { distances, ..Self::default() };
        self.distances.clear();
    }

    /// Whether no crater adds anything.
    pub fn is_nothing(&self) -> bool {
        self.constant == 0.0 && self.linear == 0.0 && self.square == 0.0 && self.distances.is_empty()
    }

    /// Adds the quadratic to a polynomial in Bernstein form over the same stretch.
    pub fn to<const N: usize>(&self, polynomial: &mut [f64; N]) {
        let n = (N - 1) as f64;
        for (index, value) in polynomial.iter_mut().enumerate() {
            let k = index as f64;
            *value += self.constant + self.linear * k / n + self.square * k * (k - 1.0) / (n * (n - 1.0));
        }
    }
}

impl Passage {
    /// `None` if the line passes outside.
    pub fn new(crater: Crater, line: &Line) -> Option<Self> {
        let to_centre: [f64; 2] = std::array::from_fn(|axis| crater.centre()[axis] - line.origin[axis]);
        let [north, east] = line.direction;
        let nearest = to_centre[0] * north + to_centre[1] * east;
        let across = to_centre[0] * east - to_centre[1] * north;
        let miss = across * across;
        (miss < crater.outer() * crater.outer()).then_some(Self { crater, nearest, miss })
    }

    /// Ranges strictly between `from` and `to` at which the line crosses one of the crater's circles.
    pub fn crossings(&self, [from, to]: [f64; 2], cuts: &mut Vec<f64>) {
        for radius in self.crater.rings().map(|ring| ring.outer) {
            let square = radius * radius - self.miss;
            if square > 0.0 {
                let half = square.sqrt();
                let both = [self.nearest - half, self.nearest + half];
                cuts.extend(both.into_iter().filter(|&cut| cut > from && cut < to));
            }
        }
    }

    /// Adds the ring in which the stretch from `from` to `to` lies.
    pub fn add(&self, [from, to]: [f64; 2], sum: &mut Added) {
        let middle = 0.5 * (from + to) - self.nearest;
        let rho = (middle * middle + self.miss).sqrt();
        let Some(ring) = self.crater.rings().find(|ring| rho < ring.outer) else { return };
        let [a, b, c] = ring.terms;
        let (start, length) = (from - self.nearest, to - from);
        sum.constant += c + a * (start * start + self.miss);
        sum.linear += 2.0 * a * start * length;
        sum.square += a * length * length;
        if b != 0.0 {
            sum.distances.push(Distance { weight: b, nearest: self.nearest, miss: self.miss });
        }
        if b > 0.0 {
            sum.crests += self.crater.rim();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Added, Passage};
    use crate::bend::Bend;
    use crate::line::Line;
    use features::{Crater, Shape};
    use landscape::bernstein::value;
    use proptest::prelude::*;

    fn shape(kind: u8, r: [f64; 3]) -> Shape {
        let [r1, r2, r3] = [r[0], r[0] + r[1], r[0] + r[1] + r[2]];
        match kind {
            0 => Shape::Bowl { r1 },
            1 => Shape::RimmedBowl { r1, r2 },
            _ => Shape::FlatFloor { r1, r2, r3 },
        }
    }

    proptest! {
        #[test]
        fn the_sum_along_a_line_is_the_profile(
            kind in 0..3u8, radii in proptest::array::uniform3(0.5..20.0f64),
            centre in proptest::array::uniform2(-30.0..30.0f64), azimuth in 0.0..7.0f64,
        ) {
            let rim = if kind == 0 { 0.0 } else { 1.5 };
            let crater = Crater::new(centre, shape(kind, radii), 4.0, rim).unwrap();
            let line = Line {
                origin: [3.0, -5.0], direction: [libm::cos(azimuth), libm::sin(azimuth)], height: 0.0, rise: 0.0,
                bend: Bend::FLAT,
            };
            let ends = [2.0, 80.0];
            let mut cuts = vec![ends[0], ends[1]];
            let passage = Passage::new(crater, &line);
            passage.iter().for_each(|passage| passage.crossings(ends, &mut cuts));
            cuts.sort_by(f64::total_cmp);
            for piece in cuts.windows(2) {
                let piece = [piece[0], piece[1]];
                let mut added = Added::default();
                passage.iter().for_each(|passage| passage.add(piece, &mut added));
                let mut polynomial = [0.0; 11];
                added.to(&mut polynomial);
                for step in 0..=8 {
                    let share = f64::from(step) / 8.0;
                    let range = piece[0] + share * (piece[1] - piece[0]);
                    let [x, y] = line.place(range);
                    let rho = libm::hypot(x - centre[0], y - centre[1]);
                    let distances: f64 = added
                        .distances
                        .iter()
                        .map(|d| d.weight * libm::hypot(range - d.nearest, d.miss.sqrt()))
                        .sum();
                    let sum = value(&polynomial, share) + distances;
                    prop_assert!((sum - crater.profile(rho)[0]).abs() < 1e-10, "{} at {}", sum, rho);
                    prop_assert!(sum <= added.crests + 1e-10);
                }
            }
        }
    }
}
