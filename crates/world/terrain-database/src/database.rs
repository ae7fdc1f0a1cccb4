//! A terrain whose contents are checked.

use rayon::prelude::*;

use crate::check::{check, tiling};
use crate::contents::Contents;
use crate::error::Unfit;
use crate::heights::Coding;
use crate::levels;
use crate::tiling::Tiling;

/// What a tile is like.
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    /// Largest difference of each level to level 0 (m), from level 0, whose own is 0, to level n.
    pub errors: Vec<f64>,
    /// Lowest and highest post (m).
    pub bounds: [f64; 2],
}

/// A terrain of whole tiles, with what its levels lose.
#[derive(Debug, Clone, PartialEq)]
pub struct Database {
    pub(crate) contents: Contents,
    pub(crate) tiling: Tiling,
    pub(crate) tiles: Vec<Tile>,
}

impl Database {
    /// A database of contents. With a step, heights are rounded to whole steps.
    ///
    /// # Errors
    /// If the posts make no whole tiles, or a value is out of range.
    pub fn new(mut contents: Contents) -> Result<Self, Unfit> {
        let tiling = tiling(contents.order, contents.places.each_ref().map(Vec::len))?;
        check(&contents, tiling)?;
        if let coding @ Coding::Steps(_) = Coding::new(contents.step) {
            let heights = contents.heights.par_iter_mut();
            heights.for_each(|height| *height = coding.height(coding.number(*height)));
        }
        let tiles = (0..tiling.tiles()).into_par_iter().map(|tile| levels::tile(&contents, tiling, tile));
        let tiles = tiles.collect();
        Ok(Self { contents, tiling, tiles })
    }

    /// What the terrain is made of.
    pub fn contents(&self) -> &Contents {
        &self.contents
    }

    /// The same without a copy of the heights.
    pub fn into_contents(self) -> Contents {
        self.contents
    }

    /// Number of tiles in a row (along x) and in a column (along y).
    pub fn counts(&self) -> [usize; 2] {
        self.tiling.counts
    }

    /// Errors and bounds of a tile by its number: row by row from the south-west.
    ///
    /// # Panics
    /// If there is no such tile.
    pub fn tile(&self, number: usize) -> &Tile {
        &self.tiles[number]
    }

    /// Errors and bounds of all tiles, in their order.
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// Largest error of a level over all tiles (m); 0 for a level that there is not.
    pub fn error(&self, level: usize) -> f64 {
        self.tiles.iter().filter_map(|tile| tile.errors.get(level)).copied().fold(0.0, f64::max)
    }
}
