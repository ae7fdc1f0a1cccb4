//! Where a bank came from: how its axes lie in the map of the elevation file.

use std::f64::consts::PI;

use crate::projection::{Method, Projection};

/// How the axes of a bank lie in the map of the elevation file that it was made of. The origin of the bank is a point of
/// the map. For a bank of a whole file it is the centre of the south-west sample, not the outer corner of that sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapFrame {
    /// Projection of the map; its sphere is the datum of the heights. `None` if the file does not name one that is known.
    pub projection: Option<Projection>,
    /// What the file's own coordinates are.
    pub coordinates: FileCoordinates,
    /// Origin of the bank in the map: north, east (m).
    pub origin: [f64; 2],
    /// Centre of the south-west sample in the bank: north, east (m).
    pub first_sample: [f64; 2],
    /// From sample to sample: north, east (m).
    pub spacing: [f64; 2],
}

/// Coordinates of an elevation file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileCoordinates {
    /// Metres of its projection, north and east.
    Metres,
    /// Latitude and longitude; the map is the plane that the survey laid them onto.
    Degrees,
}

/// Which point of a sample its place is, for people.
pub const SPACING_RULE: &str = "a sample is the point at its centre: the south-west sample lies in the bank at south_west_sample, the bank's (0, 0) in the map at origin";

impl FileCoordinates {
    /// Unit of the coordinates, in one word.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Metres => "metres",
            Self::Degrees => "degrees",
        }
    }
}

impl MapFrame {
    /// Name of the projection; "unknown" if the file does not name one that is known.
    pub fn projection_name(&self) -> &'static str {
        match self.projection.map(|projection| projection.method) {
            None => "unknown",
            Some(Method::Equirectangular { .. }) => "equirectangular",
            Some(Method::PolarStereographic { .. }) => "polar stereographic",
            Some(Method::Orthographic) => "orthographic",
        }
    }

    /// Place in the bank (north, east; m) of a point of the sphere (rad). `None` without a known projection, and for points
    /// that the projection does not show.
    pub fn of_point(&self, latitude: f64, longitude: f64) -> Option<[f64; 2]> {
        let projection = self.projection?;
        // Banks lie to the east of their origin, and are at most one turn wide.
        let quarter = match projection.method {
            Method::Equirectangular { parallel } => 0.5 * PI * projection.radius * libm::cos(parallel),
            Method::PolarStereographic { .. } | Method::Orthographic => 0.0,
        };
        let near = [self.origin[0], self.origin[1] + quarter];
        let place = projection.forward_near(latitude, longitude, near)?;
        Some([0, 1].map(|axis| place[axis] - self.origin[axis]))
    }

    /// Latitude and longitude (rad) of a place in the bank (north, east; m).
    pub fn point(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        self.projection?.inverse([0, 1].map(|axis| place[axis] + self.origin[axis]))
    }

    /// Direction of true north at a place in the bank, clockwise from the bank's north axis (rad).
    pub fn true_north(&self, place: [f64; 2]) -> Option<f64> {
        self.projection?.true_north([0, 1].map(|axis| place[axis] + self.origin[axis]))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{prop_assert, proptest};
    use quantities::radians;

    use super::{FileCoordinates, MapFrame};
    use crate::projection::{Method, Projection};

    fn frame(method: Method, latitude: f64, longitude: f64, origin: [f64; 2]) -> MapFrame {
        let [latitude, longitude] = [latitude, longitude].map(radians);
        let projection = Projection { method, latitude, longitude, radius: 1_737_400.0, offset: [0.0; 2] };
        MapFrame {
            projection: Some(projection),
            coordinates: FileCoordinates::Metres,
            origin,
            first_sample: [0.0; 2],
            spacing: [1.0; 2],
        }
    }

    #[test]
    fn a_degree_of_the_equator() {
        let flat = frame(Method::Equirectangular { parallel: 0.0 }, 0.0, 0.0, [1000.0, 2000.0]);
        let degree = 1_737_400.0 * radians(1.0);
        let [north, east] = flat.of_point(radians(1.0), radians(2.0)).unwrap();
        assert!((north - (degree - 1000.0)).abs() < 1e-6 && (east - (2.0 * degree - 2000.0)).abs() < 1e-6);
        assert_eq!(MapFrame { projection: None, ..flat }.of_point(0.0, 0.0), None);
    }

    /// A bank whose file counts longitudes from 0 to 360 lies east of 180 degrees.
    #[test]
    fn longitudes_beyond_half_a_turn() {
        let degree = 1_737_400.0 * radians(1.0);
        let flat = frame(Method::Equirectangular { parallel: 0.0 }, 0.0, 0.0, [0.0, 190.0 * degree]);
        let [_, east] = flat.of_point(0.0, radians(-165.0)).unwrap();
        assert!((east - 5.0 * degree).abs() < 1e-5, "{east}");
    }

    proptest! {
        #[test]
        fn points_come_back(kind in 0..3, north in 0.0..20_000.0f64, east in 0.0..20_000.0f64) {
            let frame = match kind {
                0 => frame(Method::Equirectangular { parallel: 0.3 }, 10.0, 20.0, [3e5, 4e5]),
                1 => frame(Method::PolarStereographic { scale: 1.0 }, -90.0, 0.0, [150_000.0, -15_000.0]),
                _ => frame(Method::Orthographic, 8.0, -38.0, [-1e4, 2e4]),
            };
            let [latitude, longitude] = frame.point([north, east]).unwrap();
            let back = frame.of_point(latitude, longitude).unwrap();
            prop_assert!((back[0] - north).abs() < 1e-6 && (back[1] - east).abs() < 1e-6, "{back:?}");
        }
    }
}
