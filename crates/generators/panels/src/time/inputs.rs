//! What decides a timing record, in one hash.

use std::fmt::Debug;

use blake3::Hasher;
use generator::Stage;
use landscape::bank_file;
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
    let mut hasher = Hasher::new_derive_key("lunoid timing, inputs of the program of panels, format 1");
    hasher.update(&bank_file::content_hash(landscape.bank()));
    landscape.features().craters().iter().for_each(|crater| add(&mut hasher, "crater", &crater));
    if let Some(photograph) = landscape.photographs().first() {
        add(&mut hasher, "photograph", &(photograph.placement(), photograph.transfer()));
        let picture = photograph.picture();
        add(&mut hasher, "codes", &(picture.columns(), picture.lines(), picture.depth()));
        let bytes: Vec<u8> = picture.codes().iter().flat_map(|code| code.to_le_bytes()).collect();
        hasher.update(&bytes);
    }
    add(&mut hasher, "path", &(scenario.way().waypoints(), &scenario.vehicle));
    scenario.channel.iter().for_each(|channel| add(&mut hasher, "channel", channel));
    add(&mut hasher, "view", &(view.columns, view.lines, view.field, view.update, view.yoke));
    add(&mut hasher, "run", run);
    add(&mut hasher, "hardware", hardware);
    hasher.finalize().to_hex().to_string()
}

/// Debug text names all fields, and floats in it read back the same.
fn add(hasher: &mut Hasher, name: &str, value: &impl Debug) {
    let text = format!("{name} {value:?}\n");
    hasher.update(text.as_bytes());
}
