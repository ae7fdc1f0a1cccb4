//! Faces of a model that is made piece by piece, turned outwards.

use glam::DVec3;

use crate::error::FaceError;
use crate::face::{Face, Shading, Vertex};
use crate::mesh::Mesh;

/// Vertices and faces so far.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    pub vertices: Vec<Vertex>,
    pub faces: Vec<Face>,
}

impl Pieces {
    /// Adds a vertex, and says its number.
    pub fn vertex(&mut self, place: DVec3) -> u32 {
        self.vertices.push(Vertex::at(place));
        self.vertices.len() as u32 - 1
    }

    /// Adds a face of vertices that are there, turned so that its front looks along `outwards`.
    pub fn join(&mut self, mut corners: Vec<u32>, outwards: DVec3, (colour, shading): ([f64; 3], Shading)) {
        let place = |k: usize| self.vertices[corners[k] as usize].place;
        // Left-handed axes: the cross product of components of counter-clockwise corners points backwards.
        let back = (place(1) - place(0)).cross(place(corners.len() - 1) - place(0));
        if back.dot(outwards) > 0.0 {
            corners.reverse();
        }
        self.faces.push(Face { shading, ..Face::smooth(corners, colour) });
    }

    /// Adds a flat face with vertices of its own.
    pub fn flat(&mut self, places: &[DVec3], outwards: DVec3, colour: [f64; 3]) {
        let corners = places.iter().map(|&place| self.vertex(place)).collect();
        self.join(corners, outwards, (colour, Shading::Flat));
    }

    /// The list `list` of all faces; none has to be left out.
    pub fn mesh(self, list: &str) -> Result<Mesh, FaceError> {
        Ok(Mesh::load(list, self.vertices, self.faces)?.mesh)
    }
}
