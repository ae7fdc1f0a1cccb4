//! Lambert's factor of slopes, and its product with the albedo.

use quantities::{radians, sin_cos};

use crate::scene::machine::MachineScene;

/// Albedo times Lambert's factor of ground with these slopes to the north and east (section 7):
/// `albedo (sin e - cos e (hx cos a + hy sin a)) / sqrt(1 + hx^2 + hy^2)`, 0 where the sun is behind it.
pub fn lambert(scene: &MachineScene, [hx, hy]: [f64; 2]) -> f64 {
    let ((sin_e, cos_e), (sin_a, cos_a)) =
        (sin_cos(radians(scene.sun_elevation_deg)), sin_cos(radians(scene.sun_azimuth_deg)));
    let cosine = (sin_e - cos_e * (hx * cos_a + hy * sin_a)) / (1.0 + hx * hx + hy * hy).sqrt();
    scene.albedo * cosine.max(0.0)
}
