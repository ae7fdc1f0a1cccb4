//! Where the sun stands over a place, and how a surface answers its light.

use glam::DVec3;
use quantities::radians;

/// Sun and surface of a landscape. The sun is white and infinitely far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Latitude and longitude of the sub-solar point (rad).
    pub sub_solar: [f64; 2],
    /// Red, green and blue of the surface in shadow, 0 to 1.
    pub ambient: [f64; 3],
    /// Red, green and blue that full light adds, 0 to 1.
    pub diffuse: [f64; 3],
}

impl Light {
    /// Colour of a surface in the share of full light that reaches it, 0 to 1.
    pub fn colour(&self, share: f64) -> [f64; 3] {
        [0, 1, 2].map(|part| self.ambient[part] + self.diffuse[part] * share)
    }
}

/// Unit vector to the sun (north, east, up) over a latitude and longitude, both places in radians.
pub fn sun_direction([latitude, longitude]: [f64; 2], [sub_latitude, sub_longitude]: [f64; 2]) -> DVec3 {
    let (sin, cos) = (libm::sin(latitude), libm::cos(latitude));
    let (sin_sun, cos_sun) = (libm::sin(sub_latitude), libm::cos(sub_latitude));
    let (sin_way, cos_way) = (libm::sin(sub_longitude - longitude), libm::cos(sub_longitude - longitude));
    DVec3::new(
        cos * sin_sun - sin * cos_sun * cos_way,
        cos_sun * sin_way,
        sin * sin_sun + cos * cos_sun * cos_way,
    )
}

/// Elevation and azimuth from north towards east (rad) of a direction: north, east, up.
pub fn elevation_and_azimuth(direction: DVec3) -> [f64; 2] {
    let level = (direction.x * direction.x + direction.y * direction.y).sqrt();
    let azimuth = libm::atan2(direction.y, direction.x);
    [libm::atan2(direction.z, level), if azimuth < 0.0 { azimuth + radians(360.0) } else { azimuth }]
}
