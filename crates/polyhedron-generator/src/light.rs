//! Light of the faces.

use glam::DVec3;
use solids::Body;

/// Light of a frame on the faces of bodies: diffuse, as the report computes it before the mission.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceLight {
    /// Unit vector to the sun: north, east, up.
    pub sun: DVec3,
}

impl FaceLight {
    /// Reflectivity of a face, 0..=1: `max(n.s, 0)` times its albedo; 0 on a body in remote shadow.
    pub fn reflectivity(&self, body: &Body, face: usize, dark: bool) -> f64 {
        if dark {
            return 0.0;
        }
        body.normal(face).dot(self.sun).max(0.0) * body.solid.faces()[face].albedo
    }
}
