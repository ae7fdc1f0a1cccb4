//! The axes in which a camera and its ground points stand.

use crate::Ellipsoid;

/// Axes of ground points (m), right-handed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axes {
    /// Georectangular axes of a body.
    Body(Ellipsoid),
    /// Axes of a landscape: x east, y north, z up, from the landscape's origin. The ground is a plane without curvature.
    Landscape,
}

impl Axes {
    /// The body, if the axes are those of one.
    pub fn body(&self) -> Option<&Ellipsoid> {
        match self {
            Self::Body(body) => Some(body),
            Self::Landscape => None,
        }
    }
}
