//! What decides the pixels of a run, in one hash, and what differs between two runs.

use run_record::{ChannelRecord, PathRecord, RunRecord, SunRecord, VehicleRecord, hash};
use serde::Serialize;
use serde_json::{Value, json};

use crate::job::{COLOUR, Job, REFRESH};
use crate::world::World;

/// A hash and the document that it is of.
#[derive(Debug, Clone, PartialEq)]
pub struct Fingerprint {
    /// BLAKE3 of the document, hexadecimal.
    pub hash: String,
    /// The document; null where an earlier version did not keep it.
    pub of: Value,
}

impl Fingerprint {
    /// The fingerprint of `document`.
    pub fn new(document: Value) -> Self {
        Self { hash: hash(document.to_string().as_bytes()), of: document }
    }

    /// Of a job: program, generator, settings, view, ground, scenery, light, path. Not the range of frames, which may grow, and
    /// not the words of the scenario, which may be commented.
    pub(crate) fn of_job(job: &Job, world: &World) -> Self {
        let mut document = json!({
            "program": value(&job.program),
            "generator": job.generator.name(),
            "view": value(&world.view),
            "settings": world.settings,
            "ground": world.ground.content(),
            "scenery": value(&world.scenery),
            "sun": SunRecord::from(&job.stage.scenery.sun(0.0)),
            "vehicle": VehicleRecord::from(&job.scenario.vehicle),
            "waypoints_blake3": PathRecord::from(job.scenario.way()).waypoints_blake3,
            "depth": job.pictures.depth.bits(),
            "refresh": job.pictures.refresh,
        });
        // Grey runs keep the fingerprint that they had before there was colour.
        if job.pictures.colour {
            document["colour"] = true.into();
        }
        if let Some(channel) = &job.scenario.channel {
            document["channel"] = value(&ChannelRecord::from(channel));
        }
        Self::new(document)
    }

    /// What a record says of the same, with the hash that it has.
    pub(crate) fn of_record(record: &RunRecord) -> Self {
        let mut document = json!({
            "program": value(&record.program),
            "generator": record.generator,
            "view": value(&record.view),
            "settings": record.settings,
            "ground": record.ground.content(),
            "scenery": value(&record.scenery),
            "sun": record.sun,
            "vehicle": record.vehicle,
            "waypoints_blake3": record.path.waypoints_blake3,
            "depth": record.pictures.depth,
            "refresh": record.pictures.one_file_for_each == REFRESH,
        });
        if record.pictures.kind == COLOUR {
            document["colour"] = true.into();
        }
        if let Some(channel) = &record.channel {
            document["channel"] = value(channel);
        }
        Self { hash: record.fingerprint.clone(), of: document }
    }
}

fn value(record: &impl Serialize) -> Value {
    serde_json::to_value(record).expect("records are plain values")
}

/// Every key whose value in `then` is not that in `now`, in words.
pub fn differences(then: &Fingerprint, now: &Fingerprint) -> String {
    if then.of.is_null() {
        return "an earlier version of the program began it and did not keep what it was made from".into();
    }
    run_record::differences(&then.of, &now.of).unwrap_or_else(|| {
        format!("no key of its record differs, so its fingerprint {} was changed", then.hash)
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::{Fingerprint, differences};

    #[test]
    fn what_differs_is_named_or_said_not_to_be_known() {
        let of = |of| Fingerprint { hash: "f".into(), of };
        let (then, now) = (of(json!({ "depth": 8 })), of(json!({ "depth": 16 })));
        assert_eq!(differences(&then, &now), "depth (8 there, 16 now)");
        assert!(differences(&then, &then).contains("fingerprint f was changed"));
        assert!(differences(&of(json!(null)), &now).contains("an earlier version"));
    }
}
