//! From camera axes to the screen.

use glam::DVec3;

/// A perspective view along the z axis: x to the right, y down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// Focal length (pixels), above 0.
    pub focal: f64,
    /// Where the view axis meets the screen (pixels).
    pub centre: [f64; 2],
}

impl Projection {
    /// Place on the screen (pixels) of a point in camera axes (m) with z above 0.
    pub fn project(&self, point: DVec3) -> [f64; 2] {
        let scale = self.focal / point.z;
        [self.centre[0] + scale * point.x, self.centre[1] + scale * point.y]
    }

    /// The ray through a place on the screen (pixels), with z = 1.
    pub fn ray(&self, [x, y]: [f64; 2]) -> DVec3 {
        DVec3::new((x - self.centre[0]) / self.focal, (y - self.centre[1]) / self.focal, 1.0)
    }
}
