//! Craters that a scenario strews or lists.

use std::path::PathBuf;
use std::sync::Arc;

use features::Craters;
use features::population::{Kind, Population, SizeLaw};

/// All craters that a scenario asks for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CraterWishes {
    /// Those of a file.
    pub list: Option<CraterList>,
    /// Those that a law strews, after those of the file.
    pub populations: Vec<CraterPopulation>,
}

/// Craters of a file, in its order.
#[derive(Debug, Clone, PartialEq)]
pub struct CraterList {
    /// Path of the file that lists the craters.
    pub file: PathBuf,
    /// Craters that the file lists, in its order.
    pub craters: Arc<Craters>,
}

/// Craters of one kind, strewn by a law.
#[derive(Debug, Clone, PartialEq)]
pub struct CraterPopulation {
    /// Seed of all draws.
    pub seed: u64,
    /// South, west, north, east edge (m); the whole problem area if open.
    pub area: Option<[f64; 4]>,
    /// How many of which size.
    pub sizes: SizeLaw,
    /// What they are like.
    pub kind: Kind,
}

impl CraterPopulation {
    /// The population on a problem area of this extent (south, west, north, east edge; m).
    pub fn over(&self, extent: [f64; 4]) -> Population {
        let Self { seed, area, sizes, kind } = self.clone();
        Population { seed, area: area.unwrap_or(extent), sizes, kind }
    }
}
