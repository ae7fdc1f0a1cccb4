//! A projection that shares no code with the generator.

use glam::DVec3;
use quantities::sin_cos;
use scenario::{Pose, View};

/// An eye with its axes, by trigonometry from the angles of the pose.
pub struct Eye {
    place: DVec3,
    right: DVec3,
    down: DVec3,
    ahead: DVec3,
    /// Focal lengths across and along the screen (pixels).
    focal: [f64; 2],
    centre: [f64; 2],
}

impl Eye {
    /// The eye of a pose; the yoke turns the picture.
    pub fn new(pose: &Pose, view: &View) -> Self {
        let (sin_h, cos_h) = sin_cos(pose.attitude.heading);
        let (sin_p, cos_p) = sin_cos(pose.attitude.pitch);
        let (sin_r, cos_r) = sin_cos(pose.yoke);
        let level = DVec3::new(-sin_h, cos_h, 0.0);
        let up = DVec3::new(-sin_p * cos_h, -sin_p * sin_h, cos_p);
        let [columns, lines] = [view.columns, view.lines].map(f64::from);
        Self {
            place: DVec3::from_array(pose.eye),
            right: level * cos_r - up * sin_r,
            down: -up * cos_r - level * sin_r,
            ahead: DVec3::new(cos_p * cos_h, cos_p * sin_h, sin_p),
            focal: [columns / (2.0 * view.field.tan_half_width), lines / (2.0 * view.field.tan_half_height)],
            centre: [columns / 2.0, lines / 2.0],
        }
    }

    /// A place of the scene in axes right, down, ahead (m).
    pub fn seen(&self, place: DVec3) -> DVec3 {
        let from_eye = place - self.place;
        DVec3::new(from_eye.dot(self.right), from_eye.dot(self.down), from_eye.dot(self.ahead))
    }

    /// Where a place is on the screen (pixels).
    pub fn project(&self, place: DVec3) -> [f64; 2] {
        let seen = self.seen(place);
        [self.centre[0] + self.focal[0] * seen.x / seen.z, self.centre[1] + self.focal[1] * seen.y / seen.z]
    }

    /// The ray of a place on the screen in axes right, down, ahead; 1 long ahead.
    pub fn ray(&self, [x, y]: [f64; 2]) -> DVec3 {
        DVec3::new((x - self.centre[0]) / self.focal[0], (y - self.centre[1]) / self.focal[1], 1.0)
    }

    /// The same ray in axes north, east, up.
    pub fn direction(&self, at: [f64; 2]) -> DVec3 {
        let ray = self.ray(at);
        self.right * ray.x + self.down * ray.y + self.ahead
    }

    /// The place of the scene at a depth (m) behind a place on the screen.
    pub fn place(&self, at: [f64; 2], depth: f64) -> DVec3 {
        self.place + self.direction(at) * depth
    }
}
