//! The distance of what a ray meets.

use quantities::sin_cos;
use scenario::Pose;

/// Distance (m) to level ground at `height` (m) along the ray through a place of the view-plane, in tangents: right and down. Infinite
/// where the ray goes up. With pitch p the ray `(1, right, down)` of the camera falls by `down cos p - sin p`.
pub fn to_level_ground(pose: &Pose, height: f64, [right, down]: [f64; 2]) -> f64 {
    let (sin, cos) = sin_cos(pose.attitude.pitch);
    let fall = down * cos - sin;
    if fall > 0.0 {
        (pose.eye[2] - height) * (1.0 + right * right + down * down).sqrt() / fall
    } else {
        f64::INFINITY
    }
}
