//! What decides a timing record, in one hash.

use std::fmt::Debug;

use blake3::Hasher;
use generator::Stage;
use landscape::bank_file;
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
    let mut hasher = Hasher::new_derive_key("lunoid timing, inputs of a program, format 1");
    hasher.update(&bank_file::content_hash(landscape.bank()));
    landscape.features().craters().iter().for_each(|crater| add(&mut hasher, "crater", &crater));
    add(&mut hasher, "light", &(scenery.suns(), landscape.albedo(), landscape.photometry()));
    add(&mut hasher, "path", &(scenario.way().waypoints(), &scenario.vehicle));
    scenario.channel.iter().for_each(|channel| add(&mut hasher, "channel", channel));
    add(&mut hasher, "view", &(view.field, view.ranges[1], view.update));
    add(&mut hasher, "laws", &(view.laws.curvature, view.shadows.is_some(), view.display.white));
    add(&mut hasher, "run", &(run.grid, run.intensity_codes));
    add(&mut hasher, "hardware", hardware);
    hasher.finalize().to_hex().to_string()
}

/// Debug text names all fields, and floats in it read back the same.
fn add(hasher: &mut Hasher, name: &str, value: &impl Debug) {
    let text = format!("{name} {value:?}\n");
    hasher.update(text.as_bytes());
}
