//! Turns about axes.

use glam::{DMat3, DVec3};
use quantities::sin_cos;

/// Turns a vector by `angle` (rad) from the first axis towards the second.
pub(crate) fn about_z(angle: f64) -> DMat3 {
    let (sin, cos) = sin_cos(angle);
    DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z)
}

/// Turns a vector by `angle` (rad) from the second axis towards the third.
pub(crate) fn about_x(angle: f64) -> DMat3 {
    let (sin, cos) = sin_cos(angle);
    DMat3::from_cols(DVec3::X, DVec3::new(0.0, cos, sin), DVec3::new(0.0, -sin, cos))
}
