//! What a light point in the raster does to the sampling points under its disc.

use crate::disc::Disc;

/// How a light point meets what is behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Blending {
    /// It hides as much as it shines: translucency is 1 less the intensity (claim 1; the function is chosen).
    Hiding,
    /// It adds its light and hides nothing. Physically better over bright ground; not the claimed way.
    Additive,
}

/// A light point at one sampling point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// What its colour is multiplied by, at least 0; above 1 where a bright disc covers few sampling points.
    pub added: f64,
    /// Share of light from behind that it lets through, 0 to 1.
    pub translucency: f64,
}

impl Light {
    /// Light of an `intensity` (at least 0). What is added is not clamped, and translucency stays 0 above intensity 1: clamped
    /// both, a normalised point would lose the light that the normalising keeps.
    pub fn new(intensity: f64, blending: Blending) -> Self {
        let translucency = match blending {
            Blending::Hiding => 1.0 - intensity.min(1.0),
            Blending::Additive => 1.0,
        };
        Self { added: intensity, translucency }
    }
}

impl Disc {
    /// Intensity of a disc that covers `covered` sampling points (at least 1), of `samples` a pixel, such that its light is
    /// intensity times area wherever it lies.
    pub fn normalised(&self, covered: u32, samples: usize) -> f64 {
        self.light() * samples as f64 / f64::from(covered)
    }

    /// Intensity with which its light fills an area (pixels squared, above 0): that of the strips by which sweeps cover the disc.
    pub fn spread_over(&self, area: f64) -> f64 {
        self.light() / area
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_stays_the_same_however_large_the_area_that_it_fills() {
        let disc = Disc { diameter: 2.0, intensity: 0.5 };
        for area in [0.5, 3.0, 11.0] {
            assert!((disc.spread_over(area) * area - disc.light()).abs() < 1e-15);
        }
        assert_eq!(disc.spread_over(disc.area()), 0.5);
    }

    #[test]
    fn translucency_is_what_the_intensity_leaves() {
        assert_eq!(Light::new(0.25, Blending::Hiding), Light { added: 0.25, translucency: 0.75 });
        assert_eq!(Light::new(1.25, Blending::Hiding), Light { added: 1.25, translucency: 0.0 });
        assert_eq!(Light::new(1.25, Blending::Additive), Light { added: 1.25, translucency: 1.0 });
    }
}
