//! How far a straight line bends against the datum.

use crate::SightError;
use crate::error::within;

/// Curvature of the body along a line of sight, in the local frame of the observer: distances s on the map are those of the plane that
/// touches the datum below the observer, and heights are vertical there.
///
/// - **Parabola**: the datum falls by `s^2 / 2 R`. Against the sphere the drop lacks about `s^4 / 8 R^3`: 0.15 mm over 5 km of
///   the Moon and 2.4 m over 100 km.
/// - **Sphere**: the datum falls by `R - sqrt(R^2 - s^2)`, and ends at s = R.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Curvature(pub(crate) Law);

/// The law of a [`Curvature`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Law {
    /// The ground does not drop.
    #[default]
    Flat,
    /// A drop of `half_bend s^2` (1/m).
    Parabola { half_bend: f64 },
    /// A sphere of an effective radius (m).
    Sphere { radius: f64 },
}

impl Curvature {
    /// A flat datum: lines of sight are straight on the map.
    pub const FLAT: Self = Self(Law::Flat);

    /// The parabola of a body of a `radius` (m), seen through an atmosphere of a `refraction` coefficient k: the effective radius
    /// is `R / (1 - k)`. The Moon has k = 0.
    ///
    /// # Errors
    /// A radius that is not finite and above 0, or a coefficient outside 0..1.
    pub fn parabolic(radius: f64, refraction: f64) -> Result<Self, SightError> {
        check(radius, refraction)?;
        Ok(Self(Law::Parabola { half_bend: (1.0 - refraction) / (2.0 * radius) }))
    }

    /// The sphere of a body of a `radius` (m); the effective radius is that of [`Curvature::parabolic`].
    ///
    /// # Errors
    /// Those of [`Curvature::parabolic`].
    pub fn spherical(radius: f64, refraction: f64) -> Result<Self, SightError> {
        check(radius, refraction)?;
        Ok(Self(Law::Sphere { radius: radius / (1.0 - refraction) }))
    }

    /// Drop (m) of the datum over a `distance` (m) below [`Curvature::reach`].
    pub fn drop(self, distance: f64) -> f64 {
        let square = distance * distance;
        match self.0 {
            Law::Flat => 0.0,
            Law::Parabola { half_bend } => half_bend * square,
            // This form keeps its digits at short distances.
            Law::Sphere { radius } => square / (radius + (radius * radius - square).max(0.0).sqrt()),
        }
    }

    /// Distance (m) at which the datum ends: infinite but for the sphere.
    pub fn reach(self) -> f64 {
        match self.0 {
            Law::Flat | Law::Parabola { .. } => f64::INFINITY,
            Law::Sphere { radius } => radius,
        }
    }

    /// Second derivative (1/m) of the drop at a `distance` (m): it grows with distance.
    pub(crate) fn bend(self, distance: f64) -> f64 {
        match self.0 {
            Law::Flat => 0.0,
            Law::Parabola { half_bend } => 2.0 * half_bend,
            Law::Sphere { radius } => {
                let square = radius * radius;
                let rest = (square - distance * distance).max(0.0);
                square / (rest * rest.sqrt())
            }
        }
    }

    /// Refuses a distance (m) that the datum does not have.
    pub(crate) fn check_reach(self, distance: f64) -> Result<(), SightError> {
        let expected = "a distance below the radius of the sphere";
        within("distance to the target (m)", distance, distance < self.reach(), expected)
    }
}

fn check(radius: f64, refraction: f64) -> Result<(), SightError> {
    within("radius of the body (m)", radius, radius > 0.0, "a finite number above 0")?;
    let allowed = (0.0..1.0).contains(&refraction);
    within("refraction coefficient", refraction, allowed, "a number from 0 to below 1")
}
