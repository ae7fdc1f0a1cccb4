//! The piece of the sphere that a landscape covers, and its local axes.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use quantities::degrees;

use crate::refused::{Refused, expect};

/// Mean radius of the Moon (m; reported).
pub const MOON_RADIUS: f64 = 1_737_400.0;
/// Span of longitude or latitude above which the flat axes are doubtful (rad; chosen).
const WIDE: f64 = 5.0 * PI / 180.0;
/// Latitude beyond which the flat axes are doubtful (rad; chosen).
const POLAR: f64 = 60.0 * PI / 180.0;

/// A range of longitude and latitude on a sphere, with flat axes at its centre.
///
/// `north = R (lat - lat0)`, `east = R cos(lat0) (lon - lon0)`. Curvature is left to the renderer: [`Frame::drop`] has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    radius: f64,
    /// West and east (rad); east is above west, across 180 degrees too.
    longitude: [f64; 2],
    latitude: [f64; 2],
    cos_centre: f64,
}

/// A frame in which the flat axes are doubtful.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrameWarning {
    /// The span of longitude or latitude is above 5 degrees; it is given (rad).
    Wide(f64),
    /// The range reaches beyond 60 degrees of latitude; the latitude is given (rad).
    Polar(f64),
}

impl std::fmt::Display for FrameWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Wide(span) => write!(
                f,
                "the range spans {:.2} degrees: above 5 degrees flat axes stretch the ground",
                degrees(*span)
            ),
            Self::Polar(latitude) => write!(
                f,
                "the range reaches latitude {:.2} degrees: beyond 60 degrees flat axes stretch the ground; survey polar ground in a polar projection",
                degrees(*latitude)
            ),
        }
    }
}

impl Frame {
    /// The frame of a range of longitude [west, east] and latitude [south, north] (rad) on a sphere of `radius` (m).
    /// East may be below west: the range then crosses 180 degrees.
    ///
    /// # Errors
    /// If the radius is not 1 m to 1e9 m, the latitudes do not ascend, a pole is inside, or the longitudes span nothing or
    /// more than 180 degrees.
    pub fn new(radius: f64, longitude: [f64; 2], latitude: [f64; 2]) -> Result<Self, Refused> {
        expect((1.0..=1e9).contains(&radius), "radius_m", radius, "a length from 1 m to 1e9 m")?;
        let [south, north] = latitude;
        let is_sound = south > -FRAC_PI_2 && north < FRAC_PI_2 && south < north;
        let expected = "south and north in ascending order, without a pole";
        expect(is_sound, "latitude_deg", told(latitude), expected)?;
        let [west, mut east] = longitude;
        if east < west {
            east += TAU;
        }
        let is_sound = west.abs() <= TAU && east.abs() <= 2.0 * TAU && east > west && east - west <= PI;
        let expected = "west and east, the east at most 180 degrees further east";
        expect(is_sound, "longitude_deg", told(longitude), expected)?;
        let cos_centre = libm::cos(0.5 * (latitude[0] + latitude[1]));
        Ok(Self { radius, longitude: [west, east], latitude, cos_centre })
    }

    /// Radius of the sphere (m).
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// West and east edge (rad); the east is above the west.
    pub fn longitude(&self) -> [f64; 2] {
        self.longitude
    }

    /// South and north edge (rad).
    pub fn latitude(&self) -> [f64; 2] {
        self.latitude
    }

    /// Latitude and longitude of the origin of the axes (rad).
    pub fn centre(&self) -> [f64; 2] {
        [self.latitude, self.longitude].map(|[low, high]| 0.5 * (low + high))
    }

    /// South-west corner: north, east (m).
    pub fn corner(&self) -> [f64; 2] {
        self.size().map(|side| -0.5 * side)
    }

    /// Length of the range to the north and to the east (m).
    pub fn size(&self) -> [f64; 2] {
        let [north, east] = [self.latitude, self.longitude].map(|[low, high]| self.radius * (high - low));
        [north, east * self.cos_centre]
    }

    /// North and east (m) of a latitude and longitude (rad), on the turn of longitude that is nearest to the centre.
    pub fn forward(&self, latitude: f64, longitude: f64) -> [f64; 2] {
        let [lat0, lon0] = self.centre();
        let east = longitude - lon0;
        let east = east - TAU * (east / TAU).round();
        [self.radius * (latitude - lat0), self.radius * self.cos_centre * east]
    }

    /// Latitude and longitude (rad) of a place: north, east (m).
    pub fn inverse(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        let [lat0, lon0] = self.centre();
        [lat0 + north / self.radius, lon0 + east / (self.radius * self.cos_centre)]
    }

    /// Area (m2) of a range of longitude and latitude (rad) on the sphere.
    pub fn area(&self, longitude: [f64; 2], latitude: [f64; 2]) -> f64 {
        let [south, north] = latitude.map(libm::sin);
        self.radius * self.radius * (longitude[1] - longitude[0]) * (north - south)
    }

    /// How far the sphere lies below the flat axes at a distance (m) from the centre, at most the radius (m).
    pub fn drop(&self, distance: f64) -> f64 {
        // The difference of two radii, without the cancellation.
        let [radius, square] = [self.radius, distance * distance];
        square / (radius + (radius * radius - square).max(0.0).sqrt())
    }

    /// What makes the flat axes doubtful; empty for a small range away from the poles.
    pub fn warnings(&self) -> Vec<FrameWarning> {
        let span = [self.longitude, self.latitude].map(|[low, high]| high - low);
        let widest = span[0].max(span[1]);
        let nearest = self.latitude[0].abs().max(self.latitude[1].abs());
        let wide = (widest > WIDE).then_some(FrameWarning::Wide(widest));
        let polar = (nearest > POLAR).then_some(FrameWarning::Polar(nearest));
        wide.into_iter().chain(polar).collect()
    }
}

/// A range of angles (rad) in degrees, as the file has it.
pub(crate) fn told(range: [f64; 2]) -> String {
    let [low, high] = range.map(degrees);
    format!("[{low}, {high}]")
}
