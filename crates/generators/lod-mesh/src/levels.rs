//! Levels of a run: their ranges by hand, or from the error that a pixel allows.

use generator::PrepareError;
use lod_tiles::{Level, Levels, Terrain};
use rayon::prelude::*;

use crate::name::NAME;
use crate::parameters::{Parameters, Transition};

/// By how much a morph zone is longer than a tile, so that neighbours are never a whole zone apart. Chosen.
const ROOM: f64 = 1.01;

/// The levels of a run with the error of each, and what is wrong with their zones.
pub struct LevelTable {
    /// Ranges and shares of all levels.
    pub levels: Levels,
    /// Ends of the ranges (m), the finest level first.
    pub ends: Vec<f64>,
    /// Largest distance (m) that a vertex moves until a level is the next one; 0 for the coarsest.
    pub errors: Vec<f64>,
    /// The first level whose morph zone is shorter than a tile, with the length of the zone and of a tile (m).
    pub short_zone: Option<(usize, f64, f64)>,
}

impl LevelTable {
    /// The levels of `run` over `terrain`, seen with a focal length of so many pixels.
    ///
    /// # Errors
    /// If ranges do not rise.
    pub fn new(terrain: &Terrain, run: &Parameters, focal: f64) -> Result<Self, PrepareError> {
        let count = run.level_count().min(terrain.order() as usize + 1);
        let side = side(terrain);
        let error = |level: usize| if level + 1 < count { error(terrain, level) } else { 0.0 };
        let errors: Vec<f64> = (0..count).map(error).collect();
        let share = |level: usize| run.shares[level.min(run.shares.len() - 1)];
        let ends = match run.ranges.is_empty() {
            true => ends(&errors, share, side, focal / run.tolerance),
            false => run.ranges[..count].to_vec(),
        };
        let levels = ends.iter().enumerate().map(|(level, &end)| Level { end, share: share(level) });
        let levels =
            Levels::new(terrain.order(), levels.collect()).map_err(|error| PrepareError::Unsupported {
                generator: NAME,
                what: error.to_string(),
                remedy: "choose other lod.ranges_m or lod.morph_percent".into(),
            })?;
        // Levels that switch have no zones.
        let morphs = run.transition == Transition::Morph;
        let is_short = |level: &usize| morphs && share(*level) > 0.0 && levels.zone(*level) < side;
        let short = (0..count - 1).find(is_short).map(|level| (level, levels.zone(level), side));
        Ok(Self { levels, ends, errors, short_zone: short })
    }
}

impl LevelTable {
    /// Ranges of all levels, and what each loses to the next one, in words.
    pub fn told(&self) -> String {
        let level = |(level, (end, error)): (usize, (&f64, &f64))| match level + 1 == self.ends.len() {
            true => format!("{level} beyond"),
            false => format!("{level} to {end:.0} m, {error:.3} m from the next"),
        };
        self.ends.iter().zip(&self.errors).enumerate().map(level).collect::<Vec<_>>().join("; ")
    }
}

/// Longest side (m) of a tile: neighbouring middles are as far apart at most.
fn side(terrain: &Terrain) -> f64 {
    let cells = terrain.cells(0);
    let tile = lod_tiles::Tile { column: 0, row: 0 };
    let [from, to] = [[0, 0], [cells, cells]].map(|at| terrain.place(tile, 0, at));
    (to[0] - from[0]).max(to[1] - from[1])
}

/// Ends of the ranges: a level goes on until what it loses to the next one is seen under a pixel's tolerance, at least for `2^level` tiles,
/// and so long that its zone is longer than a tile.
fn ends(errors: &[f64], share: impl Fn(usize) -> f64, side: f64, reach: f64) -> Vec<f64> {
    let mut begin = 0.0;
    let mut end = |level: usize| {
        let zone = if share(level) > 0.0 { ROOM * side / share(level) } else { 0.0 };
        let least = (side * (1_u64 << level) as f64).max(begin + zone);
        begin = least.max(errors[level] * reach).max(begin * (1.0 + f64::EPSILON));
        begin
    };
    (0..errors.len()).map(&mut end).collect()
}

/// Largest distance (m) that a vertex of a level moves until the level is the next one.
fn error(terrain: &Terrain, level: usize) -> f64 {
    let cells = terrain.cells(level);
    let of_tile = |tile: lod_tiles::Tile| {
        let at = (0..=cells).flat_map(|j| (0..=cells).map(move |i| [i, j]));
        at.map(|at| terrain.delta(tile, level, at).abs()).fold(0.0, f64::max)
    };
    let tiles: Vec<_> = terrain.tiles().collect();
    tiles.into_par_iter().map(of_tile).reduce(|| 0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_ends_where_its_loss_is_a_pixel() {
        // 2 m are a pixel of 1000 at 2000 m; 20 m at 20 km. The coarsest level loses nothing.
        let found = ends(&[2.0, 20.0, 0.0], |_| 0.5, 100.0, 1000.0);
        assert_eq!((found[0], found[1]), (2000.0, 20_000.0));
        assert!(found[2] > found[1]);
    }

    #[test]
    fn zones_are_longer_than_a_tile_on_flat_ground() {
        let found = ends(&[0.0; 4], |_| 0.4, 100.0, 1000.0);
        let mut begin = 0.0;
        for end in found {
            assert!(0.4 * (end - begin) > 100.0);
            begin = end;
        }
    }
}
