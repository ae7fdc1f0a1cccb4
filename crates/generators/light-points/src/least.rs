//! The least diameter of a disc, which no pattern may miss.

use raster::Sampling;

use crate::error::{LightError, checked};

/// Least diameter of a light point's disc (pixels), wide enough to cover a sampling point wherever it lies.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct LeastDiameter(f64);

impl LeastDiameter {
    /// Least diameter without a wish (pixels). Chosen: wider than what any pattern misses.
    pub const DEFAULT: f64 = 1.5;

    /// A least diameter (pixels) for a sampling of the screen.
    ///
    /// # Errors If a disc of that diameter can miss all sampling points, or the value is not finite.
    pub fn new(pixels: f64, sampling: &Sampling) -> Result<Self, LightError> {
        let pixels = checked("least diameter of light points (pixels)", pixels, "a finite number", |_| true)?;
        let bound = sampling.widest_miss();
        if pixels > bound {
            Ok(Self(pixels))
        } else {
            Err(LightError::BelowPattern { pattern: sampling.pattern().name(), bound, given: pixels })
        }
    }

    /// The least diameter where sweeps that lie so many pixels apart (finite, at least 0) are the sampling: the default, or as much
    /// wider as they lie farther apart than pixels. So every disc meets a sweep.
    pub fn between_sweeps(spacing: f64) -> Self {
        Self(Self::DEFAULT * spacing.max(1.0))
    }

    /// The diameter (pixels), above 0.
    pub fn pixels(self) -> f64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raster::Pattern;

    #[test]
    fn a_disc_is_wider_than_the_space_between_sweeps() {
        for spacing in [0.0, 0.5, 1.0, 2.5, 40.0] {
            let least = LeastDiameter::between_sweeps(spacing).pixels();
            assert!(least >= LeastDiameter::DEFAULT && least > spacing, "{spacing}: {least}");
        }
        assert_eq!(LeastDiameter::between_sweeps(2.0).pixels(), 3.0);
    }

    #[test]
    fn what_a_pattern_can_miss_is_refused_by_name() {
        let four = Sampling::new(Pattern::Four);
        let refused = LeastDiameter::new(0.75, &four).unwrap_err().to_string();
        assert!(refused.contains("`4`") && refused.contains("0.790569"), "{refused}");
        assert!(LeastDiameter::new(Pattern::Four.widest_miss(), &four).is_err());
        assert!(LeastDiameter::new(0.8, &four).is_ok());
        assert!(LeastDiameter::new(0.8, &Sampling::turned(Pattern::Four).unwrap()).is_err());
        for sampling in Pattern::ALL.map(Sampling::new) {
            assert!(LeastDiameter::new(LeastDiameter::DEFAULT, &sampling).is_ok());
            assert!(LeastDiameter::new(f64::NAN, &sampling).is_err());
            assert!(LeastDiameter::new(f64::INFINITY, &sampling).is_err());
        }
    }
}
