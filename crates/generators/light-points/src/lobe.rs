//! Beam of a lamp that shines to one side.

use glam::DVec3;

use crate::error::{LightError, checked};

/// A lobe about an axis: the power of the cosine of the angle to it, and nothing beyond the half-angle.
///
/// Chosen: the law of spotlights in graphics libraries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobe {
    axis: DVec3,
    least_cosine: f64,
    power: f64,
}

impl Lobe {
    /// A lobe along `axis` (any length but 0) with its half-angle (radians, above 0 to pi/2) and the power of its cosine (at
    /// least 0; 0 is the same all over).
    ///
    /// # Errors If one of them is out of range or not finite.
    pub fn new(axis: DVec3, half_angle: f64, power: f64) -> Result<Self, LightError> {
        let length = axis.length();
        checked("length of a beam's axis", length, "a number above 0", |length| length > 0.0)?;
        let half_angle = checked("half-angle of a beam (rad)", half_angle, "above 0 to pi/2", |angle| {
            angle > 0.0 && angle <= std::f64::consts::FRAC_PI_2
        })?;
        let power = checked("cosine power of a beam", power, "at least 0", |power| power >= 0.0)?;
        Ok(Self { axis: axis / length, least_cosine: libm::cos(half_angle), power })
    }

    /// Share (0 to 1) of the intensity on its axis that goes along `direction` (any length but 0), away from the lamp.
    pub fn share(&self, direction: DVec3) -> f64 {
        let cosine = self.axis.dot(direction) / direction.length();
        if cosine >= self.least_cosine { libm::pow(cosine.min(1.0), self.power) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    fn at(degrees: f64) -> DVec3 {
        let angle = degrees.to_radians();
        DVec3::new(3.0 * libm::cos(angle), 0.0, 3.0 * libm::sin(angle))
    }

    #[test]
    fn a_lobe_falls_by_the_power_of_its_cosine_and_ends() {
        let lobe = Lobe::new(DVec3::X * 7.0, FRAC_PI_4, 2.0).unwrap();
        assert_eq!(lobe.share(DVec3::X), 1.0);
        assert!((lobe.share(at(30.0)) - 0.75).abs() < 1e-15);
        assert!(lobe.share(at(44.9)) > 0.5 && lobe.share(at(45.1)) == 0.0 && lobe.share(at(180.0)) == 0.0);
        let even = Lobe::new(DVec3::X, FRAC_PI_4, 0.0).unwrap();
        assert_eq!((even.share(at(44.9)), even.share(at(45.1))), (1.0, 0.0));
    }

    #[test]
    fn figures_out_of_range_are_refused() {
        for (axis, half_angle, power) in [
            (DVec3::ZERO, 1.0, 1.0),
            (DVec3::X, 0.0, 1.0),
            (DVec3::X, 1.6, 1.0),
            (DVec3::X, 1.0, -1.0),
            (DVec3::X, 1.0, f64::INFINITY),
            (DVec3::X * f64::NAN, 1.0, 1.0),
        ] {
            assert!(Lobe::new(axis, half_angle, power).is_err(), "{axis} {half_angle} {power}");
        }
    }
}
