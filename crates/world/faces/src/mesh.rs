//! A list of faces that are checked, with the normal of each.

use glam::DVec3;

use crate::check::{Outline, check_corners, checked_vertex};
use crate::error::FaceError;
use crate::face::{Face, Vertex};
use crate::warning::Warning;

/// Faces of one list: their vertices, and the unit normal of each face.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    vertices: Vec<Vertex>,
    faces: Vec<Face>,
    normals: Vec<DVec3>,
    planes: Vec<bool>,
}

/// A list of faces, and what was left out when it was loaded.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// Faces that can be drawn.
    pub mesh: Mesh,
    /// For each face that was given its number in the mesh; `None` where it was left out.
    pub kept: Vec<Option<usize>>,
    /// One for each face that was left out.
    pub warnings: Vec<Warning>,
}

impl Mesh {
    /// Largest number of faces in one list, unless another is given (chosen).
    pub const MOST_FACES: usize = 200_000;
    /// Deviation from the plane that a flat face may have, as a share of its size (chosen).
    pub const PLANE: f64 = 1e-6;

    /// The list `list` of at most [`Self::MOST_FACES`] faces.
    ///
    /// Faces without an area, or with two corners at one place, are left out with a warning. A smooth face may be uneven: it is cut
    /// in triangles in any case.
    ///
    /// # Errors
    /// If a number is not finite or out of range, a corner is missing, a flat face is not plane, or a face is not convex.
    pub fn load(list: &str, vertices: Vec<Vertex>, faces: Vec<Face>) -> Result<Loaded, FaceError> {
        Self::limited(list, vertices, faces, Self::MOST_FACES)
    }

    /// The same with at most `most` faces.
    ///
    /// # Errors
    /// As [`Mesh::load`].
    pub fn limited(
        list: &str,
        vertices: Vec<Vertex>,
        faces: Vec<Face>,
        most: usize,
    ) -> Result<Loaded, FaceError> {
        if faces.len() > most {
            return Err(FaceError::TooMany { list: list.into(), found: faces.len(), most });
        }
        let numbered = vertices.into_iter().enumerate();
        let vertices: Vec<Vertex> = numbered
            .map(|(number, vertex)| checked_vertex(list, number, vertex))
            .collect::<Result<_, _>>()?;
        let mut mesh = Self { vertices, faces: Vec::new(), normals: Vec::new(), planes: Vec::new() };
        let (mut kept, mut warnings) = (Vec::with_capacity(faces.len()), Vec::new());
        for (number, face) in faces.into_iter().enumerate() {
            check_corners(list, number, &face, mesh.vertices.len())?;
            match mesh.add(list, number, face)? {
                None => kept.push(Some(mesh.faces.len() - 1)),
                Some(warning) => {
                    kept.push(None);
                    warnings.push(warning);
                }
            }
        }
        Ok(Loaded { mesh, kept, warnings })
    }

    /// Adds face `number` of the list, or says why it has nothing to show.
    fn add(&mut self, list: &str, number: usize, face: Face) -> Result<Option<Warning>, FaceError> {
        let places = self.places(&face);
        let outline = Outline { list, face: number, corners: &face.corners, places: &places };
        if let Some(why) = outline.degenerate() {
            return Ok(Some(Warning::Dropped { list: list.into(), face: number, why }));
        }
        let (normal, is_plane) = outline.checked(face.shading)?;
        self.faces.push(face);
        self.normals.push(normal);
        self.planes.push(is_plane);
        Ok(None)
    }

    /// Vertices of the list.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Faces of the list, in their order: inside a list the earlier face wins.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Unit normal of each face, towards its front.
    pub fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// Whether face `face` is plane within [`Self::PLANE`] of its size.
    pub fn is_plane(&self, face: usize) -> bool {
        self.planes[face]
    }

    /// Places of the corners of a face of the list (m).
    pub fn places(&self, face: &Face) -> Vec<DVec3> {
        face.corners.iter().map(|&corner| self.vertices[corner as usize].place).collect()
    }
}
