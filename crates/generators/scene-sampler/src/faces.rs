//! Triangles of a frame on the screen: ground, bodies, sheets, overlays.

use generator::Label;
use glam::DVec3;
use raster::{Attribute, ClipError, Clipper, DistancePlane, Point, Screen, Triangle, doubled_area};
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

/// A corner of opaque faces.
#[derive(Debug, Clone, Copy)]
pub struct Corner {
    /// Place in camera axes (m).
    pub place: DVec3,
    /// Its colour (linear red, green, blue).
    pub colour: [f64; 3],
}

/// How a triangle looks.
#[derive(Debug, Clone, Copy)]
pub enum Paint {
    /// Opaque, with the colours of three corners of the frame.
    Corners([u32; 3]),
    /// Opaque, at three corners of the frame, with the colours of the ground's map.
    Mapped([u32; 3]),
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
}

/// Which sides of a face are seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sides {
    /// The side from which its corners run counter-clockwise.
    Front,
    /// Both of its sides are seen.
    Both,
}

/// Where the distance and the look of a triangle come from. There are as many as triangles, so each is short.
#[derive(Debug, Clone, Copy)]
pub enum Look {
    /// From three corners of the frame.
    Corners {
        /// Numbers of the corners.
        corners: [u32; 3],
        /// Number of its feature.
        id: u32,
        /// Priority of its feature.
        priority: i32,
    },
    /// Distance from three corners of the frame, the look of each pixel from the ground's map.
    Mapped {
        /// Numbers of the corners.
        corners: [u32; 3],
        /// Number of its feature.
        id: u32,
        /// Priority of its feature.
        priority: i32,
    },
    /// From the plane of this number.
    Plane(u32),
}

/// What a triangle of the list is.
#[derive(Debug, Clone, Copy)]
pub enum Surface {
    /// A feature that is the same in all pixels.
    Ready(Feature),
    /// Dust; number of the sheet in the frame.
    Dust(u32),
    /// Ground whose colours stand in a map.
    Mapped(Mapped),
}

/// Ground whose colours are looked up in each pixel's middle.
#[derive(Debug, Clone, Copy)]
pub struct Mapped {
    /// Number of its feature.
    pub id: u32,
    /// Priority of its feature.
    pub priority: i32,
    /// Nearness (1/m) of its farthest and its nearest corner.
    pub between: [f64; 2],
}

/// Triangles on the screen with their distance and look, in one order.
#[derive(Debug, Default)]
pub struct Faces {
    /// Edge functions of each triangle.
    pub triangles: Vec<Triangle>,
    /// Distance and look of each triangle.
    pub looks: Vec<Look>,
    /// Corners of opaque faces.
    pub corners: Vec<Corner>,
    /// Planes of faces that look the same all over.
    pub planes: Vec<(DistancePlane, Surface)>,
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

    /// Makes room for so many further triangles.
    pub fn reserve(&mut self, triangles: usize) {
        self.triangles.reserve(triangles);
        self.looks.reserve(triangles);
    }

    /// Adds the triangles of a part of the frame behind its own; the part has no numbers, corners or planes of its own.
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
    pub fn add(
        &mut self,
        face: &Face,
        paint: Paint,
        camera: &Camera,
        screen: &Screen,
    ) -> Result<(), FaceError> {
        self.work.faces += 1;
        let fan = Clipper::new(&camera.projection, screen, NEAR).clip(face.corners)?;
        self.take(face, paint, camera, &fan);
        Ok(())
    }

    /// Adds a face that no border cuts, with its corners on the screen; none if it is not on the screen at all.
    pub fn add_whole(&mut self, face: &Face, paint: Paint, camera: &Camera, corners: Option<[Point; 3]>) {
        self.work.faces += 1;
        self.take(face, paint, camera, corners.as_slice());
    }

