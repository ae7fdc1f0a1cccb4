//! How the axes of a scenario lie on a body.

use glam::{DMat3, DVec3};
use photo_camera::{Axes, Ellipsoid, Geodetic};
use quantities::sin_cos;

use crate::real::Real;

/// How north, east, up of a scenario (m) lie in the georectangular axes of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lie {
    /// A plane without a place: it touches the Moon at latitude 0, longitude 0.
    Plane,
    /// Seconds of arc on a body: a metre to the north or to the east is the same angle everywhere, that of the reference.
    Degrees {
        /// Body whose surface the posts lie on.
        body: Ellipsoid,
        /// Latitude and longitude (rad) of the reference.
        reference: [f64; 2],
        /// Place of the reference in the scenario: north, east (m).
        at: [f64; 2],
    },
}

impl Lie {
    /// Axes in which a photograph's camera has to stand.
    pub(crate) fn axes(&self) -> Axes {
        match self {
            Self::Plane => Axes::Landscape,
            Self::Degrees { body, .. } => Axes::Body(*body),
        }
    }

    /// Metres to the north and to the east of one radian of latitude and of longitude.
    fn metres(body: &Ellipsoid, latitude: f64) -> [f64; 2] {
        let (sin, cos) = sin_cos(latitude);
        let squared = body.eccentricity_squared();
        let prime = body.prime_vertical(latitude);
        let meridian = prime * (1.0 - squared) / (1.0 - squared * sin * sin);
        [meridian, prime * cos]
    }

    /// The place (north, east; m) in the scenario of a latitude and longitude (rad); none on a plane.
    pub fn place(&self, latitude: f64, longitude: f64) -> Option<[f64; 2]> {
        let Self::Degrees { body, reference, at } = self else { return None };
        let metres = Self::metres(body, reference[0]);
        let angles = [latitude - reference[0], longitude - reference[1]];
        Some([0, 1].map(|axis| at[axis] + angles[axis] * metres[axis]))
    }

    /// Latitude, longitude (rad) and height (m) of a place (north, east, up; m).
    fn geodetic(&self, place: DVec3) -> Geodetic {
        match self {
            Self::Plane => Geodetic { latitude: 0.0, longitude: 0.0, height: 0.0 },
            Self::Degrees { body, reference, at } => {
                let metres = Self::metres(body, reference[0]);
                let angle = |axis: usize| reference[axis] + (place[axis] - at[axis]) / metres[axis];
                Geodetic { latitude: angle(0), longitude: angle(1), height: place.z }
            }
        }
    }

    /// The georectangular point (m) of a place (north, east, up; m), stored in `real`.
    pub(crate) fn point(&self, place: DVec3, real: Real) -> DVec3 {
        let point = match self {
            Self::Plane => Self::from_plane(place.y, place.x, Ellipsoid::MOON.semi_major() + place.z),
            Self::Degrees { body, .. } => body.point(self.geodetic(place)),
        };
        real.vector(point)
    }

    /// Components along the axes of a body of east, north, up on the plane.
    pub(crate) fn from_plane(east: f64, north: f64, up: f64) -> DVec3 {
        DVec3::new(up, east, north)
    }

    /// Columns: the unit vectors north, east, up at a place, georectangular.
    pub(crate) fn turn(&self, place: DVec3) -> DMat3 {
        match self {
            Self::Plane => DMat3::from_cols(DVec3::Z, DVec3::Y, DVec3::X),
            Self::Degrees { body, .. } => {
                let axes = body.frame(self.geodetic(place)).axes;
                DMat3::from_cols(axes.y_axis, axes.x_axis, axes.z_axis)
            }
        }
    }
}
