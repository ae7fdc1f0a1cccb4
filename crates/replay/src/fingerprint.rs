//! What decides the pixels of a run, in one hash.

use serde::Serialize;
use serde_json::{Value, json};

use crate::held::hash;
use crate::job::Job;
use crate::scenery_record::SceneryRecord;
use crate::settings_record::{GroundRecord, SettingsRecord, sun, vehicle, waypoints_hash};

/// Program, generator, settings, ground, scenery, light, path: not the range of frames, which may grow, and not the words
/// of the scenario, which may be commented.
pub(crate) fn fingerprint(
    job: &Job,
    ground: &GroundRecord,
    scenery: &SceneryRecord,
    settings: &SettingsRecord,
) -> String {
    let mut document = json!({
        "program": value(&job.program),
        "generator": job.generator.name(),
        "settings": value(settings),
        "ground": ground_alone(ground),
        "scenery": value(scenery),
        "sun": sun(&job.stage.scenery.sun(0.0)),
        "vehicle": vehicle(&job.scenario.vehicle),
        "waypoints_blake3": waypoints_hash(job.scenario),
        "depth": job.pictures.depth.bits(),
        "refresh": job.pictures.refresh,
    });
    // Grey runs keep the fingerprint that they had before there was colour.
    if job.pictures.colour {
        document["colour"] = true.into();
    }
    hash(document.to_string().as_bytes())
}

/// The words of the ground, wherever they came from.
fn ground_alone(ground: &GroundRecord) -> Value {
    let mut ground = value(ground);
    if let Some(keys) = ground.as_object_mut() {
        for key in ["source", "title", "generator"] {
            keys.remove(key);
        }
    }
    ground
}

fn value(record: &impl Serialize) -> Value {
    serde_json::to_value(record).expect("records are plain values")
}
