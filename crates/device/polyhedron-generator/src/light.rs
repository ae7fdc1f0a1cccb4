//! Light of the faces.

use glam::DVec3;
use scenario::BodyShading;
use signal::Number;

/// Words that smooth light takes more at each crossing of a face and a sweep: both ends of a ramp in place of one value would be one more;
/// the specification of the option counts two (inferred).
pub const RAMP_WORDS: u64 = 2;

/// Light of a frame on the faces of bodies: diffuse, as the report computes it before the mission.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceLight {
    /// Unit vector to the sun: north, east, up.
    pub sun: DVec3,
    /// Whether a face has one reflectivity, or a ramp between those of its corners.
    pub shading: BodyShading,
}

impl FaceLight {
    /// Reflectivity of a face, 0..=1, by its unit normal (north, east, up): `max(n.s, 0)` times its albedo.
    #[inline(always)]
    pub fn reflectivity<N: Number>(&self, [north, east, up]: [N; 3], albedo: N) -> N {
        let (x, y, z) = (albedo.like(self.sun.x), albedo.like(self.sun.y), albedo.like(self.sun.z));
        (north * x + east * y + up * z).at_least(albedo.like(0.0)) * albedo
    }
}
