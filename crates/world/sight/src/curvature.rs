//! How far a straight line bends against the datum.

use crate::SightError;
use crate::error::within;

/// Curvature of the body along a line of sight.
///
/// **Parabolic**: the datum falls by `s^2 / 2 R` over a distance s on the map. Against a sphere the drop lacks about
/// `s^4 / 8 R^3`: 0.15 mm over 5 km of the Moon and 2.4 m over 100 km. Distances on the map are those of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Curvature {
    /// Half the reciprocal of the effective radius (1/m); 0 is flat.
    half_bend: f64,
}

impl Curvature {
    /// A flat datum: lines of sight are straight on the map.
    pub const FLAT: Self = Self { half_bend: 0.0 };

    /// The parabola of a body of a `radius` (m), seen through an atmosphere of a `refraction` coefficient k: the effective radius
    /// is `R / (1 - k)`. The Moon has k = 0.
    ///
    /// # Errors
    /// A radius that is not finite and above 0, or a coefficient outside 0..1.
    pub fn parabolic(radius: f64, refraction: f64) -> Result<Self, SightError> {
        within("radius of the body (m)", radius, radius > 0.0, "a finite number above 0")?;
        let allowed = (0.0..1.0).contains(&refraction);
        within("refraction coefficient", refraction, allowed, "a number from 0 to below 1")?;
        Ok(Self { half_bend: (1.0 - refraction) / (2.0 * radius) })
    }

    /// Drop (m) of the datum over a `distance` (m).
    pub fn drop(self, distance: f64) -> f64 {
        self.half_bend * distance * distance
    }
}
