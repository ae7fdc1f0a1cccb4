//! What decides a timing record, in one hash.

use generator::{InputsHash, Stage};
use scenario::Scenario;

use crate::session::Session;

/// Hash of everything that decides what a frame takes: ground, craters, bodies, effects, path, view, run parameters, hardware.
/// The sun is not in it: it colours surfaces, and moves none.
pub(crate) fn inputs_hash(scenario: &Scenario, session: &Session) -> String {
    let Stage { landscape, scenery, view } = &session.stage;
    let mut hash = InputsHash::new("lunoid timing, inputs of the sampled generator, format 1");
    hash.add_bank(landscape);
    hash.add_craters(landscape);
    hash.add_bodies(scenery);
    scenery.all_effects().iter().for_each(|effect| hash.add("effect", effect));
    hash.add_way(scenario);
    let raster = (view.columns, view.lines, view.field, view.update);
    hash.add("view", &(raster, view.ranges, view.yoke, view.levels, view.laws.curvature));
    hash.add("run", &session.parameters);
    hash.add("hardware", &session.hardware);
    hash.finish()
}
