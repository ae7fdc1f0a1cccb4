//! What decides a timing record, in one hash.

use generator::{InputsHash, Stage};
use scenario::{FaceList, Scenario};

use crate::drawn_lists;
use crate::prepared::Prepared;

/// Hash of everything that decides what a frame takes: ground, craters, bodies, lists of faces, path, view, run parameters, hardware.
/// The sun of the scenario is not in it: it lights faces, and moves none.
pub(crate) fn inputs_hash(scenario: &Scenario, prepared: &Prepared) -> String {
    let Stage { landscape, scenery, view } = &prepared.stage;
    let mut hash = InputsHash::new("lunoid timing, inputs of smooth-shaded faces, format 1");
    hash.add_bank(landscape);
    hash.add_craters(landscape);
    hash.add_bodies(scenery);
    scenery.groups().iter().for_each(|group| hash.add("group", group));
    drawn_lists::drawn(&prepared.stage, &prepared.run).iter().for_each(|list| add_list(&mut hash, list));
    hash.add_way(scenario);
    let raster = (view.columns, view.lines, view.field, view.update);
    hash.add("view", &(raster, view.ranges, view.yoke, view.laws.curvature));
    hash.add("run", &prepared.run);
    hash.add("hardware", &prepared.hardware);
    hash.finish()
}

/// A list of faces; the squares of a sea follow from its board.
fn add_list(hash: &mut InputsHash, list: &FaceList) {
    let FaceList { group, kind, carrier, other_side, sea, drawn_by } = list;
    let of_group = (&group.name, group.priority, group.sun, group.detail, group.sequences());
    hash.add("list", &(of_group, kind, carrier, other_side, sea, drawn_by));
    if sea.is_none() {
        hash.add("mesh", &group.mesh);
    }
}
