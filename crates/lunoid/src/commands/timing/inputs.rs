//! What decides a timing record, in one hash.

use std::fmt::Debug;

use blake3::Hasher;
use generator::Stage;
use landscape::bank_file;
use scenario::Scenario;

/// Hash of everything that decides the timing of a mission: ground, bodies, path, and the settings of the digital side.
/// Neither the frames that are recorded nor analog parts, light and display are in it: they change no event.
pub fn inputs_hash(scenario: &Scenario, stage: &Stage) -> String {
    let Stage { landscape, scenery, settings } = stage;
    let mut hasher = Hasher::new_derive_key("lunoid timing, inputs, format 1");
    hasher.update(&bank_file::content_hash(landscape.bank()));
    add(&mut hasher, "path", &(scenario.path.waypoints(), &scenario.vehicle));
    for standing in scenery.standing() {
        add(&mut hasher, "body", &(standing.from, standing.until, standing.body.vertices.len()));
    }
    let raster = &settings.raster;
    add(&mut hasher, "raster", &(raster.sweeps, raster.samples, raster.field, settings.timebase));
    add(&mut hasher, "fan", &(settings.laws.projection, settings.range, settings.yoke, settings.levels));
    // Bodies that are too small to be seen are not transformed.
    add(&mut hasher, "sight", &(settings.economy, raster.lines));
    add(&mut hasher, "cpu", &settings.cpu);
    add(&mut hasher, "loader", &settings.loader);
    add(&mut hasher, "data banks", &settings.data_banks);
    add(&mut hasher, "seed", &settings.seed);
    hasher.finalize().to_hex().to_string()
}

/// Debug text names all fields, and floats in it read back the same.
fn add(hasher: &mut Hasher, name: &str, value: &impl Debug) {
    let text = format!("{name} {value:?}\n");
    hasher.update(text.as_bytes());
}
