//! One level of a landscape: a plane above each of its regions, and the craters that reach into it.

use features::Features;
use landscape::Level;
use landscape::patch::{Patch, UpperPlane};
use rayon::prelude::*;

/// Bounds over the regions of a level.
#[derive(Debug, Clone)]
pub struct Tier {
    columns: usize,
    regions: Vec<Region>,
}

/// What is known of a region before a line passes it.
#[derive(Debug, Clone)]
pub struct Region {
    /// A plane above the terrain.
    plane: UpperPlane,
    /// The most that craters add (m).
    crests: f64,
    /// Craters that reach into the region, ascending.
    pub craters: Box<[u32]>,
}

impl Tier {
    /// Bounds over a level with craters, by the threads of the caller's pool.
    pub fn new(level: &Level, features: &Features) -> Self {
        let [rows, columns] = level.corners().map(|corners| corners - 1);
        let region = |at: usize| Region::new(level, [at / columns, at % columns], features);
        Self { columns, regions: (0..rows * columns).into_par_iter().map(region).collect() }
    }

    /// The bounds of a region.
    pub fn region(&self, [north, east]: [usize; 2]) -> &Region {
        &self.regions[north * self.columns + east]
    }
}

impl Region {
    fn new(level: &Level, region: [usize; 2], features: &Features) -> Self {
        let corner = |far: usize| {
            [0, 1].map(|axis| level.origin()[axis] + level.region_size() * (region[axis] + far) as f64)
        };
        let mut craters = Vec::new();
        features.in_box(corner(0), corner(1), &mut craters);
        let crests = craters.iter().map(|&index| features.crater(index).highest()).sum();
        Self { plane: Patch::new(level, region).upper_plane(), crests, craters: craters.into() }
    }

    /// A height (m) that the ground between two local places does not exceed.
    pub fn highest(&self, [from, to]: [[f64; 2]; 2]) -> f64 {
        self.plane.height(from).max(self.plane.height(to)) + self.crests
    }
}
