//! What decides a timing record, in one hash.

use std::fmt::Debug;

use blake3::Hasher;
use generator::Stage;
use landscape::bank_file;
use scenario::Scenario;

use crate::session::Session;

/// Hash of everything that decides what a frame takes: ground, craters, bodies, effects, path, view, run parameters, hardware.
/// The sun is not in it: it colours surfaces, and moves none.
pub(crate) fn inputs_hash(scenario: &Scenario, session: &Session) -> String {
    let Stage { landscape, scenery, view } = &session.stage;
    let mut hasher = Hasher::new_derive_key("lunoid timing, inputs of the sampled generator, format 1");
    hasher.update(&bank_file::content_hash(landscape.bank()));
    landscape.features().craters().iter().for_each(|crater| add(&mut hasher, "crater", &crater));
    for standing in scenery.standing() {
        let body = &standing.body;
        let placed = (body.kind, body.priority, body.foot, body.vertices().collect::<Vec<_>>());
        add(&mut hasher, "body", &(standing.from, standing.until, placed));
    }
    scenery.all_guests().iter().for_each(|guest| add(&mut hasher, "guest", guest));
    scenery.all_effects().iter().for_each(|effect| add(&mut hasher, "effect", effect));
    add(&mut hasher, "path", &(scenario.way().waypoints(), &scenario.vehicle));
    scenario.channel.iter().for_each(|channel| add(&mut hasher, "channel", channel));
    let raster = (view.columns, view.lines, view.field, view.update);
    add(&mut hasher, "view", &(raster, view.ranges, view.yoke, view.levels, view.laws.curvature));
    add(&mut hasher, "run", &session.parameters);
    add(&mut hasher, "hardware", &session.hardware);
    hasher.finalize().to_hex().to_string()
}

/// Debug text names all fields, and floats in it read back the same.
fn add(hasher: &mut Hasher, name: &str, value: &impl Debug) {
    let text = format!("{name} {value:?}\n");
    hasher.update(text.as_bytes());
}
