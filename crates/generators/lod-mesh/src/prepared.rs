//! A stage made ready: posts, levels, slopes.

use std::borrow::Cow;
use std::sync::Arc;

use generator::{PrepareError, Stage};
use lod_tiles::{State, TileState};
use rayon::prelude::*;
use scenario::Standing;
use scene_sampler::{Axis, Camera, GroundMap, Slopes};
use solids::Kind;

use crate::boulders::FewFaces;
use crate::levels::LevelTable;
use crate::name::NAME;
use crate::parameters::{Boulders, GroundLight, Parameters, Slots};
use crate::slots::fitting_order;
use crate::terrain::Posts;
use crate::time::Hardware;

/// Everything of a run that frames share.
pub struct Prepared {
    pub stage: Stage,
    pub run: Parameters,
    pub posts: Posts,
    pub table: LevelTable,
    /// All tiles at the finest level.
    pub finest: State,
    /// Shapes of small boulders, where there are any and they are drawn by distance.
    pub few_faces: Option<FewFaces>,
    /// Slots of the board's uniform array; `None` is without limit.
    pub slots: Option<u32>,
    /// Light and albedo of the terrain database, where they are drawn.
    pub stored: Option<GroundMap>,
    /// Places of the posts whose slopes light looks up: north, then east.
    light_axes: [Axis; 2],
    /// Slopes of those posts, as the map of the ground shares them.
    slopes: Slopes,
}

impl Prepared {
    /// Samples the ground of `stage` and settles its levels.
    ///
    /// # Errors
    /// If the ground is too large, ranges do not rise, or tiles are more than the slots of the board where that is refused.
    pub fn new(stage: Stage, run: Parameters, hardware: &Hardware) -> Result<Self, PrepareError> {
        let run = over_stored(&stage, run);
        let (posts, slopes) = Posts::new(&stage, &run)?;
        let slots = hardware.board.uniform_slots;
        check_slots(&posts, &run, slots)?;
        let (light_axes, slopes) = posts.slopes_of(run.light_level, slopes)?;
        let stage = placed(stage, run.boulders);
        let table = LevelTable::new(&posts.terrain, &run, focal(&stage))?;
        let tiles = vec![TileState { level: 0, fraction: 0.0 }; posts.heights.len()];
        let finest = State::of(&posts.terrain, tiles);
        let stored =
            if run.light == GroundLight::Stored { Some(stored_light(&stage, &posts)?) } else { None };
        let few_faces = if run.boulder_px > 0.0 { FewFaces::of(&stage)? } else { None };
        Ok(Self { few_faces, stored, stage, run, posts, table, finest, slots, light_axes, slopes })
    }

    /// The stage as a camera sees its boulders.
    pub fn seen(&self, camera: &Camera) -> Cow<'_, Stage> {
        match &self.few_faces {
            Some(few) => Cow::Owned(few.seen(&self.stage, camera, self.run.boulder_px)),
            None => Cow::Borrowed(&self.stage),
        }
    }

    /// The map of the ground's slopes under a sun (unit vector to it: north, east, up).
    pub fn map(&self, sun: [f64; 3]) -> Option<GroundMap> {
        GroundMap::of_slopes(self.light_axes, self.slopes.clone(), self.stage.landscape.clone(), sun)
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

/// Refuses more tiles than slots, where they must have one each.
fn check_slots(posts: &Posts, run: &Parameters, slots: Option<u32>) -> Result<(), PrepareError> {
    let (terrain, Some(slots), Slots::Refuse) = (&posts.terrain, slots, run.slots) else { return Ok(()) };
    let tiles = terrain.tiles().count();
    if tiles <= slots as usize {
        return Ok(());
    }
    let larger = match fitting_order(terrain, slots) {
        Some(order) => format!("tiles of order {order} or above would do (lod.order)"),
        None => "no tile is large enough: ask for a larger lod.spacing_m".to_owned(),
    };
    Err(PrepareError::Unsupported {
        generator: NAME,
        what: format!("{tiles} tiles with the {slots} slots of board.uniform_slots"),
        remedy: format!("{larger}; or let tiles share slots (lod.slots = \"share\")"),
    })
}

/// The stage with its boulders where the run puts them.
fn placed(stage: Stage, boulders: Boulders) -> Stage {
    if boulders == Boulders::OnGround {
        return stage;
    }
    let at_zero = |standing: &Standing| match standing.body.kind {
        Kind::Rock => Standing { body: standing.body.lifted(-standing.body.foot.z), ..standing.clone() },
        Kind::Culture => standing.clone(),
    };
    let standing = stage.scenery.standing().iter().map(at_zero).collect();
    let scenery = (*stage.scenery).clone().with_bodies(standing);
    Stage { scenery: Arc::new(scenery), ..stage }
}

/// The map of light and albedo that a terrain database stores. Without an albedo of its own, the landscape's is taken.
fn stored_light(stage: &Stage, posts: &Posts) -> Result<GroundMap, PrepareError> {
    let database = stage.landscape.posts();
    let Some((stored, light)) = database.and_then(|stored| Some((stored, stored.light.as_ref()?))) else {
        return Err(PrepareError::Unsupported {
            generator: NAME,
            what: match database {
                Some(_) => "stored light with a terrain database that has none".to_owned(),
                None => "stored light without a terrain database".to_owned(),
            },
            remedy: "export the terrain with [light] and name it as landscape.database, or choose lod.light = \"map\""
                .into(),
        });
    };
    let [rows, columns] = &stored.places;
    let colour = |post: usize| {
        let albedo = match &stored.albedo {
            Some(albedo) => [albedo[post]; 3],
            None => {
                let place = [rows[post / columns.len()], columns[post % columns.len()]];
                stage.landscape.albedo_at(place[0], place[1]).map(|albedo| albedo as f32)
            }
        };
        albedo.map(|albedo| albedo * light[post])
    };
    let colours: Vec<[f32; 3]> = (0..light.len()).into_par_iter().map(colour).collect();
    GroundMap::of_colours(posts.axes, colours.into()).ok_or_else(|| PrepareError::Unsupported {
        generator: NAME,
        what: format!("a light map of {} posts for {}", light.len(), stored.heights.len()),
        remedy: "export the terrain again".into(),
    })
}

/// Pixels in a tangent of 1, the larger of both directions.
pub fn focal(stage: &Stage) -> f64 {
    let of = |pixels: u32, tangent: f64| f64::from(pixels) / (2.0 * tangent);
    let field = stage.view.field;
    of(stage.view.columns, field.tan_half_width).max(of(stage.view.lines, field.tan_half_height))
}
