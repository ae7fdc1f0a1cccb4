//! The spectrum of a fully developed sea, and its integrals.

use crate::exponential_integral::exponential_integral;

/// Factor of the spectrum (Pierson and Moskowitz 1964).
pub const ALPHA: f64 = 8.10e-3;

/// Factor of its fall towards long waves (the same source).
pub const BETA: f64 = 0.74;

/// Gravity of the sea that is imitated (m/s^2): the standard one of the Earth.
pub const GRAVITY: f64 = 9.80665;

/// Why there are no such waves.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum WaveError {
    /// A figure is out of its range.
    #[error("{what} is {found}: expected {expected}")]
    Figure {
        /// Name of the figure with its unit.
        what: &'static str,
        /// The value that was found.
        found: f64,
        /// The range in words.
        expected: &'static str,
    },
    /// The shortest wave is longer than those that a wind raises most.
    #[error(
        "the shortest wave is {shortest} m, and the highest waves of this wind are {peak:.2} m long: expected a shorter one, or more wind"
    )]
    NoBand {
        /// Length of the shortest wave (m).
        shortest: f64,
        /// Length of the waves at the peak of the spectrum (m).
        peak: f64,
    },
}

/// Spectrum of the height of a fully developed sea under a steady wind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindSpectrum {
    wind: f64,
}

impl WindSpectrum {
    /// Range of the wind (m/s).
    const WINDS: std::ops::RangeInclusive<f64> = 0.5..=50.0;

    /// The spectrum under a wind at 19.5 m above the water (m/s), 0.5 to 50.
    ///
    /// # Errors
    /// If the wind is out of this range.
    pub fn new(wind: f64) -> Result<Self, WaveError> {
        if Self::WINDS.contains(&wind) {
            return Ok(Self { wind });
        }
        Err(WaveError::Figure { what: "wind (m/s)", found: wind, expected: "0.5 to 50" })
    }

    /// Exponent of the fall towards long waves at a frequency (rad/s).
    fn exponent(self, frequency: f64) -> f64 {
        let ratio = GRAVITY / (self.wind * frequency);
        BETA * (ratio * ratio) * (ratio * ratio)
    }

    /// Variance of height for each rad/s (m^2 s) at a frequency (rad/s), above 0.
    pub fn density(self, frequency: f64) -> f64 {
        let square = frequency * frequency;
        ALPHA * GRAVITY * GRAVITY / (square * square * frequency) * libm::exp(-self.exponent(frequency))
    }

    /// Frequency of the highest waves (rad/s): the place of the largest density.
    pub fn peak(self) -> f64 {
        GRAVITY / self.wind * (0.8 * BETA).sqrt().sqrt()
    }

    /// Variance of the height (m^2) of all waves.
    pub fn variance(self) -> f64 {
        let square = self.wind * self.wind;
        ALPHA * square * square / (4.0 * BETA * GRAVITY * GRAVITY)
    }

    /// Height of the significant waves (m): four standard deviations.
    pub fn significant_height(self) -> f64 {
        4.0 * self.variance().sqrt()
    }

    /// Variance of the height (m^2) of waves below a frequency (rad/s).
    pub fn variance_below(self, frequency: f64) -> f64 {
        self.variance() * libm::exp(-self.exponent(frequency))
    }

    /// Variance of the slope, both directions together, of waves below a frequency (rad/s).
    pub fn slope_variance_below(self, frequency: f64) -> f64 {
        ALPHA / 4.0 * exponential_integral(self.exponent(frequency))
    }
}

/// Wave number (rad/m) of deep water at a frequency (rad/s).
pub fn wave_number(frequency: f64) -> f64 {
    frequency * frequency / GRAVITY
}
