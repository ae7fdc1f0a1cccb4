//! Poses as plain numbers.

use drive::EyePose;

/// Time (s), eye north, east, up (m), heading, pitch, roll, yoke (degrees).
pub type Numbers = (f64, f64, f64, f64, f64, f64, f64, f64);

/// The numbers of a pose.
pub fn numbers(pose: &EyePose) -> Numbers {
    let EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg } = *pose;
    (time_s, x, y, z, heading_deg, pitch_deg, roll_deg, yoke_deg)
}

/// The pose of some numbers.
pub fn pose((time_s, x, y, z, heading_deg, pitch_deg, roll_deg, yoke_deg): Numbers) -> EyePose {
    EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg }
}
