//! A stage made ready: posts, levels, slopes.

use std::sync::Arc;

use generator::{PrepareError, Stage};
use lod_tiles::{State, TileState};
use scene_sampler::GroundMap;

use crate::levels::LevelTable;
use crate::parameters::Parameters;
use crate::terrain::Posts;

/// Everything of a run that frames share.
pub struct Prepared {
    pub stage: Stage,
    pub run: Parameters,
    pub posts: Posts,
    pub table: LevelTable,
    /// All tiles at the finest level.
    pub finest: State,
    /// Slopes of all posts, as the map of the ground shares them.
    slopes: Arc<[[f32; 2]]>,
}

impl Prepared {
    /// Samples the ground of `stage` and settles its levels.
    ///
    /// # Errors
    /// If the ground is too large, or ranges do not rise.
    pub fn new(stage: Stage, run: Parameters) -> Result<Self, PrepareError> {
        let run = over_stored(&stage, run);
        let mut posts = Posts::new(&stage, &run)?;
        let slopes = std::mem::take(&mut posts.slopes).into();
        let table = LevelTable::new(&posts.terrain, &run, focal(&stage))?;
        let tiles = vec![TileState { level: 0, fraction: 0.0 }; posts.heights.len()];
        let finest = State::of(&posts.terrain, tiles);
        Ok(Self { stage, run, posts, table, finest, slopes })
    }

    /// The map of the ground's slopes under a sun (unit vector to it: north, east, up).
    pub fn map(&self, sun: [f64; 3]) -> Option<GroundMap> {
        GroundMap::of_slopes(self.posts.axes, self.slopes.clone(), self.stage.landscape.clone(), sun)
    }
}

/// The run parameters with what a terrain database says where they say nothing: its order always, its ranges where none are given.
fn over_stored(stage: &Stage, mut run: Parameters) -> Parameters {
    let Some(stored) = stage.landscape.posts() else { return run };
    run.order = stored.order;
    if run.ranges.is_empty() && run.level_count() <= stored.ranges.len() {
        run.ranges = stored.ranges.iter().map(|[end, _]| *end).collect();
        run.shares = stored.ranges.iter().map(|[_, share]| *share).collect();
    }
    run
}

/// Pixels in a tangent of 1, the larger of both directions.
pub fn focal(stage: &Stage) -> f64 {
    let of = |pixels: u32, tangent: f64| f64::from(pixels) / (2.0 * tangent);
    let field = stage.view.field;
    of(stage.view.columns, field.tan_half_width).max(of(stage.view.lines, field.tan_half_height))
}
