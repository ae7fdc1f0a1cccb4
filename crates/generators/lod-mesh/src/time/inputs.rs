//! What decides a timing record, in one hash.

use generator::{InputsHash, Stage};
use scenario::Scenario;

use super::Hardware;
use crate::prepared::Prepared;

/// Hash of everything that decides what a frame takes: ground, craters, path, view, run parameters, hardware. The sun is not in it: it lights the
/// ground, and moves none. Bodies are not counted.
pub(super) fn inputs_hash(scenario: &Scenario, prepared: &Prepared, hardware: &Hardware) -> String {
    let Stage { landscape, view, .. } = &prepared.stage;
    let mut hash = InputsHash::new("lunoid timing, inputs of tiles at levels of detail, format 1");
    hash.add_bank(landscape);
    hash.add_craters(landscape);
    if let Some(posts) = landscape.posts() {
        let bytes: Vec<u8> = posts.heights.iter().flat_map(|height| height.to_le_bytes()).collect();
        hash.add("posts", &(&posts.places, posts.order, &posts.ranges));
        hash.add_bytes(&bytes);
    }
    hash.add_way(scenario);
    hash.add("view", &(view.columns, view.lines, view.field, view.update, view.yoke, view.laws.curvature));
    hash.add("run", &prepared.run);
    hash.add("hardware", hardware);
    hash.finish()
}
