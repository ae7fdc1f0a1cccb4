//! The faces of a body as triangles, worked out one by one.

use glam::DVec3;
use solids::Body;

use crate::check::Outline;
use crate::error::FaceError;
use crate::face::Sides;
use crate::model::ModelShading;

/// The faces of a body in terrain axes (north, east, up; m), cut in triangles from the first corner of each face.
///
/// A mission has tens of thousands of bodies, and a frame sees few of their faces. So a triangle is worked out when it is asked for, and the
/// normals at its corners when it is seen. A triangle without an area is left out.
#[derive(Debug, Clone)]
pub struct BodyFaces<'a> {
    body: &'a Body,
    places: Vec<DVec3>,
}

/// A triangle of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyTriangle {
    /// Places of its corners (m), counter-clockwise seen from the front.
    pub places: [DVec3; 3],
    /// Unit normal towards its front.
    pub normal: DVec3,
    /// Face of the solid that it is cut from.
    pub face: usize,
    /// Vertices of the solid at its corners.
    corners: [u32; 3],
}

/// Normals at the corners of the triangles of a body.
#[derive(Debug, Clone)]
pub struct BodyNormals<'a> {
    body: &'a Body,
    source: Source,
}

#[derive(Debug, Clone)]
enum Source {
    /// Every triangle is flat.
    Triangle,
    /// The solid has normals of its own.
    Solid,
    /// Averages over the faces that meet at each vertex; nothing where they cancel.
    Averages(Vec<Option<DVec3>>),
}

impl<'a> BodyFaces<'a> {
    /// The faces of a body, which errors call the list `list`.
    ///
    /// # Errors
    /// If a place of the body is not finite.
    pub fn new(list: &str, body: &'a Body) -> Result<Self, FaceError> {
        let places: Vec<DVec3> = body.vertices().collect();
        match places.iter().position(|place| !place.is_finite()) {
            Some(vertex) => Err(FaceError::Place { list: list.into(), vertex }),
            None => Ok(Self { body, places }),
        }
    }

    /// Corners of all faces of the solid: a generator has each of them as a vertex.
    pub fn vertices(&self) -> u64 {
        self.body.solid.faces().iter().map(|face| face.corners.len() as u64).sum()
    }

    /// Which sides of the faces are seen: a surface that does not close is seen from both.
    pub fn sides(&self) -> Sides {
        if self.body.solid.is_open() { Sides::Both } else { Sides::One }
    }

    /// Linear red, green and blue of a triangle, 0 to 1 each.
    pub fn colour(&self, triangle: &BodyTriangle) -> [f64; 3] {
        self.body.solid.albedo(triangle.face)
    }

    /// All triangles with an area, face by face.
    pub fn triangles(&self) -> impl Iterator<Item = BodyTriangle> {
        self.body.solid.faces().iter().enumerate().flat_map(move |(face, of)| {
            let corners = &of.corners;
            (2..corners.len())
                .filter_map(move |last| self.triangle(face, [corners[0], corners[last - 1], corners[last]]))
        })
    }

    fn triangle(&self, face: usize, corners: [u32; 3]) -> Option<BodyTriangle> {
        let places = corners.map(|corner| self.places[corner as usize]);
        let outline = Outline { list: "", face, corners: &corners, places: &places };
        let has_area = outline.degenerate().is_none();
        has_area.then(|| BodyTriangle { places, normal: outline.normal(), face, corners })
    }

    /// Normals at the corners. `Smooth` averages over the faces that meet at a vertex unless the body has normals of its own;
    /// `AsWritten` leaves a body without normals flat.
    pub fn normals(&self, shading: ModelShading) -> BodyNormals<'a> {
        let source = match (shading, self.body.solid.is_smooth()) {
            (ModelShading::Flat, _) | (ModelShading::AsWritten, false) => Source::Triangle,
            (_, true) => Source::Solid,
            (ModelShading::Smooth, false) => Source::Averages(averages(self.body, self.places.len())),
        };
        BodyNormals { body: self.body, source }
    }
}

impl BodyNormals<'_> {
    /// Unit normals at the corners of a triangle, in their order.
    pub fn of(&self, triangle: &BodyTriangle) -> [DVec3; 3] {
        let own = || self.body.normal(triangle.face);
        match &self.source {
            Source::Triangle => [triangle.normal; 3],
            Source::Solid => {
                triangle.places.map(|place| self.body.normal_at(triangle.face, place).normalize())
            }
            Source::Averages(units) => {
                triangle.corners.map(|corner| units[corner as usize].unwrap_or_else(own).normalize())
            }
        }
    }
}

/// Mean direction of the normals of the faces at each vertex.
fn averages(body: &Body, vertices: usize) -> Vec<Option<DVec3>> {
    let mut sums = vec![DVec3::ZERO; vertices];
    for (face, normal) in body.solid.faces().iter().zip(body.normals()) {
        face.corners.iter().for_each(|&corner| sums[corner as usize] += normal);
    }
    sums.into_iter().map(DVec3::try_normalize).collect()
}
