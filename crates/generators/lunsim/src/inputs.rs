//! What decides a timing record, in one hash.

use generator::{InputsHash, Stage};
use scenario::Scenario;

use crate::{Hardware, Parameters};

/// Hash of everything that decides what a frame takes: what decides its film, and the hardware.
pub(crate) fn inputs_hash(
    scenario: &Scenario,
    stage: &Stage,
    run: &Parameters,
    hardware: &Hardware,
) -> String {
    let Stage { landscape, scenery, view } = stage;
    let mut hash = InputsHash::new("lunoid timing, inputs of a program, format 1");
    hash.add_bank(landscape);
    hash.add_craters(landscape);
    hash.add("light", &(scenery.suns(), landscape.albedo(), landscape.photometry()));
    hash.add_way(scenario);
    hash.add("view", &(view.field, view.ranges[1], view.update));
    hash.add("laws", &(view.laws.curvature, view.shadows.is_some(), view.display.white));
    hash.add("run", &(run.grid, run.intensity_codes));
    hash.add("hardware", hardware);
    hash.finish()
}
