//! Triangles of a frame on the screen: ground, bodies, sheets, overlays.

use generator::Label;
use glam::DVec3;
use raster::{Attribute, ClipError, DistancePlane, Point, Screen, Triangle, clip, doubled_area};
use translucency::{Feature, FeatureError};

use crate::camera::Camera;

/// Depth at which features are cut (m). Chosen.
pub const NEAR: f64 = 0.05;

/// Why a frame's features cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FaceError {
    /// A corner that cannot be drawn.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// A figure that no feature has.
    #[error(transparent)]
    Feature(#[from] FeatureError),
}

/// How a triangle looks.
#[derive(Debug, Clone, Copy)]
pub enum Paint {
    /// Opaque, with a colour at each corner.
    Corners([[f64; 3]; 3]),
    /// One colour and translucency all over.
    Flat(Feature),
    /// Dust: translucency follows from the path; number of the sheet in the frame.
    Dust(u32),
}

/// A triangle of a feature in camera axes.
#[derive(Debug, Clone, Copy)]
pub struct Face {
    /// Corners in camera axes (m).
    pub corners: [DVec3; 3],
    /// Number of its feature.
    pub id: u32,
    /// Priority of its feature.
    pub priority: i32,
    /// Which sides are seen.
    pub sides: Sides,
    /// How the triangle looks all over.
    pub paint: Paint,
}

/// Which sides of a face are seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sides {
    /// The side from which its corners run counter-clockwise.
    Front,
    /// Both of its sides are seen.
    Both,
}

/// What a triangle of the list is.
#[derive(Debug, Clone, Copy)]
pub enum Surface {
    /// A feature that is the same in all pixels.
    Ready(Feature),
    /// Dust; number of the sheet in the frame.
    Dust(u32),
}

/// Triangles on the screen with their distance and look, in one order.
#[derive(Debug, Default)]
pub struct Faces {
    /// Edge functions of each triangle.
    pub triangles: Vec<Triangle>,
    /// Distance and look of each triangle.
    pub looks: Vec<(DistancePlane, Surface)>,
    /// What the features of each number are, by number.
    pub labels: Vec<Label>,
    /// Features that were transformed, and corners of what was left of them.
    pub work: Work,
}

/// Counted work of the geometry unit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Faces that were transformed.
    pub faces: u64,
    /// Triangles that clipping left.
    pub triangles: u64,
    /// Corners of the polygons that clipping left.
    pub corners: u64,
}

impl Faces {
    /// A number for a feature of the kind `label`.
    pub fn number(&mut self, label: Label) -> u32 {
        self.labels.push(label);
        self.labels.len() as u32 - 1
    }

    /// Adds the triangles of a part of the frame behind its own; the part has no numbers of its own.
    pub fn append(&mut self, part: Self) {
        self.triangles.extend(part.triangles);
        self.looks.extend(part.looks);
        self.work.faces += part.work.faces;
        self.work.triangles += part.work.triangles;
        self.work.corners += part.work.corners;
    }

    /// Clips and adds a face; one that is not seen adds nothing.
    ///
    /// # Errors If a corner is no number, or so near that the raster cannot hold it.
    pub fn add(&mut self, face: &Face, camera: &Camera, screen: &Screen) -> Result<(), FaceError> {
        self.work.faces += 1;
        let fan = clip(face.corners, &camera.projection, screen, NEAR)?;
        if fan.is_empty() {
            return Ok(());
        }
        let Some(plane) = DistancePlane::new(face.corners, &camera.projection) else { return Ok(()) };
        let is_seen = |corners: &[Point; 3]| match face.sides {
            Sides::Both => true,
            Sides::Front => doubled_area(*corners) < 0,
        };
        let surface = surface(face, plane, camera);
        self.work.corners += fan.len() as u64 + 2;
        for triangle in fan.into_iter().filter(is_seen).filter_map(Triangle::new) {
            self.triangles.push(triangle);
            self.looks.push((plane, surface));
            self.work.triangles += 1;
        }
        Ok(())
    }
}

fn surface(face: &Face, plane: DistancePlane, camera: &Camera) -> Surface {
    match face.paint {
        Paint::Flat(feature) => Surface::Ready(feature),
        Paint::Dust(sheet) => Surface::Dust(sheet),
        Paint::Corners(colours) => {
            let channel =
                |k: usize| Attribute::new(face.corners, colours.map(|colour| colour[k]), &camera.projection);
            Surface::Ready(Feature::shaded(face.id, face.priority, [0, 1, 2].map(channel), plane))
        }
    }
}
