//! Sun and Earth over the ground of a mission with a date.

use ephemeris::{Place, Seen, Sky};
use quantities::degrees;
use scenario::DatedSky;
use serde::{Deserialize, Serialize};

/// Sun and Earth over the ground at a date.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SkyRecord {
    /// Date and time, ISO 8601 in UTC.
    pub at: String,
    /// Place on the Moon that the sky is of.
    pub place: PlaceRecord,
    /// Direction of true north, clockwise from the x axis of the ground (deg).
    pub true_north_deg: f64,
    /// The Sun as it is seen from the place.
    pub sun: SeenRecord,
    /// The Earth as it is seen from the place.
    pub earth: SeenRecord,
    /// How much of the Earth is lit.
    pub earth_phase: PhaseRecord,
    /// Place that has the Sun overhead.
    pub sub_solar: PlaceRecord,
    /// Place that has the Earth overhead.
    pub sub_earth: PlaceRecord,
}

/// A place on the Moon: mean-Earth, polar-axis system, planetocentric.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlaceRecord {
    /// Longitude, positive east (deg), -180 to 180.
    pub longitude_deg: f64,
    /// Latitude, positive north (deg).
    pub latitude_deg: f64,
}

/// A body as it is seen from a place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SeenRecord {
    /// Azimuth in the axes of the ground, clockwise from x (deg): `sun.azimuth_deg` of a scenario.
    pub azimuth_deg: f64,
    /// Azimuth clockwise from true north (deg).
    pub true_azimuth_deg: f64,
    /// Elevation of its centre above the horizontal (deg).
    pub elevation_deg: f64,
    /// Distance from the place (m).
    pub distance_m: f64,
    /// Angle that its disc fills (deg).
    pub angular_diameter_deg: f64,
}

/// How much of the Earth is lit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PhaseRecord {
    /// Share of its disc that is lit, 0 (new) to 1 (full).
    pub lit: f64,
    /// Angle at the Earth between Sun and place (deg), 0 (full) to 180 (new).
    pub angle_deg: f64,
    /// Whether the lit share grows.
    pub waxes: bool,
}

impl From<&DatedSky> for SkyRecord {
    fn from(dated: &DatedSky) -> Self {
        let Sky { sun, earth, earth_lit, earth_phase_angle, earth_waxes, sub_solar, sub_earth } = dated.sky;
        let seen = |seen: Seen| SeenRecord {
            azimuth_deg: degrees(dated.on_ground(seen.azimuth)),
            true_azimuth_deg: degrees(seen.azimuth),
            elevation_deg: degrees(seen.elevation),
            distance_m: seen.distance,
            angular_diameter_deg: degrees(seen.angular_diameter),
        };
        Self {
            at: dated.at.to_string(),
            place: dated.place.into(),
            true_north_deg: degrees(dated.true_north),
            sun: seen(sun),
            earth: seen(earth),
            earth_phase: PhaseRecord {
                lit: earth_lit,
                angle_deg: degrees(earth_phase_angle),
                waxes: earth_waxes,
            },
            sub_solar: sub_solar.into(),
            sub_earth: sub_earth.into(),
        }
    }
}

impl From<Place> for PlaceRecord {
    fn from(place: Place) -> Self {
        let longitude = degrees(place.longitude);
        let longitude_deg = longitude - 360.0 * ((longitude - 180.0) / 360.0).ceil();
        Self { longitude_deg, latitude_deg: degrees(place.latitude) }
    }
}

#[cfg(test)]
mod tests {
    use super::PlaceRecord;
    use ephemeris::{MOON_RADIUS, Place};
    use quantities::radians;

    #[test]
    fn longitudes_are_within_half_a_turn() {
        for (longitude, expected) in
            [(0.0, 0.0), (180.0, 180.0), (190.0, -170.0), (-200.0, 160.0), (359.0, -1.0)]
        {
            let place = Place { longitude: radians(longitude), latitude: 0.0, radius: MOON_RADIUS };
            assert!((PlaceRecord::from(place).longitude_deg - expected).abs() < 1e-9, "{longitude}");
        }
    }
}
