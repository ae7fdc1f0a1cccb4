//! How the coordinates of an elevation file become ground points of a photograph.

use glam::DVec3;
use photo_camera::{Axes, Ellipsoid, Geodetic};
use photograph::{Map, MapUnit, Placement};
use quantities::degrees;
use survey::{Frame, Projection};

use crate::GroundError;

/// From the coordinates of the file to ground points of the photograph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rule {
    /// North and east are taken as they are.
    Plane,
    /// Radians of latitude and longitude become degrees.
    Degrees,
    /// Radians of latitude and longitude on a body.
    Geographic(Ellipsoid),
    /// A map projection of a body.
    Projected(Ellipsoid, Projection),
}

impl Rule {
    /// The rule between a file and a photograph.
    ///
    /// # Errors
    /// If the places of the file do not go with the photograph.
    pub fn of(frame: Frame, placement: &Placement) -> Result<Self, GroundError> {
        match placement {
            Placement::Camera { axes: Axes::Landscape, .. } => of_landscape(frame),
            Placement::Camera { axes: Axes::Body(body), .. } => of_body(*body, frame),
            Placement::Map(map) => of_map(map, frame),
        }
    }

    /// The ground point of coordinates of the file (m or rad; north, east) at a height (m); none where the map projection has no
    /// inverse.
    pub fn point(&self, [north, east]: [f64; 2], height: f64) -> Option<DVec3> {
        let on = |body: &Ellipsoid, [latitude, longitude]: [f64; 2]| {
            body.point(Geodetic { latitude, longitude, height })
        };
        match self {
            Self::Plane => Some(DVec3::new(east, north, height)),
            Self::Degrees => Some(DVec3::new(degrees(east), degrees(north), height)),
            Self::Geographic(body) => Some(on(body, [north, east])),
            Self::Projected(body, projection) => Some(on(body, projection.inverse([north, east])?)),
        }
    }

    /// Latitude, longitude (rad) and height (m) of a ground point on a body; none of other rules.
    pub fn place(&self, point: DVec3) -> Option<Geodetic> {
        match self {
            Self::Geographic(body) | Self::Projected(body, _) => Some(body.place(point)),
            Self::Plane | Self::Degrees => None,
        }
    }
}

fn of_landscape(frame: Frame) -> Result<Rule, GroundError> {
    match frame {
        Frame::Plane(_) => Ok(Rule::Plane),
        Frame::Geographic { .. } => Err(GroundError::Axes {
            found: "in degrees",
            photo: "a camera in the axes of a landscape",
            expected: "in metres of a plane",
            remedy: "give the elevation file that was made with the photograph",
        }),
    }
}

fn of_body(body: Ellipsoid, frame: Frame) -> Result<Rule, GroundError> {
    match frame {
        Frame::Geographic { .. } => Ok(Rule::Geographic(body)),
        Frame::Plane(Some(projection)) => Ok(Rule::Projected(body, projection)),
        Frame::Plane(None) => Err(GroundError::Axes {
            found: "in metres of an unknown map",
            photo: "a camera over a body",
            expected: "in degrees or in a known map projection",
            remedy: "give an elevation file that names its projection",
        }),
    }
}

fn of_map(map: &Map, frame: Frame) -> Result<Rule, GroundError> {
    match (map.unit(), frame) {
        (MapUnit::Metre, Frame::Plane(_)) => Ok(Rule::Plane),
        (MapUnit::Degree, Frame::Geographic { .. }) => Ok(Rule::Degrees),
        (MapUnit::Metre, Frame::Geographic { .. }) => Err(GroundError::Axes {
            found: "in degrees",
            photo: "a map in metres",
            expected: "in metres",
            remedy: "give the map file in degrees, or project the elevation file",
        }),
        (MapUnit::Degree, Frame::Plane(_)) => Err(GroundError::Axes {
            found: "in metres",
            photo: "a map in degrees",
            expected: "in degrees",
            remedy: "give the map file in metres of the same projection",
        }),
    }
}
