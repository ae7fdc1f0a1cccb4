//! One picture of the camera.

use glam::DVec3;
use landscape::Attitude;
use scenario::FieldOfView;

/// Where a picture was taken from, and how the vehicle stood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// Seconds since the start of the mission.
    pub time: f64,
    /// Eye: north, east, height above the lunoid's tangent plane (m).
    pub eye: [f64; 3],
    /// Height of the eye above the ground that is taken as flat (m).
    pub height: f64,
    /// How the vehicle stands.
    pub vehicle: Attitude,
    /// How the picture is turned: the same heading and pitch, and its own roll.
    pub camera: Attitude,
    /// What the camera sees.
    pub field: FieldOfView,
}

impl Shot {
    /// Distance D of the view-plane (m), in front of which lines are clipped: half as far as the nearest point of flat
    /// ground that any direction of the field could meet (our choice; the report wants it shorter than that).
    pub fn view_distance(&self) -> f64 {
        let FieldOfView { tan_half_width: x, tan_half_height: y } = self.field;
        0.5 * self.height / (1.0 + x * x + y * y).sqrt()
    }

    /// Direction through (x, y) of the view-plane at distance 1: north, east, up; 1 along the camera's axis.
    pub fn ray(&self, x: f64, y: f64) -> DVec3 {
        let direction = self.camera.to_terrain() * DVec3::new(1.0, x, y);
        DVec3::new(direction.x, direction.y, -direction.z)
    }
}

/// Places of the edges between `columns` columns (0 to `columns`) or of lines on the view-plane at distance 1.
pub(crate) fn edge(half: f64, index: usize, count: usize) -> f64 {
    half * (2.0 * index as f64 - count as f64) / count as f64
}

/// Place of the middle of line `line` of `lines`.
pub(crate) fn middle(half: f64, line: usize, lines: usize) -> f64 {
    half * (2.0 * line as f64 + 1.0 - lines as f64) / lines as f64
}
