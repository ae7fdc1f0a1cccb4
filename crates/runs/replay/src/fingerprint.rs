//! What decides the pixels of a run, in one hash.

use run_record::{PathRecord, SunRecord, VehicleRecord, hash};
use serde::Serialize;
use serde_json::{Value, json};

use crate::job::Job;
use crate::world::World;

/// Program, generator, settings, view, ground, scenery, light, path: not the range of frames, which may grow, and not the
/// words of the scenario, which may be commented.
pub(crate) fn fingerprint(job: &Job, world: &World) -> String {
    let mut document = json!({
        "program": value(&job.program),
        "generator": job.generator.name(),
        "view": value(&world.view),
        "settings": world.settings,
        "ground": world.ground.content(),
        "scenery": value(&world.scenery),
        "sun": SunRecord::from(&job.stage.scenery.sun(0.0)),
        "vehicle": VehicleRecord::from(&job.scenario.vehicle),
        "waypoints_blake3": PathRecord::from(&job.scenario.path).waypoints_blake3,
        "depth": job.pictures.depth.bits(),
        "refresh": job.pictures.refresh,
    });
    // Grey runs keep the fingerprint that they had before there was colour.
    if job.pictures.colour {
        document["colour"] = true.into();
    }
    hash(document.to_string().as_bytes())
}

fn value(record: &impl Serialize) -> Value {
    serde_json::to_value(record).expect("records are plain values")
}
