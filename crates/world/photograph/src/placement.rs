//! How the pixels of a photograph lie on the ground.

use glam::DVec3;
use photo_camera::{Axes, Camera, Image};

use crate::{Map, MapUnit};

/// The rule between pixels and ground points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Placement {
    /// The perspective of a camera. Ground points stand in its axes (m).
    Camera {
        /// The camera of the photograph.
        camera: Camera,
        /// Axes of the camera and of ground points.
        axes: Axes,
    },
    /// A map without perspective. Ground points are east, north, height in the unit of the map.
    Map(Map),
}

impl Placement {
    /// Pixel I, J of a ground point, inside the picture or not; none behind the camera.
    pub fn pixel(&self, point: DVec3) -> Option<[f64; 2]> {
        match self {
            Self::Camera { camera, .. } => match camera.project(point) {
                Image::Front { pixel, .. } => Some(pixel),
                Image::Behind { .. } => None,
            },
            Self::Map(map) => Some(map.pixel(point)),
        }
    }

    /// The ground point that a pixel I, J shows of a surface of constant `height` (m); none where its ray passes the surface.
    pub fn on_level(&self, pixel: [f64; 2], height: f64) -> Option<DVec3> {
        match self {
            Self::Camera { camera, axes: Axes::Body(body) } => camera.ray(pixel).on_body(body, height),
            Self::Camera { camera, axes: Axes::Landscape } => {
                camera.ray(pixel).on_plane(DVec3::Z * height, DVec3::Z)
            }
            Self::Map(map) => Some(map.point(pixel, height)),
        }
    }

    /// Unit of a ground sample: metres, or degrees for a map in degrees.
    pub fn unit(&self) -> MapUnit {
        match self {
            Self::Camera { .. } => MapUnit::Metre,
            Self::Map(map) => map.unit(),
        }
    }

    /// Height (m) of a ground point.
    fn height(&self, point: DVec3) -> f64 {
        match self {
            Self::Camera { axes: Axes::Body(body), .. } => body.place(point).height,
            _ => point.z,
        }
    }

    /// Lengths on level ground of one step of I and of one step of J at a ground point: metres, or the unit of the map. None
    /// where the point has no pixel or the steps leave the level ground.
    pub fn ground_sample(&self, point: DVec3) -> Option<[f64; 2]> {
        let [i, j] = self.pixel(point)?;
        let height = self.height(point);
        let step = |di: f64, dj: f64| {
            let ends = [0.5, -0.5].map(|side| self.on_level([i + side * di, j + side * dj], height));
            Some((ends[0]? - ends[1]?).length())
        };
        Some([step(1.0, 0.0)?, step(0.0, 1.0)?])
    }
}
