//! What decides a timing record, in one hash.

use std::fmt::Debug;

use blake3::Hasher;
use generator::Stage;
use landscape::bank_file;
use scenario::{FaceList, Scenario};

use crate::drawn_lists;
use crate::prepared::Prepared;

/// Hash of everything that decides what a frame takes: ground, craters, bodies, lists of faces, path, view, run parameters, hardware.
/// The sun of the scenario is not in it: it lights faces, and moves none.
pub(crate) fn inputs_hash(scenario: &Scenario, prepared: &Prepared) -> String {
    let Stage { landscape, scenery, view } = &prepared.stage;
    let mut hasher = Hasher::new_derive_key("lunoid timing, inputs of smooth-shaded faces, format 1");
    hasher.update(&bank_file::content_hash(landscape.bank()));
    landscape.features().craters().iter().for_each(|crater| add(&mut hasher, "crater", &crater));
    for standing in scenery.standing() {
        let body = &standing.body;
        let placed = (body.kind, body.priority, body.foot, body.vertices().collect::<Vec<_>>());
        add(&mut hasher, "body", &(standing.from, standing.until, placed));
    }
    scenery.all_guests().iter().for_each(|guest| add(&mut hasher, "guest", guest));
    scenery.groups().iter().for_each(|group| add(&mut hasher, "group", group));
    drawn_lists::drawn(&prepared.stage, &prepared.run).iter().for_each(|list| add_list(&mut hasher, list));
    add(&mut hasher, "path", &(scenario.way().waypoints(), &scenario.vehicle));
    scenario.channel.iter().for_each(|channel| add(&mut hasher, "channel", channel));
    let raster = (view.columns, view.lines, view.field, view.update);
    add(&mut hasher, "view", &(raster, view.ranges, view.yoke, view.laws.curvature));
    add(&mut hasher, "run", &prepared.run);
    add(&mut hasher, "hardware", &prepared.hardware);
    hasher.finalize().to_hex().to_string()
}

/// A list of faces; the squares of a sea follow from its board.
fn add_list(hasher: &mut Hasher, list: &FaceList) {
    let FaceList { group, kind, carrier, other_side, sea, drawn_by } = list;
    let of_group = (&group.name, group.priority, group.sun, group.detail, group.sequences());
    add(hasher, "list", &(of_group, kind, carrier, other_side, sea, drawn_by));
    if sea.is_none() {
        add(hasher, "mesh", &group.mesh);
    }
}

/// Debug text names all fields, and floats in it read back the same.
fn add(hasher: &mut Hasher, name: &str, value: &impl Debug) {
    let text = format!("{name} {value:?}\n");
    hasher.update(text.as_bytes());
}
