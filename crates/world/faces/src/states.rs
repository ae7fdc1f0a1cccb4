//! Sea states 0 to 3: contrast, elevation of the sun, rate of its turning.

use crate::cone::Cone;
use crate::error::{FaceError, within};

/// Sea states; the study names them, their contrasts and rates are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeaState {
    /// No contrast, state 0: the sun stands at the zenith.
    Calm,
    /// Low contrast, state 1.
    Slight,
    /// Moderate contrast, state 2.
    Moderate,
    /// High contrast, state 3.
    High,
}

impl SeaState {
    /// All states, from 0 to 3.
    pub const ALL: [Self; 4] = [Self::Calm, Self::Slight, Self::Moderate, Self::High];

    /// Amplitude over mean of the brightness (chosen).
    pub fn contrast(self) -> f64 {
        [0.0, 0.15, 0.30, 0.50][self as usize]
    }

    /// Turns of the sun in a second, as a ratio of whole numbers (chosen).
    pub fn rate(self) -> [i64; 2] {
        [[1, 10], [3, 20], [1, 5], [1, 4]][self as usize]
    }

    /// Elevation of the sun (radians) that gives this contrast on `cone`.
    ///
    /// # Errors
    /// Never for a state: each contrast is below 1.
    pub fn elevation(self, cone: &Cone) -> Result<f64, FaceError> {
        cone.elevation_of(self.contrast())
    }
}

/// What happens to the mean brightness when the sun is lowered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mean {
    /// The mean falls with the sun (reported).
    AsReported,
    /// The brightness is multiplied so that the mean is this (above 0, at most 1; chosen).
    Held(f64),
}

impl Mean {
    /// The mean that is held unless another is given (chosen).
    pub const USUAL: Self = Self::Held(0.5);

    /// Factor of the brightness of a pattern on `cone` under a sun at `elevation` (radians).
    ///
    /// # Errors
    /// If the held mean is not above 0, or the crest would exceed 1.
    pub fn gain(self, cone: &Cone, elevation: f64) -> Result<f64, FaceError> {
        let Self::Held(held) = self else { return Ok(1.0) };
        within("held mean", held, held > 0.0, "above 0")?;
        let mean = cone.mean(elevation);
        within("mean brightness to hold", mean, mean > 0.0, "above 0: raise the sun over the horizon")?;
        let crest = held * (1.0 + cone.contrast(elevation));
        within("crest of the held pattern", crest, crest <= 1.0 + 1e-12, "1 or less: lower the held mean")?;
        Ok(held / mean)
    }
}
