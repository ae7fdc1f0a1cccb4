//! A single polyhedron, convex if it is closed.

use std::fmt;

use glam::DVec3;
use photometry::Photometry;

use crate::check::{check_closed, check_convex, check_counts, check_most, check_vertices, plane_of};
use crate::edges::edges_of;
use crate::{EdgeWords, Eights, SolidError};

/// One flat side: a convex polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Corners, counter-clockwise seen from outside.
    pub corners: Vec<u32>,
    /// Unit normal of the face, outwards.
    pub normal: DVec3,
    /// Share of the light that is returned, 0..=1.
    pub albedo: f64,
}

/// A polyhedron in body axes (m), its foot point at the origin: closed and convex, or open ([`is_open`](Self::is_open)).
#[derive(Clone, PartialEq)]
pub struct Solid {
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) faces: Vec<Face>,
    /// Albedo of each face for red, green and blue light, where there is colour.
    pub(crate) colours: Option<Box<[[f64; 3]]>>,
    /// Unit normals at the corners of each face, where light is smooth.
    pub(crate) normals: Option<Box<[Vec<DVec3>]>>,
    /// How its faces return light.
    pub(crate) photometry: Photometry,
    is_open: bool,
    edge_words: Box<[EdgeWords]>,
    pub(crate) eights: Eights,
    radius: f64,
    size: f64,
}

/// All fields. The law of reflection is left out where it is Lambert's: hashes of this text are older than the law.
impl fmt::Debug for Solid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = f.debug_struct("Solid");
        text.field("vertices", &self.vertices).field("faces", &self.faces);
        text.field("colours", &self.colours).field("normals", &self.normals);
        if self.photometry != Photometry::Lambert {
            text.field("photometry", &self.photometry);
        }
        text.field("is_open", &self.is_open).field("edge_words", &self.edge_words);
        text.field("eights", &self.eights).field("radius", &self.radius).field("size", &self.size);
        text.finish()
    }
}

impl Solid {
    /// Deviations from plane and convex faces up to this share of the size pass: files round their numbers.
    pub const TOLERANCE: f64 = 1e-4;
    /// Largest number of vertices, and of faces.
    pub const MOST: usize = 2048;

    /// The solid of `faces`, each a list of corners (indices of `vertices`) and an albedo. Corners may run
    /// either way round; faces are turned so that normals point outwards.
    ///
    /// # Errors If the faces are not plane, do not close, or do not enclose a convex volume, within
    /// [`Self::TOLERANCE`].
    pub fn new(vertices: Vec<DVec3>, faces: Vec<(Vec<u32>, f64)>) -> Result<Self, SolidError> {
        check_counts(vertices.len(), faces.len())?;
        check_vertices(&vertices)?;
        let size = size_of(&vertices);
        let inside = vertices.iter().sum::<DVec3>() / vertices.len() as f64;
        let outwards =
            |(index, (corners, albedo))| outward_face(&vertices, index, corners, albedo, inside, size);
        let faces = faces.into_iter().enumerate().map(outwards).collect::<Result<Vec<_>, _>>()?;
        Self::closed(vertices, faces, size)
    }

