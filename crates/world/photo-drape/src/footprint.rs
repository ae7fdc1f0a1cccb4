//! What a pixel of a new picture covers of the ground.

use glam::DVec3;

/// Least cosine between a ray and the normal of the ground. Chosen: a footprint is no longer than fifty times its width.
const LEAST_COSINE: f64 = 0.02;

/// Half axes of an ellipse on the ground (m): north, east, up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// Across the line of sight.
    pub across: DVec3,
    /// Along the line of sight.
    pub along: DVec3,
}

impl Footprint {
    /// The footprint of a pixel at a place whose unit normal is `normal`, seen from `eye`; `half` is half the pixel's angle (rad), above 0.
    pub fn seen(place: DVec3, normal: DVec3, eye: DVec3, half: f64) -> Self {
        let way = place - eye;
        let (ray, half_width) = (way.normalize_or(-normal), half * way.length());
        let across = normal.cross(ray).try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
        let along = across.cross(normal);
        let cosine = ray.dot(normal).abs().max(LEAST_COSINE);
        Self { across: across * half_width, along: along * (half_width / cosine) }
    }

    /// A square of the map of a side (m) on ground with a unit normal.
    pub fn square(normal: DVec3, side: f64) -> Self {
        let on_ground = |way: DVec3| way - DVec3::Z * (way.dot(normal) / normal.z);
        Self { across: on_ground(DVec3::Y * (side / 2.0)), along: on_ground(DVec3::X * (side / 2.0)) }
    }

    /// Area of the parallelogram of its half axes (m^2).
    pub(crate) fn area(&self) -> f64 {
        self.across.cross(self.along).length()
    }
}
