//! Figures that no light point has.

/// A figure out of range.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum LightError {
    /// A figure that must be a number in a range.
    #[error("{what} is {value}: expected {expected}")]
    Figure {
        /// Name of the figure with its unit.
        what: &'static str,
        /// The value that was found.
        value: f64,
        /// The range, in words.
        expected: &'static str,
    },
    /// A least diameter (pixels) with which a disc can lie between the sampling points.
    #[error(
        "least diameter of light points is {given} pixels: pattern `{pattern}` can miss such a disc; expected more than {bound}"
    )]
    BelowPattern {
        /// Name of the pattern.
        pattern: &'static str,
        /// The widest disc that misses all sampling points (pixels).
        bound: f64,
        /// The value that was found (pixels).
        given: f64,
    },
}

/// `value` if it is in the range that `expected` says and `holds` tests; what is no finite number never is.
pub(crate) fn checked(
    what: &'static str,
    value: f64,
    expected: &'static str,
    holds: impl Fn(f64) -> bool,
) -> Result<f64, LightError> {
    if value.is_finite() && holds(value) {
        Ok(value)
    } else {
        Err(LightError::Figure { what, value, expected })
    }
}
