//! Shadows that posts cast on one another.

use glam::DVec3;
use terrain_builder::{Axis, Grid, Heights, LightMap, Method};

use crate::Ground;

impl Ground {
    /// Whether each post is in a shadow that other posts cast, row by row from the south. `sun` is the unit vector to the sun (north, east, up).
    pub fn shadowed(&self, sun: DVec3) -> Vec<bool> {
        LightMap::new(&heights(self), sun, Method::Sweep).shadowed().to_vec()
    }
}

/// The posts as terrain-builder's shadows take them.
fn heights(ground: &Ground) -> Heights {
    let axis = |axis: usize| Axis {
        first: ground.corner()[axis],
        resolution: ground.spacing(),
        cells: ground.size()[axis] - 1,
        exponent: 0,
    };
    Heights::new(Grid { north: axis(0), east: axis(1) }, ground.heights().to_vec())
}
