//! What craters do to the grain of texture (report II.A: a texture parameter for each kind of feature).
//!
//! The report leaves shadows too small to be drawn to this parameter: rubble about a fresh crater is coarser than the soil, dust in
//! an old one is finer. Our reading: each crater type has a gain of the grain in the middle of its craters, which goes over to 1 at
//! the footprint's edge as `1 - rho^2 / R^2` does. Where craters lie on one another, what they add to the gain adds up.

use features::Features;

/// Largest gain that a crater type may have.
pub const MOST_GAIN: f64 = 8.0;

/// Gain of the grain of texture in the middle of craters, type by type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CraterGrain {
    /// Of types 1, 2 and 3, less 1: what a crater adds to the gain in its middle.
    added: [f64; 3],
}

impl CraterGrain {
    /// The gains of crater types 1, 2 and 3, each 0 to [`MOST_GAIN`]; none where all are 1, because nothing is changed then.
    pub fn new(gains: [f64; 3]) -> Option<Self> {
        (gains != [1.0; 3]).then(|| Self { added: gains.map(|gain| gain - 1.0) })
    }

    /// What a crater of type `kind` (1 to 3) adds to the gain in its middle, -1 to [`MOST_GAIN`] - 1.
    pub fn added(&self, kind: u32) -> f64 {
        self.added[kind as usize - 1]
    }

    /// The most that a crater of any type adds to the gain, or takes from it.
    pub fn full_scale(&self) -> f64 {
        self.added.iter().fold(0.0, |most, added| added.abs().max(most))
    }

    /// Gain of the grain among `features` at (x, y) (m): 1 outside of craters, never below 0.
    pub fn gain(&self, features: &Features, x: f64, y: f64) -> f64 {
        (1.0 + features.nearness(x, y, |kind| self.added(kind))).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use features::{Crater, Features, Shape};

    use super::CraterGrain;

    #[test]
    fn the_gain_rises_from_the_edge_to_the_middle_and_adds_up() {
        let bowl = |x: f64| Crater::new([x, 0.0], Shape::Bowl { r1: 10.0 }, 1.0, 0.0).unwrap();
        let rimmed = Crater::new([40.0, 0.0], Shape::RimmedBowl { r1: 4.0, r2: 8.0 }, 1.0, 0.1).unwrap();
        let features = Features::new(vec![bowl(0.0), bowl(12.0), rimmed]);
        let grain = CraterGrain::new([3.0, 0.0, 1.0]).unwrap();
        let at = |x: f64| grain.gain(&features, x, 0.0);
        assert_eq!(at(0.0), 3.0);
        assert!(
            (at(-5.0) - 2.5).abs() < 1e-15,
            "a quarter of the square of the radius is gone: {}",
            at(-5.0)
        );
        assert!((at(6.0) - (1.0 + 2.0 * 0.64 + 2.0 * 0.64)).abs() < 1e-15, "two bowls add up: {}", at(6.0));
        assert_eq!([at(-10.0), at(25.0)], [1.0; 2], "outside of craters");
        assert!((at(44.0) - 0.25).abs() < 1e-15, "the rim belongs to the footprint: {}", at(44.0));
        let smooth = CraterGrain::new([0.0; 3]).unwrap();
        assert_eq!(smooth.gain(&features, 6.0, 0.0), 0.0, "no grain is less than none");
    }

    #[test]
    fn gains_of_one_change_nothing() {
        assert_eq!(CraterGrain::new([1.0; 3]), None);
    }
}
