//! Planes above regions and bounds over blocks of them: what a line stays above needs no root finding.

use landscape::patch::{Patch, UpperPlane};
use landscape::{Landscape, Level};
use rayon::prelude::*;

use crate::craters::Craters;

/// Sides of the blocks that are passed over whole, in regions, the largest first.
pub const BLOCKS: [usize; 2] = [64, 8];

/// Bounds above all ground of a landscape, and the craters by place.
#[derive(Debug, Clone, PartialEq)]
pub struct Ceilings {
    levels: Vec<LevelCeilings>,
    craters: Craters,
    highest: f64,
}

/// Bounds above one level with its craters.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelCeilings {
    regions: Vec<Ceiling>,
    columns: usize,
    /// Highest ground of each block of [`BLOCKS`] (m).
    blocks: [Vec<f64>; 2],
}

/// A bound above one region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ceiling {
    /// A plane above the terrain.
    pub plane: UpperPlane,
    /// The most that craters add to it (m); `None` where there are none.
    pub rise: Option<f64>,
}

impl Ceiling {
    fn highest(&self) -> f64 {
        self.plane.highest() + self.rise.unwrap_or(0.0)
    }
}

impl Ceilings {
    /// Bounds over every region of every level; uses the threads of the current rayon pool.
    pub fn new(landscape: &Landscape) -> Self {
        let craters = Craters::new(landscape.features());
        let levels = landscape.bank().levels().iter().map(|level| LevelCeilings::new(level, &craters));
        let levels: Vec<_> = levels.collect();
        let all = levels.iter().flat_map(|level| &level.regions);
        let highest = all.map(Ceiling::highest).fold(f64::NEG_INFINITY, f64::max);
        Self { levels, craters, highest }
    }

    /// Bounds over level `index`.
    pub fn level(&self, index: usize) -> &LevelCeilings {
        &self.levels[index]
    }

    /// Returns the lists and bounds of the craters, cell by cell.
    pub fn craters(&self) -> &Craters {
        &self.craters
    }

    /// Nothing is higher (m).
    pub fn highest(&self) -> f64 {
        self.highest
    }
}

impl LevelCeilings {
    fn new(level: &Level, craters: &Craters) -> Self {
        let [rows, columns] = level.corners().map(|corners| corners - 1);
        let ceiling = |index: usize| {
            let region = [index / columns, index % columns];
            let plane = Patch::new(level, region).upper_plane();
            Ceiling { plane, rise: craters.highest_in(&area(level, region)) }
        };
        let regions: Vec<Ceiling> = (0..rows * columns).into_par_iter().map(ceiling).collect();
        let blocks = BLOCKS.map(|size| highest_of_blocks(&regions, columns, size));
        Self { regions, columns, blocks }
    }

    /// The bound above a region.
    pub fn over(&self, [north, east]: [usize; 2]) -> &Ceiling {
        &self.regions[north * self.columns + east]
    }

    /// Highest ground in the block of `BLOCKS[tier]` that holds a region (m).
    pub fn block(&self, tier: usize, [north, east]: [usize; 2]) -> f64 {
        let size = BLOCKS[tier];
        self.blocks[tier][north / size * self.columns.div_ceil(size) + east / size]
    }
}

/// The ground of a region: low and high corner (m).
fn area(level: &Level, region: [usize; 2]) -> [[f64; 2]; 2] {
    let corner = |far: usize| {
        std::array::from_fn(|axis| level.origin()[axis] + level.region_size() * (region[axis] + far) as f64)
    };
    [corner(0), corner(1)]
}

fn highest_of_blocks(regions: &[Ceiling], columns: usize, size: usize) -> Vec<f64> {
    let across = columns.div_ceil(size);
    let mut blocks = vec![f64::NEG_INFINITY; (regions.len() / columns).div_ceil(size) * across];
    for (index, region) in regions.iter().enumerate() {
        let block = &mut blocks[index / columns / size * across + index % columns / size];
        *block = block.max(region.highest());
    }
    blocks
}
