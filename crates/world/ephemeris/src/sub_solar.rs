//! The sun over a place, where the place is known that has it overhead.

use std::f64::consts::TAU;

use glam::DVec3;

/// Unit vector to the sun (north, east, up) over a latitude and longitude. Both places are in radians, and the sun is infinitely far.
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
    [libm::atan2(direction.z, level), if azimuth < 0.0 { azimuth + TAU } else { azimuth }]
}

#[cfg(test)]
mod tests {
    use quantities::{degrees, radians};

    use super::*;

    /// Check values of the terrain builder's specification (its table 9.1).
    #[test]
    fn the_sun_of_the_check_table_comes_out() {
        let place = [26.13222, 3.63386].map(radians);
        let found = elevation_and_azimuth(sun_direction(place, [1.5, 80.0].map(radians))).map(degrees);
        assert!((found[0] - 12.889_913_105_841).abs() < 1e-10, "{found:?}");
        assert!((found[1] - 94.724_151_559_080).abs() < 1e-10, "{found:?}");
        assert!((sun_direction(place, place) - DVec3::Z).length() < 1e-15);
    }
}
