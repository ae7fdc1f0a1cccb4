//! Light of the faces.

use glam::DVec3;
use signal::Number;

/// Light of a frame on the faces of bodies: diffuse, as the report computes it before the mission.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceLight {
    /// Unit vector to the sun: north, east, up.
    pub sun: DVec3,
}

impl FaceLight {
    /// Reflectivity of a face, 0..=1, by its unit normal (north, east, up): `max(n.s, 0)` times its albedo.
    #[inline(always)]
    pub fn reflectivity<N: Number>(&self, [north, east, up]: [N; 3], albedo: N) -> N {
        let (x, y, z) = (albedo.like(self.sun.x), albedo.like(self.sun.y), albedo.like(self.sun.z));
        (north * x + east * y + up * z).at_least(albedo.like(0.0)) * albedo
    }
}
