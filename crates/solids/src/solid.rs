//! One convex polyhedron.

use glam::DVec3;

/// One flat side: a convex polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Corners, counter-clockwise seen from outside.
    pub corners: Vec<u32>,
    /// Unit normal, outwards.
    pub normal: DVec3,
    /// Share of the light that is returned, 0..=1.
    pub albedo: f64,
}

/// Why faces do not enclose a convex solid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolidError {
    /// Too little of it.
    #[error("{vertices} vertices and {faces} faces: expected at least 4 of each")]
    TooSmall {
        /// Vertices found.
        vertices: usize,
        /// Faces found.
        faces: usize,
    },
    /// A vertex lies outside a face.
    #[error("vertex {vertex} lies {outside:.6} m outside face {face}: expected a convex solid")]
    NotConvex {
        /// Vertex, counted from 0.
        vertex: usize,
        /// Face, counted from 0.
        face: usize,
        /// Distance from the face's plane (m).
        outside: f64,
    },
    /// A face without an area, or whose corners are not in a plane.
    #[error("face {face}: {what}; expected a plane polygon of at least 3 different corners")]
    BadFace {
        /// Face, counted from 0.
        face: usize,
        /// What is wrong with it.
        what: &'static str,
    },
    /// Faces that do not close.
    #[error("the edge between vertices {0} and {1} belongs to one face only: expected a closed surface")]
    Open(u32, u32),
}

/// A closed convex polyhedron in body axes (m), its foot point at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    vertices: Vec<DVec3>,
    faces: Vec<Face>,
}

impl Solid {
    /// Vertices.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Faces.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }
}