    /// Adds what clipping left of a face.
    fn take(&mut self, face: &Face, paint: Paint, camera: &Camera, fan: &[[Point; 3]]) {
        if fan.is_empty() {
            return;
        }
        let Some(plane) = DistancePlane::new(face.corners, &camera.projection) else { return };
        let is_seen = |corners: &[Point; 3]| match face.sides {
            Sides::Both => true,
            Sides::Front => doubled_area(*corners) < 0,
        };
        self.work.corners += fan.len() as u64 + 2;
        let before = self.triangles.len();
        self.triangles.extend(
            fan.iter().filter(|corners| is_seen(corners)).filter_map(|corners| Triangle::new(*corners)),
        );
        let count = self.triangles.len() - before;
        if count > 0 {
            let look = self.look(face, paint, plane);
            self.looks.resize(self.triangles.len(), look);
            self.work.triangles += count as u64;
        }
    }

    /// The same of an opaque face whose corners have `colours` (linear red, green, blue) of its own.
    ///
    /// # Errors As [`Faces::add`].
    pub fn add_opaque(
        &mut self,
        face: &Face,
        colours: [[f64; 3]; 3],
        camera: &Camera,
        screen: &Screen,
    ) -> Result<(), FaceError> {
        let (before, first) = (self.looks.len(), self.corners.len() as u32);
        self.add(face, Paint::Corners([first, first + 1, first + 2]), camera, screen)?;
        if self.looks.len() > before {
            let corner = |k: usize| Corner { place: face.corners[k], colour: colours[k] };
            self.corners.extend([0, 1, 2].map(corner));
        }
        Ok(())
    }

    /// Distance of a triangle of the list.
    pub fn plane(&self, triangle: u32, camera: &Camera) -> Option<DistancePlane> {
        match self.looks[triangle as usize] {
            Look::Plane(plane) => Some(self.planes[plane as usize].0),
            Look::Corners { corners, .. } | Look::Mapped { corners, .. } => {
                let places = corners.map(|corner| self.corners[corner as usize].place);
                DistancePlane::new(places, &camera.projection)
            }
        }
    }

    /// Distance and look of a triangle of the list.
    pub fn seen(&self, triangle: u32, camera: &Camera) -> Option<(DistancePlane, Surface)> {
        match self.looks[triangle as usize] {
            Look::Plane(plane) => Some(self.planes[plane as usize]),
            Look::Corners { corners, id, priority } => {
                let plane = self.plane(triangle, camera)?;
                let corners = corners.map(|corner| self.corners[corner as usize]);
                Some((plane, Surface::Ready(shaded(corners, id, priority, plane, camera))))
            }
            Look::Mapped { corners, id, priority } => {
                // What lies nearer than where features are cut is not seen.
                let q = corners.map(|corner| 1.0 / self.corners[corner as usize].place.z.max(NEAR));
                let between = [q[0].min(q[1]).min(q[2]), q[0].max(q[1]).max(q[2])];
                Some((self.plane(triangle, camera)?, Surface::Mapped(Mapped { id, priority, between })))
            }
        }
    }

    /// How a face looks that is on the screen.
    fn look(&mut self, face: &Face, paint: Paint, plane: DistancePlane) -> Look {
        let surface = match paint {
            Paint::Corners(corners) => {
                return Look::Corners { corners, id: face.id, priority: face.priority };
            }
            Paint::Mapped(corners) => {
                return Look::Mapped { corners, id: face.id, priority: face.priority };
            }
            Paint::Flat(feature) => Surface::Ready(feature),
            Paint::Dust(sheet) => Surface::Dust(sheet),
        };
        self.planes.push((plane, surface));
        Look::Plane(self.planes.len() as u32 - 1)
    }
}

/// The feature of a triangle whose corners have colours.
fn shaded(corners: [Corner; 3], id: u32, priority: i32, plane: DistancePlane, camera: &Camera) -> Feature {
    let places = corners.map(|corner| corner.place);
    let channels = Attribute::channels(places, corners.map(|corner| corner.colour), &camera.projection);
    Feature::shaded(id, priority, channels, plane)
}
