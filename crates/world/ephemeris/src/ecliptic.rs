//! From the ecliptic of date to the axes of the ICRF.

use glam::{DMat3, DVec3};
use quantities::{radians, sin_cos};

/// A place in ecliptic coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Spherical {
    /// Along the ecliptic from the equinox of date (rad).
    pub longitude: f64,
    /// From the ecliptic of date to the north (rad).
    pub latitude: f64,
    /// Distance from the origin (m).
    pub distance: f64,
}

impl Spherical {
    /// The same in rectangular coordinates of the ecliptic of date (m).
    pub fn vector(self) -> DVec3 {
        let ((sin_l, cos_l), (sin_b, cos_b)) = (sin_cos(self.longitude), sin_cos(self.latitude));
        self.distance * DVec3::new(cos_b * cos_l, cos_b * sin_l, sin_b)
    }
}

/// Mean obliquity of the ecliptic at J2000.0 (degrees; IAU 1976).
const OBLIQUITY: f64 = 84_381.448 / 3600.0;

/// Matrix from mean ecliptic and equinox of date to the ICRF, whose axes are those of the mean equator and equinox of J2000.0
/// within 0.03 seconds of arc. Precession of the ecliptic by J. Lieske and others, Astronomy and Astrophysics 58, 1, 1977.
pub fn to_icrf(centuries: f64) -> DMat3 {
    let t = centuries;
    let arcseconds = |value: f64| radians(value / 3600.0);
    // Tilt of the ecliptic of date against that of J2000.0, its ascending node, and the precession in longitude.
    let tilt = arcseconds(t * (47.0029 + t * (-0.033_02 + t * 0.000_06)));
    let node = radians(174.876_384) - arcseconds(t * (869.8089 - t * 0.035_36));
    let precession = arcseconds(t * (5029.0966 + t * (1.111_13 - t * 0.000_006)));
    let to_ecliptic_of_j2000 = about_z(node) * about_x(tilt) * about_z(-node - precession);
    about_x(radians(OBLIQUITY)) * to_ecliptic_of_j2000
}

/// Turns a vector by `angle` (rad) from x towards y.
pub fn about_z(angle: f64) -> DMat3 {
    let (sin, cos) = sin_cos(angle);
    DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z)
}

/// Turns a vector by `angle` (rad) from y towards z.
pub fn about_x(angle: f64) -> DMat3 {
    let (sin, cos) = sin_cos(angle);
    DMat3::from_cols(DVec3::X, DVec3::new(0.0, cos, sin), DVec3::new(0.0, -sin, cos))
}

#[cfg(test)]
mod tests {
    use super::{OBLIQUITY, Spherical, about_x, to_icrf};
    use quantities::{degrees, radians};

    /// Meeus, example 21.c: Venus on -214 June 30, from the ecliptic of J2000.0 to that of date.
    #[test]
    fn the_venus_of_example_21_c() {
        let centuries = (1_643_074.5 - 2_451_545.0) / 36_525.0;
        let of_date =
            Spherical { longitude: radians(118.704), latitude: radians(1.615), distance: 1.0 }.vector();
        let of_j2000 = about_x(radians(OBLIQUITY)).transpose() * to_icrf(centuries) * of_date;
        let longitude = degrees(libm::atan2(of_j2000.y, of_j2000.x));
        assert!((longitude - 149.481_94).abs() < 2e-3, "{longitude}");
        assert!((degrees(libm::asin(of_j2000.z)) - 1.765_49).abs() < 2e-3);
    }
}
