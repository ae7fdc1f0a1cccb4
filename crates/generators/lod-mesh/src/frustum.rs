//! Which tiles can be in view.

use std::ops::RangeInclusive;

use glam::DVec3;
use scene_sampler::{Camera, NEAR};

/// What a picture can show, in camera axes: before the near plane, and between the four planes of its borders.
pub struct Frustum<'a> {
    camera: &'a Camera,
    /// Tangents of the borders, to the right and down.
    tangents: [f64; 2],
}

impl<'a> Frustum<'a> {
    /// The frustum of a camera.
    pub fn new(camera: &'a Camera) -> Self {
        Self { camera, tangents: camera.projection.centre.map(|centre| centre / camera.projection.focal) }
    }

    /// Whether a box of ground may be in view: south-western and north-eastern corner on the map (north, east; m), and its heights (m).
    pub fn may_show(&self, [low, high]: [[f64; 2]; 2], heights: &RangeInclusive<f64>) -> bool {
        let on_map = [[low[0], low[1]], [low[0], high[1]], [high[0], low[1]], [high[0], high[1]]];
        let drop =
            on_map.map(|[x, y]| self.camera.drop_at(DVec3::new(x, y, 0.0))).into_iter().fold(0.0, f64::max);
        // Inside the box the ground drops less than at its farthest corner.
        let both = [*heights.start() - drop, *heights.end()];
        let corner = |[x, y]: [f64; 2], z: f64| self.camera.direction(DVec3::new(x, y, z) - self.camera.eye);
        let corners: [DVec3; 8] = std::array::from_fn(|k| corner(on_map[k / 2], both[k % 2]));
        let [right, down] = self.tangents;
        let is_beyond = |plane: &dyn Fn(&DVec3) -> bool| corners.iter().all(plane);
        !(is_beyond(&|at| at.z < NEAR)
            || is_beyond(&|at| at.x > right * at.z)
            || is_beyond(&|at| at.x < -right * at.z)
            || is_beyond(&|at| at.y > down * at.z)
            || is_beyond(&|at| at.y < -down * at.z))
    }
}
