//! Two levels of detail at one sample: the sea, and the wake upon it.

use crate::group::Detail;

/// Intensity of a sample, and whether it was clamped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Level {
    /// Intensity, 0 to 1.
    pub intensity: f64,
    /// Whether the sum exceeded full scale.
    pub is_clamped: bool,
}

impl Detail {
    /// Both levels at one sample, 0 to 1 each: `below` first, `above` upon it.
    pub fn combine(self, below: f64, above: f64) -> Level {
        let level = |intensity| Level { intensity, is_clamped: false };
        match self {
            Self::Add if below + above > 1.0 => Level { intensity: 1.0, is_clamped: true },
            Self::Add => level(below + above),
            Self::Replace => level(above),
            Self::AddSoft => level(1.0 - (1.0 - below) * (1.0 - above)),
        }
    }
}
