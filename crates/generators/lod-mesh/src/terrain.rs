//! Posts of a landscape's ground, stored or sampled, cut into tiles.

use std::ops::RangeInclusive;
use std::sync::Arc;

use generator::{PrepareError, Stage};
use landscape::Landscape;
use lod_tiles::{Terrain, Tile};
use rayon::prelude::*;
use scene_sampler::{Axis, Slopes, slopes_between};

use crate::name::NAME;
use crate::parameters::Parameters;

/// Cells along the longer side of the ground where no spacing is asked for. Chosen: a million posts.
pub const USUAL_CELLS: f64 = 1024.0;

/// Most posts. Chosen: 1 GB of heights and slopes.
const MOST_POSTS: usize = 64_000_000;

/// Posts of a frame's ground. Along x they run to the east, along y to the north.
pub struct Posts {
    /// Heights, cut into tiles.
    pub terrain: Terrain,
    /// Places of rows and columns on the map: north, then east.
    pub axes: [Axis; 2],
    /// Lowest and highest height of each tile (m), in the order of the terrain.
    pub heights: Vec<RangeInclusive<f64>>,
}

impl Posts {
    /// The posts of a stage's ground, and the slopes of all of them.
    ///
    /// # Errors
    /// If there are too many, or the bank has no ground at one of them.
    pub fn new(stage: &Stage, run: &Parameters) -> Result<(Self, Slopes), PrepareError> {
        match stage.landscape.posts() {
            Some(stored) => Self::stored(stored),
            None => Self::of_landscape(&stage.landscape, run),
        }
    }

    /// The posts of a terrain database. Slopes are those to the posts around each.
    fn stored(stored: &landscape::Posts) -> Result<(Self, Slopes), PrepareError> {
        let [rows, columns] = &stored.places;
        let axes = [even(rows)?, even(columns)?];
        let places = Arc::new(stored.places.clone());
        let slopes = Slopes::Between { places, heights: stored.heights.clone() };
        Ok((Self::cut(stored.order, stored.places.clone(), axes, stored.heights.clone())?, slopes))
    }

    /// Distance (m) of most posts, the larger of both axes.
    pub fn spacing(&self) -> f64 {
        self.axes[0].step.max(self.axes[1].step)
    }

    fn of_landscape(landscape: &Landscape, run: &Parameters) -> Result<(Self, Slopes), PrepareError> {
        let [south, west, north, east] = extent(landscape);
        let spacing = run.spacing.unwrap_or((north - south).max(east - west) / USUAL_CELLS);
        let axes = [axis(south, north, spacing, run.order), axis(west, east, spacing, run.order)];
        let count = axes[0].posts.saturating_mul(axes[1].posts);
        if count > MOST_POSTS {
            let what = format!("{count} posts (at most {MOST_POSTS})");
            return Err(refused(what, "ask for a larger lod.spacing_m"));
        }
        let places = axes.map(|axis| places(&axis));
        match sampled(landscape, &places, spacing) {
            Some((heights, slopes)) => {
                Ok((Self::cut(run.order, places, axes, heights.into())?, Slopes::Listed(slopes.into())))
            }
            None => Err(refused("ground with holes".into(), "give it a bank whose levels nest")),
        }
    }

    /// Slopes of the posts that level `level` has, with their places: `slopes`, those of all posts, where that is 0, else those to the posts of
    /// the level around each.
    ///
    /// # Errors
    /// If the level has no two posts along an axis.
    pub fn slopes_of(&self, level: u32, slopes: Slopes) -> Result<([Axis; 2], Slopes), PrepareError> {
        if level == 0 {
            return Ok((self.axes, slopes));
        }
        let step = 1_usize << level;
        let posts = self.axes.map(|axis| places(&axis).into_iter().step_by(step).collect::<Vec<f64>>());
        let [rows, columns] = &posts;
        let height = |row: usize, column: usize| {
            let (tile, within) = self.terrain.locate([columns[column], rows[row]]);
            self.terrain.height(tile, 0, within.map(|cell| cell.round() as usize))
        };
        let of_post = |post| slopes_between(&posts, [post / columns.len(), post % columns.len()], height);
        let slopes: Vec<[f32; 2]> = (0..rows.len() * columns.len()).into_par_iter().map(of_post).collect();
        Ok(([even(rows)?, even(columns)?], Slopes::Listed(slopes.into())))
    }

