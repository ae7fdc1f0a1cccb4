//! Which ground can be in view, on the map.

use glam::DVec3;
use scenario::View;

use crate::camera::Camera;

/// The ground that a picture can show, on the map: all of it, or a wedge from the eye.
#[derive(Debug, Clone, Copy)]
pub struct Wedge {
    eye: [f64; 2],
    /// Directions of its left and right border (north, east), where it has borders.
    borders: Option<[[f64; 2]; 2]>,
    farthest: f64,
}

impl Wedge {
    /// The wedge of a picture. A picture that shows nadir or zenith has no borders.
    pub fn new(camera: &Camera, view: &View) -> Self {
        let (columns, lines) = (f64::from(view.columns), f64::from(view.lines));
        let corners = [[0.0, 0.0], [columns, 0.0], [0.0, lines], [columns, lines]].map(|at| camera.ray(at));
        let ahead = camera.ray([columns / 2.0, lines / 2.0]);
        Self {
            eye: [camera.eye.x, camera.eye.y],
            borders: borders(ahead, &corners),
            farthest: view.ranges[1],
        }
    }

    /// Whether a box of the map (south-western and north-eastern corner; north, east; m) may be in view.
    pub fn may_show(&self, [low, high]: [[f64; 2]; 2]) -> bool {
        let nearest =
            [0, 1].map(|axis| (low[axis] - self.eye[axis]).max(self.eye[axis] - high[axis]).max(0.0));
        if nearest[0] * nearest[0] + nearest[1] * nearest[1] > self.farthest * self.farthest {
            return false;
        }
        let Some([left, right]) = self.borders else { return true };
        let corners = [[low[0], low[1]], [low[0], high[1]], [high[0], low[1]], [high[0], high[1]]];
        let from_eye = corners.map(|corner| [corner[0] - self.eye[0], corner[1] - self.eye[1]]);
        from_eye.iter().any(|at| cross(left, *at) >= 0.0)
            && from_eye.iter().any(|at| cross(*at, right) >= 0.0)
    }
}

/// Above 0 where `b` lies clockwise of `a`, seen from above (north, east).
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The two corners between which all others lie, clockwise; none if no half-plane through the vertical holds them all.
fn borders(ahead: DVec3, corners: &[DVec3; 4]) -> Option<[[f64; 2]; 2]> {
    let middle = [ahead.x, ahead.y];
    let flat = corners.map(|corner| [corner.x, corner.y]);
    let is_ahead = |at: &[f64; 2]| middle[0] * at[0] + middle[1] * at[1] > 0.0;
    if !flat.iter().all(is_ahead) {
        return None;
    }
    let left = flat.into_iter().reduce(|a, b| if cross(a, b) < 0.0 { b } else { a })?;
    let right = flat.into_iter().reduce(|a, b| if cross(a, b) > 0.0 { b } else { a })?;
    Some([left, right])
}
