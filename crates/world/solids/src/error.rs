//! Why faces do not enclose a convex solid.

/// Why faces do not enclose a convex solid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolidError {
    /// Too little of it.
    #[error("{vertices} vertices and {faces} faces: expected at least 4 of each")]
    TooSmall {
        /// Number of vertices that were given.
        vertices: usize,
        /// Number of faces that were given.
        faces: usize,
    },
    /// Too much of it.
    #[error("{found} {what}: expected at most {most}; make several parts of it")]
    TooLarge {
        /// Vertices, faces or points.
        what: &'static str,
        /// Number of them that were given.
        found: usize,
        /// How many there may be.
        most: usize,
    },
    /// A vertex that is no place.
    #[error("vertex {vertex}: expected three lengths of at most 1e5 m either way")]
    BadVertex {
        /// Vertex, counted from 0.
        vertex: usize,
    },
    /// A vertex without a face.
    #[error("vertex {vertex} belongs to no face: expected vertices of the surface only")]
    Unused {
        /// Vertex, counted from 0.
        vertex: usize,
    },
    /// A face that names a vertex that is not there.
    #[error("face {face} names vertex {vertex}: expected 0 to {last}")]
    NoVertex {
        /// Face, counted from 0.
        face: usize,
        /// Index of the vertex that the face names.
        vertex: u32,
        /// Index of the last vertex that there is.
        last: usize,
    },
    /// An albedo that is none.
    #[error("face {face}: albedo {albedo}: expected 0 to 1")]
    BadAlbedo {
        /// Face, counted from 0.
        face: usize,
        /// Albedo that was given for the face.
        albedo: f64,
    },
    /// A face without an area, or whose corners are not in a plane.
    #[error("face {face}: {what}; expected a plane polygon of at least 3 different corners")]
    BadFace {
        /// Face, counted from 0.
        face: usize,
        /// What is wrong with it.
        what: &'static str,
    },
    /// The vertices lie in one plane and enclose no volume.
    #[error("all vertices lie in one plane: expected a solid with a volume")]
    Flat,
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
    /// Faces that do not close.
    #[error(
        "the edge between vertices {0} and {1} does not part exactly two faces: expected a closed surface"
    )]
    Open(u32, u32),
}
