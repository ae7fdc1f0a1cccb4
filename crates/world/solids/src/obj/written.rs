//! What a text says, before any of it is a solid.

use std::ops::Range;

use glam::DVec3;

/// The statements of a text.
#[derive(Default)]
pub(super) struct Written {
    pub vertices: Vec<Vertex>,
    /// In body axes, as long as they are written.
    pub normals: Vec<DVec3>,
    pub parts: Vec<Part>,
}

/// A vertex: one `v` line.
pub(super) struct Vertex {
    /// In body axes (m).
    pub place: DVec3,
    /// Linear red, green, blue.
    pub colour: [f64; 3],
    /// Bytes of the text.
    pub span: Range<usize>,
}

/// What stands below an `o` or a `g`.
#[derive(Default)]
pub(super) struct Part {
    pub faces: Vec<Face>,
}

/// A face: one `f` line.
pub(super) struct Face {
    pub corners: Vec<Corner>,
    /// Bytes of the text.
    pub span: Range<usize>,
}

/// A corner of a face, by indices from 0.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub vertex: usize,
    pub normal: Option<usize>,
}
