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