    /// Cuts posts into tiles.
    fn cut(
        order: u32,
        [rows, columns]: [Vec<f64>; 2],
        axes: [Axis; 2],
        heights: Arc<Vec<f64>>,
    ) -> Result<Self, PrepareError> {
        let terrain = Terrain::shared(order, [columns, rows], heights)
            .map_err(|error| refused(error.to_string(), "choose another lod.order or lod.spacing_m"))?;
        let tiles: Vec<Tile> = terrain.tiles().collect();
        let heights = tiles.into_par_iter().map(|tile| heights_of(&terrain, tile)).collect();
        Ok(Self { terrain, axes, heights })
    }
}

fn refused(what: String, remedy: &str) -> PrepareError {
    PrepareError::Unsupported { generator: NAME, what, remedy: remedy.into() }
}

/// The axis of stored places: evenly spaced, but for those of a last tile.
fn even(places: &[f64]) -> Result<Axis, PrepareError> {
    let cell = |at: usize| places[at + 1] - places[at];
    let cells = places.len().saturating_sub(1);
    let is_like = |at: &usize, step: f64| (cell(*at) - step).abs() <= 1e-6 * step;
    let (step, last_step) = (cell(0), cell(cells - 1));
    let whole = (0..cells).take_while(|at| is_like(at, step)).count();
    match (whole..cells).all(|at| is_like(&at, last_step)) {
        true => Ok(Axis { first: places[0], step, whole, last_step, posts: places.len() }),
        false => Err(refused("posts at uneven distances".into(), "export the terrain again")),
    }
}

/// South, west, north, east border (m) of all levels of a bank.
fn extent(landscape: &Landscape) -> [f64; 4] {
    let levels = landscape.bank().levels().iter().map(|level| level.extent());
    let both = |a: [f64; 4], b: [f64; 4]| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])];
    levels.reduce(both).unwrap_or_default()
}

/// Posts `spacing` apart from `first` to `last`. What is left for the last tile has as many cells as the others, and narrower ones.
fn axis(first: f64, last: f64, spacing: f64, order: u32) -> Axis {
    let side = 1_usize << order;
    // The last cell is no narrower than a thousandth of a tile's.
    let tiles = ((last - first) / (spacing * side as f64) - 1e-3).ceil().max(1.0) as usize;
    let whole = (tiles - 1) * side;
    let last_step = (last - first - whole as f64 * spacing) / side as f64;
    Axis { first, step: spacing, whole, last_step, posts: tiles * side + 1 }
}

/// Places (m) of the posts along an axis.
fn places(axis: &Axis) -> Vec<f64> {
    let place = |post: usize| {
        let beyond = post.saturating_sub(axis.whole);
        axis.first + (post - beyond) as f64 * axis.step + beyond as f64 * axis.last_step
    };
    (0..axis.posts).map(place).collect()
}

/// Heights and slopes row by row, without features too small for the spacing; `None` if there is no ground at a post.
fn sampled(
    landscape: &Landscape,
    [rows, columns]: &[Vec<f64>; 2],
    spacing: f64,
) -> Option<(Vec<f64>, Vec<[f32; 2]>)> {
    let count = rows.len() * columns.len();
    let (mut heights, mut slopes) = (vec![0.0; count], vec![[0.0; 2]; count]);
    let posts = heights.par_iter_mut().zip(&mut slopes).enumerate();
    posts.try_for_each(|(post, (height, slopes))| {
        let (north, east) = (rows[post / columns.len()], columns[post % columns.len()]);
        let ground = landscape.at_spacing(north, east, spacing)?;
        (*height, *slopes) = (ground.height, ground.slopes.map(|slope| slope as f32));
        Some(())
    })?;
    Some((heights, slopes))
}

fn heights_of(terrain: &Terrain, tile: Tile) -> RangeInclusive<f64> {
    let cells = terrain.cells(0);
    let posts = (0..=cells).flat_map(|j| (0..=cells).map(move |i| [i, j]));
    let heights = posts.map(|at| terrain.height(tile, 0, at));
    let (low, high) = heights
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| (low.min(height), high.max(height)));
    low..=high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_tile_has_narrower_cells() {
        // The document's example: 152 cells in tiles of 32 are 4 tiles, and one with 24 cells stretched to 32.
        let axis = axis(10.0, 10.0 + 152.0 * 100.0, 100.0, 5);
        assert_eq!((axis.whole, axis.posts, axis.last_step), (128, 161, 75.0));
        let places = places(&axis);
        assert_eq!((places[0], places[128], places[129], places[160]), (10.0, 12_810.0, 12_885.0, 15_210.0));
    }

    #[test]
    fn whole_tiles_are_left_alone() {
        let axis = axis(0.0, 640.0, 10.0, 5);
        assert_eq!((axis.posts, axis.last_step), (65, 10.0));
    }
}
