//! How often a closed surface runs around a place.

use std::f64::consts::PI;

use glam::DVec3;

/// Sum of the solid angles of all triangles, seen from `place`, over the full sphere: 1 inside a closed surface whose triangles
/// run counter-clockwise seen from outside, 0 outside, and any other whole number where the surface crosses itself.
///
/// The angle of one triangle is van Oosterom's and Strackee's (1983).
pub(super) fn winding(triangles: &[[DVec3; 3]], place: DVec3) -> f64 {
    let angle = |corners: &[DVec3; 3]| {
        let [a, b, c] = corners.map(|corner| corner - place);
        let [x, y, z] = [a, b, c].map(DVec3::length);
        let above = a.dot(b.cross(c));
        let below = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
        2.0 * libm::atan2(above, below)
    };
    triangles.iter().map(angle).sum::<f64>() / (4.0 * PI)
}
