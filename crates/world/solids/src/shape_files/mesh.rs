//! What a file of any format says of a shape, before any of it is a solid.

use std::ops::Range;

use glam::DVec3;

/// Vertices and faces in common axes and units, whatever the format.
#[derive(Default)]
pub(super) struct Mesh {
    pub vertices: Vec<Vertex>,
    /// In body axes, as long as they are written.
    pub normals: Vec<DVec3>,
    pub parts: Vec<Part>,
    /// What the user should know of how the file was read.
    pub notes: Vec<String>,
}

/// Where a vertex or face stands: bytes of a text; in other files its number, from 1, as the start.
pub(super) type At = Range<usize>;

/// A corner of faces.
pub(super) struct Vertex {
    /// In body axes (m).
    pub place: DVec3,
    /// Linear red, green, blue.
    pub colour: [f64; 3],
    pub at: At,
}

/// Faces that belong together by the file's own word.
#[derive(Default)]
pub(super) struct Part {
    pub name: String,
    pub faces: Vec<Face>,
}

/// A polygon, counter-clockwise seen from outside.
pub(super) struct Face {
    pub corners: Vec<Corner>,
    /// Linear red, green, blue of the whole face; without it the mean of its corners.
    pub colour: Option<[f64; 3]>,
    pub at: At,
}

/// A corner of a face, by indices from 0.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub vertex: usize,
    pub normal: Option<usize>,
}

/// No colour of its own: the albedo alone.
pub(super) const WHITE: [f64; 3] = [1.0; 3];

/// A direction or place with x forward, y to port and z up, in body axes: forward, starboard, up.
pub(super) fn from_port([forward, port, up]: [f64; 3]) -> DVec3 {
    DVec3::new(forward, -port, up)
}

/// Linear light of a code of 0 to 1 by the curve of sRGB (IEC 61966-2-1).
pub(super) fn linear(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { libm::pow((code + 0.055) / 1.055, 2.4) }
}

impl Mesh {
    /// Linear red, green and blue of a face.
    pub fn colour(&self, face: &Face) -> [f64; 3] {
        let mean = || {
            let sum = |channel: usize| -> f64 {
                face.corners.iter().map(|corner| self.vertices[corner.vertex].colour[channel]).sum()
            };
            std::array::from_fn(|channel| (sum(channel) / face.corners.len() as f64).min(1.0))
        };
        face.colour.unwrap_or_else(mean)
    }

    /// The part that faces are read into; one is made where there is none.
    pub fn last_part(&mut self) -> &mut Part {
        if self.parts.is_empty() {
            self.parts.push(Part::default());
        }
        let last = self.parts.len() - 1;
        &mut self.parts[last]
    }
}
