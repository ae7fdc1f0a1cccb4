//! What decides a timing record, in one hash.

use generator::{InputsHash, Stage};
use scenario::Scenario;

use super::Hardware;
use crate::Parameters;

/// Hash of everything that decides what a frame takes and which records it writes: ground, photographs, path, view, run parameters, hardware.
pub(super) fn inputs_hash(
    scenario: &Scenario,
    stage: &Stage,
    run: &Parameters,
    hardware: &Hardware,
) -> String {
    let Stage { landscape, view, .. } = stage;
    let mut hash = InputsHash::new("lunoid timing, inputs of the program of panels, format 1");
    hash.add_bank(landscape);
    hash.add_craters(landscape);
    if let Some(photograph) = landscape.photographs().first() {
        hash.add("photograph", &(photograph.placement(), photograph.transfer()));
        let picture = photograph.picture();
        hash.add("codes", &(picture.columns(), picture.lines(), picture.depth()));
        let bytes: Vec<u8> = picture.codes().iter().flat_map(|code| code.to_le_bytes()).collect();
        hash.add_bytes(&bytes);
    }
    hash.add_way(scenario);
    hash.add("view", &(view.columns, view.lines, view.field, view.update, view.yoke));
    hash.add("run", run);
    hash.add("hardware", hardware);
    hash.finish()
}
