//! Why a relief cannot be made, and checks of its parameters.

use limits::Limit;

use crate::BankError;

/// Why a relief cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReliefError {
    /// A parameter is out of its range.
    #[error("{name} = {value}: expected {expected}")]
    Parameter {
        /// Which, as a path from the relief: `massifs[2].height`.
        name: String,
        /// Value that was given for the parameter.
        value: f64,
        /// The range, in words.
        expected: String,
    },
    /// More corners than fit the limit.
    #[error("{north} x {east} corners: expected at most {} in all; enlarge the regions; {}", Limit::Corners.value(), Limit::Corners)]
    TooManyCorners {
        /// Corners to the north.
        north: f64,
        /// Corners to the east.
        east: f64,
    },
    /// More craters than fit the limit.
    #[error(
        "{0} craters: expected at most {limit}; raise smallest_radius, lower largest_radius or density; {advice}",
        limit = Limit::GroundCraters.value(),
        advice = Limit::GroundCraters
    )]
    TooManyCraters(f64),
    /// The words do not make a level.
    #[error("the relief is no landscape")]
    Level(#[from] BankError),
}

pub(super) fn within(name: impl Into<String>, value: f64, least: f64, most: f64) -> Result<(), ReliefError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    let expected = if most < f64::MAX { format!("{least} to {most}") } else { format!("at least {least}") };
    Err(ReliefError::Parameter { name: name.into(), value, expected })
}

pub(super) fn above(name: impl Into<String>, value: f64, least: f64) -> Result<(), ReliefError> {
    if value.is_finite() && value > least {
        return Ok(());
    }
    Err(ReliefError::Parameter {
        name: name.into(),
        value,
        expected: format!("a finite number above {least}"),
    })
}

pub(super) fn finite(name: impl Into<String>, value: f64) -> Result<(), ReliefError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(ReliefError::Parameter { name: name.into(), value, expected: "a finite number".into() })
}
