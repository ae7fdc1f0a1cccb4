//! Where the observer is and which way he looks: from the map to his axes, from the ground to his picture.

use quantities::sin_cos;
use scenario::{FieldOfView, Pose};

/// Nearer to the view-plane than this (m) nothing is projected.
const NEAREST: f64 = 1e-6;

/// The observer of one frame. His axes lie on the map: along the line of sight, and across it to the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Observer {
    /// Eye: north, east, up (m).
    pub eye: [f64; 3],
    /// Half the field of view, as tangents: width, height.
    pub half_field: [f64; 2],
    heading: (f64, f64),
    pitch: (f64, f64),
}

impl Observer {
    /// The observer of `pose`; the program has no roll.
    pub fn new(pose: &Pose, field: FieldOfView) -> Self {
        Self {
            eye: pose.eye,
            half_field: [field.tan_half_width, field.tan_half_height],
            heading: sin_cos(pose.attitude.heading),
            pitch: sin_cos(pose.attitude.pitch),
        }
    }

    /// Unit vector of the line of sight on the map: north, east.
    pub fn direction(&self) -> [f64; 2] {
        let (sin, cos) = self.heading;
        [cos, sin]
    }

    /// Place on the map (north, east; m) of a place in his axes (m).
    pub fn on_map(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let [north, east] = self.turned([along, across]);
        [self.eye[0] + north, self.eye[1] + east]
    }

    /// A vector of his axes as north, east.
    pub fn turned(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.heading;
        [along * cos - across * sin, along * sin + across * cos]
    }

    /// A vector of the map (north, east) in his axes.
    pub fn in_axes(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.heading;
        [north * cos + east * sin, east * cos - north * sin]
    }

    /// Place on the view-plane at distance 1 (right, down) of a place in his axes that stands `rise` (m) above the eye;
    /// `None` if it lies behind.
    pub fn project(&self, [along, across]: [f64; 2], rise: f64) -> Option<[f64; 2]> {
        let (sin, cos) = self.pitch;
        let ahead = along * cos + rise * sin;
        (ahead > NEAREST).then(|| [across / ahead, (along * sin - rise * cos) / ahead])
    }

    /// Along and down, for one ahead on the view-plane, of a ray through `y` (down) of the view-plane.
    pub fn ray(&self, y: f64) -> [f64; 2] {
        let (sin, cos) = self.pitch;
        [cos + y * sin, y * cos - sin]
    }
}
