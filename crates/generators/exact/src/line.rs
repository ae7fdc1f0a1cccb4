//! A straight line over the ground: a line of sight, or a sunbeam backwards.

use crate::bend::Bend;

/// The line's height over the place at range s is `height + rise s` and the drop of the ground there (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Where range is 0: north, east (m).
    pub origin: [f64; 2],
    /// Unit vector over the ground: north, east.
    pub direction: [f64; 2],
    /// Height at its begin (m).
    pub height: f64,
    /// Tangent of its elevation.
    pub rise: f64,
    /// How the ground falls away under it.
    pub bend: Bend,
}

impl Line {
    /// Place at a range: north, east (m).
    pub fn place(&self, range: f64) -> [f64; 2] {
        std::array::from_fn(|axis| self.origin[axis] + range * self.direction[axis])
    }

    /// A height that the line does not come under between two ranges (m).
    pub fn lowest(&self, from: f64, to: f64) -> f64 {
        self.height + self.bend.drop(from) + (self.rise * from).min(self.rise * to)
    }

    /// Whether it stays above `ceiling`, heights at both ends of a plane over a stretch; curvature is taken at its
    /// least.
    pub fn stays_above(&self, ceiling: [f64; 2], [from, to]: [f64; 2]) -> bool {
        let floor = self.height + self.bend.drop(from);
        ceiling[0] < floor + self.rise * from && ceiling[1] < floor + self.rise * to
    }

    /// Its height at a range (m), where it rises.
    pub fn risen(&self, range: f64) -> f64 {
        match self.bend {
            Bend::Parabola(bend) => self.height + (bend * range + self.rise) * range,
            Bend::Sphere => self.height + self.bend.drop(range) + self.rise * range,
        }
    }

    /// `heights`, a polynomial in Bernstein form over a stretch, less the line's own: where it is positive the line
    /// is under the ground. What the sphere takes off is no polynomial, and left to who looks for roots.
    pub fn under<const N: usize>(&self, heights: &[f64; N], [from, to]: [f64; 2]) -> [f64; N] {
        let (start, length, n) = (from, to - from, (N - 1) as f64);
        let bend = self.bend.square();
        std::array::from_fn(|index| {
            let k = index as f64;
            let range = start + length * k / n;
            let square =
                start * start + length * (2.0 * start * k / n + length * k * (k - 1.0) / (n * (n - 1.0)));
            heights[index] - self.height - bend * square - self.rise * range
        })
    }
}
