//! Where the eye is and how it looks.

use landscape::Attitude;

/// The vehicle at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Seconds since the start of the mission.
    pub time: f64,
    /// Eye: north, east (m) and height above the lunoid's tangent plane (m).
    pub eye: [f64; 3],
    /// Roll, pitch, heading (rad).
    pub attitude: Attitude,
    /// Angle by which the deflection yoke turns the picture (rad), positive for starboard down; 0 without one.
    pub yoke: f64,
}
