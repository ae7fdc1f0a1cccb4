//! Heights as whole numbers: steps, or the bits of a number in the order of the numbers.

/// Largest number of steps that a height may have: below it a height and its steps are the same thing.
pub(crate) const MOST_STEPS: f64 = (1_u64 << 50) as f64;

/// How heights become whole numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Coding {
    /// Every bit is kept.
    Exact,
    /// Whole steps of a length (m).
    Steps(f64),
}

impl Coding {
    /// The coding with a step (m), or without.
    pub fn new(step: Option<f64>) -> Self {
        step.map_or(Self::Exact, Self::Steps)
    }

    /// Whole number of a height (m).
    pub fn number(self, height: f64) -> i64 {
        match self {
            // The order of the bits as numbers is that of the heights: negative ones run the other way.
            Self::Exact => {
                let bits = height.to_bits() as i64;
                bits ^ (((bits >> 63) as u64) >> 1) as i64
            }
            Self::Steps(step) => (height / step).round() as i64,
        }
    }

    /// Height (m) of a whole number.
    pub fn height(self, number: i64) -> f64 {
        match self {
            Self::Exact => f64::from_bits((number ^ (((number >> 63) as u64) >> 1) as i64) as u64),
            Self::Steps(step) => number as f64 * step,
        }
    }
}
