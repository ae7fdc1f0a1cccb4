//! A georeferenced picture: an affine from pixels to the coordinates of a map.

use glam::DVec3;
use photo_camera::{Affine, CameraError};

/// Unit of the coordinates of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapUnit {
    /// Metres east and north.
    Metre,
    /// Degrees of longitude and latitude. Longitudes are compared modulo 360 degrees.
    Degree,
}

impl MapUnit {
    /// The word of the unit in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Degree => "deg",
        }
    }
}

/// How a picture lies on a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map {
    affine: Affine,
    unit: MapUnit,
}

impl Map {
    /// The map of the rows `east = a I + b J + c` and `north = a I + b J + c`, in `unit`.
    ///
    /// # Errors
    ///
    /// If a coefficient is not finite, or the affine maps the picture onto a line.
    pub fn new(east: [f64; 3], north: [f64; 3], unit: MapUnit) -> Result<Self, CameraError> {
        Ok(Self { affine: Affine::new(east, north)?, unit })
    }

    /// Unit of the coordinates.
    pub fn unit(&self) -> MapUnit {
        self.unit
    }

    /// The rows of east and north, each (a, b, c).
    pub fn rows(&self) -> [[f64; 3]; 2] {
        self.affine.rows()
    }

    /// Pixel I, J of a point: x east or longitude, y north or latitude. A longitude is taken within half a turn of pixel (0, 0).
    pub fn pixel(&self, point: DVec3) -> [f64; 2] {
        let east = match self.unit {
            MapUnit::Metre => point.x,
            MapUnit::Degree => {
                let from = self.affine.rows()[0][2];
                let apart = point.x - from;
                from + apart - 360.0 * (apart / 360.0).round()
            }
        };
        self.affine.pixel([east, point.y])
    }

    /// The point of a pixel I, J at a height (m).
    pub fn point(&self, pixel: [f64; 2], height: f64) -> DVec3 {
        let [east, north] = self.affine.image(pixel);
        DVec3::new(east, north, height)
    }
}