    /// The solid of faces whose normals are known, as of one that was cut out of another: they are kept however small a face is.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(crate) fn of_faces(vertices: Vec<DVec3>, faces: Vec<Face>) -> Result<Self, SolidError> {
        check_counts(vertices.len(), faces.len())?;
        check_vertices(&vertices)?;
        let size = size_of(&vertices);
        Self::closed(vertices, faces, size)
    }

    /// The solid of faces that look outwards; `size` is the largest distance between two vertices (m).
    fn closed(vertices: Vec<DVec3>, faces: Vec<Face>, size: f64) -> Result<Self, SolidError> {
        check_convex(&vertices, &faces, Self::TOLERANCE * size)?;
        check_closed(&faces, vertices.len())?;
        let radius = vertices.iter().map(|vertex| vertex.length()).fold(0.0, f64::max);
        let edge_words = EdgeWords::all(&edges_of(&faces), [vertices.len(), faces.len()]);
        let eights = Eights::new(&vertices, &faces);
        let (colours, normals) = (None, None);
        let photometry = Photometry::Lambert;
        Ok(Self {
            vertices,
            faces,
            colours,
            normals,
            photometry,
            is_open: false,
            edge_words,
            eights,
            radius,
            size,
        })
    }

    /// A surface of faces that need not close, nor enclose anything convex: each is seen from both sides. Its front is where its
    /// corners run counter-clockwise. It is no body for the hybrid machine.
    ///
    /// # Errors
    /// If the faces are not plane and convex within [`Self::TOLERANCE`], or there are none.
    pub fn open(vertices: Vec<DVec3>, faces: Vec<(Vec<u32>, f64)>) -> Result<Self, SolidError> {
        check_most(vertices.len(), faces.len(), [3, 1])?;
        check_vertices(&vertices)?;
        let size = size_of(&vertices);
        let front = |(index, (corners, albedo)): (usize, (Vec<u32>, f64))| {
            let albedo = checked_albedo(index, albedo)?;
            // Body axes are left-handed: seen from the front the cross product points away.
            let (normal, _) = plane_of(&vertices, index, &corners, size)?;
            Ok(Face { corners, normal: -normal, albedo })
        };
        let faces = faces.into_iter().enumerate().map(front).collect::<Result<Vec<_>, SolidError>>()?;
        let radius = vertices.iter().map(|vertex| vertex.length()).fold(0.0, f64::max);
        let eights = Eights::new(&vertices, &faces);
        let (colours, normals, edge_words) = (None, None, Box::default());
        let photometry = Photometry::Lambert;
        Ok(Self {
            vertices,
            faces,
            colours,
            normals,
            photometry,
            is_open: true,
            edge_words,
            eights,
            radius,
            size,
        })
    }

    /// Whether its faces need not close: both of their sides are seen, and nothing is inside.
    pub fn is_open(&self) -> bool {
        self.is_open
    }

    /// Returns the vertices in body axes (m).
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Returns the faces of the solid.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Edges by words; none for a solid of more corners or faces than can be told.
    pub fn edge_words(&self) -> &[EdgeWords] {
        &self.edge_words
    }

    /// Whether a face holds a place of its plane (body axes; m); its edge belongs to it.
    pub(crate) fn holds(&self, face: usize, place: DVec3) -> bool {
        let Face { corners, normal, .. } = &self.faces[face];
        let room = 1e-12 * self.size * self.size;
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).all(|(&from, &to)| {
            let [from, to] = [from, to].map(|corner| self.vertices[corner as usize]);
            normal.dot((to - from).cross(place - from)) <= room
        })
    }

    /// Vertices and faces, eight side by side.
    pub fn eights(&self) -> &Eights {
        &self.eights
    }

    /// Largest distance of a vertex from the foot point (m).
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Largest distance between two vertices (m).
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The same with the albedo that `paint` gives to each face by its outward normal.
    ///
    /// # Errors
    /// If an albedo is not 0 to 1.
    pub fn painted(mut self, paint: impl Fn(DVec3) -> f64) -> Result<Self, SolidError> {
        for (index, face) in self.faces.iter_mut().enumerate() {
            face.albedo = checked_albedo(index, paint(face.normal))?;
        }
        self.eights = Eights::new(&self.vertices, &self.faces);
        Ok(self)
    }
}

fn size_of(vertices: &[DVec3]) -> f64 {
    let others = |(index, &from): (usize, &DVec3)| {
        vertices[..index].iter().map(move |to| from.distance_squared(*to)).fold(0.0, f64::max)
    };
    vertices.iter().enumerate().map(others).fold(0.0, f64::max).sqrt()
}

fn checked_albedo(face: usize, albedo: f64) -> Result<f64, SolidError> {
    if (0.0..=1.0).contains(&albedo) { Ok(albedo) } else { Err(SolidError::BadAlbedo { face, albedo }) }
}

/// The face turned so that it looks away from `inside`.
fn outward_face(
    vertices: &[DVec3],
    index: usize,
    mut corners: Vec<u32>,
    albedo: f64,
    inside: DVec3,
    size: f64,
) -> Result<Face, SolidError> {
    let albedo = checked_albedo(index, albedo)?;
    let (normal, middle) = plane_of(vertices, index, &corners, size)?;
    let depth = normal.dot(middle - inside);
    // The mean of the vertices of a thin solid of n vertices is at least 1/n of its thickness from every face.
    if depth.abs() <= f64::EPSILON * vertices.len() as f64 * size {
        return Err(SolidError::Flat);
    }
    // Body axes are left-handed: counter-clockwise seen from outside is a cross product that points inwards.
    if depth > 0.0 {
        corners.reverse();
    }
    Ok(Face { corners, normal: normal * depth.signum(), albedo })
}
