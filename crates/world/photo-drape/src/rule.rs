//! How the axes of a photograph lie in those of a landscape.

use glam::DVec3;
use landscape::{Bank, MapFrame};
use photo_camera::{Axes, Ellipsoid, Geodetic};
use photograph::{MapUnit, Placement};
use quantities::degrees;

use crate::DrapeError;

/// From places of a landscape (north, east, up; m) to ground points of a photograph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rule {
    /// East and north from an origin (m).
    Plane([f64; 2]),
    /// Degrees of longitude and latitude, by the map of the bank.
    Degrees(MapFrame),
    /// On a body, by the map of the bank.
    Body(Ellipsoid, MapFrame),
}

impl Rule {
    /// The rule of photograph `number` (from 1).
    ///
    /// # Errors
    /// If the bank does not say where it lies, and the photograph's axes are not those of a landscape.
    pub fn of(placement: &Placement, bank: &Bank, number: usize) -> Result<Self, DrapeError> {
        let projected = |what: &'static str| {
            let map = bank.map().filter(|map| map.projection.is_some());
            map.copied().ok_or(DrapeError::Axes { number, what })
        };
        Ok(match placement {
            Placement::Camera { axes: Axes::Landscape, .. } => Self::Plane([0.0; 2]),
            Placement::Camera { axes: Axes::Body(body), .. } => {
                Self::Body(*body, projected("its camera stands in the axes of a body")?)
            }
            // A map in metres is in the coordinates of the elevation file that the bank was made of.
            Placement::Map(map) if map.unit() == MapUnit::Metre => {
                Self::Plane(bank.map().map_or([0.0; 2], |map| map.origin))
            }
            Placement::Map(_) => Self::Degrees(projected("it is a map in degrees")?),
        })
    }

    /// The ground point of a place; none where the map of the bank does not show it.
    pub fn point(&self, place: DVec3) -> Option<DVec3> {
        let [north, east, height] = place.to_array();
        match self {
            Self::Plane(origin) => Some(DVec3::new(east + origin[1], north + origin[0], height)),
            Self::Degrees(map) => {
                let [latitude, longitude] = map.point([north, east])?;
                Some(DVec3::new(degrees(longitude), degrees(latitude), height))
            }
            Self::Body(body, map) => {
                let [latitude, longitude] = map.point([north, east])?;
                Some(body.point(Geodetic { latitude, longitude, height }))
            }
        }
    }

    /// The place of a camera (north, east, up; m) in the axes of the landscape; none where the bank's map does not show it.
    pub fn place(&self, centre: DVec3) -> Option<DVec3> {
        match self {
            Self::Plane(origin) => Some(DVec3::new(centre.y - origin[0], centre.x - origin[1], centre.z)),
            Self::Degrees(_) => None,
            Self::Body(body, map) => {
                let Geodetic { latitude, longitude, height } = body.place(centre);
                let [north, east] = map.of_point(latitude, longitude)?;
                Some(DVec3::new(north, east, height))
            }
        }
    }
}
