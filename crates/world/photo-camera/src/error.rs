//! What a camera, an angle or a grid with voids is refused for.

/// Why there is no angle, body, camera or fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// A text is no angle of the one grammar.
    #[error(
        "\"{text}\" is no {axis}: {fault}; write signed degrees (-122.5) or D:M:S with a hemisphere letter ({example})"
    )]
    Angle {
        /// The text that was found.
        text: String,
        /// Word for the angle: latitude or longitude.
        axis: &'static str,
        /// What is wrong with the text.
        fault: &'static str,
        /// An angle that would be accepted.
        example: &'static str,
    },
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
    /// The axes of a camera are not those of a rotation.
    #[error(
        "the axes are no rotation: {what} is off by {off:e}, and {allowed:e} is allowed; \
         give unit vectors at right angles to each other, right-handed"
    )]
    NoRotation {
        /// Which property of a rotation fails.
        what: &'static str,
        /// By how much it fails, without unit.
        off: f64,
        /// The largest deviation that is allowed.
        allowed: f64,
    },
    /// An affine maps the plane of the picture onto a line.
    #[error(
        "the affine has determinant {determinant:e} for coefficients of size {size:e}: it cannot be inverted; \
         give two columns that are not parallel"
    )]
    NoInverse {
        /// A1 B2 - B1 A2 of the affine, in its coefficients' units squared.
        determinant: f64,
        /// Largest coefficient of the affine.
        size: f64,
    },
    /// There are fewer control points than the fit has unknowns and one.
    #[error("{found} control points: expected {least} or more, so that a shift leaves something to judge")]
    TooFewPoints {
        /// Number of control points that was given.
        found: usize,
        /// Least number of control points.
        least: usize,
    },
    /// A control point has no image in the photograph.
    #[error(
        "control point {index} lies behind the camera and has no image: remove it, or correct its position"
    )]
    Behind {
        /// Index of the point in the list, from 0.
        index: usize,
    },
}

impl CameraError {
    /// Passes `found` on where `holds`, and refuses it otherwise.
    pub(crate) fn figure(
        what: &'static str,
        found: f64,
        expected: &'static str,
        holds: impl Fn(f64) -> bool,
    ) -> Result<f64, Self> {
        if found.is_finite() && holds(found) {
            Ok(found)
        } else {
            Err(Self::Figure { what, found, expected })
        }
    }
}
