//! `run.json`: what was drawn from what.

use std::ops::Range;

use generator::{FrameCounts, Omission, Weight};
use quantities::degrees;
use scenario::{Limit, LimitReport};
use serde::Serialize;
use serde_json::{Value, json};

use crate::held::{FileRecord, FrameRecord, RUN_SCHEMA, total_work};
use crate::job::{Job, Program};
use crate::scenery_record::SceneryRecord;
use crate::settings_record::{GroundRecord, SettingsRecord, sun, vehicle, waypoints_hash};

/// The record of a run, in the order in which it is read. Equal for equal inputs: no clock, no threads.
#[derive(Serialize)]
pub(crate) struct RunRecord<'a> {
    schema: &'static str,
    format: u32,
    fingerprint: &'a str,
    program: &'a Program,
    scenario: Value,
    references: &'a [FileRecord],
    generator: &'static str,
    model: Value,
    ground: &'a GroundRecord,
    scenery: &'a SceneryRecord,
    sun: Value,
    vehicle: Value,
    path: Value,
    settings: &'a SettingsRecord,
    pictures: Value,
    omissions: Vec<Value>,
    limits: Vec<Value>,
    range: [u64; 2],
    totals: FrameCounts,
    #[serde(skip_serializing_if = "Option::is_none")]
    check: Option<&'a Value>,
    frames: &'a [FrameRecord],
    outputs: &'a [FileRecord],
}

/// What is known when the run is finished.
pub(crate) struct Finished<'a> {
    pub fingerprint: &'a str,
    pub ground: &'a GroundRecord,
    pub scenery: &'a SceneryRecord,
    pub settings: &'a SettingsRecord,
    pub omissions: &'a [Omission],
    pub limits: &'a [LimitReport],
    pub range: &'a Range<u64>,
    /// Error against `exact`, if sweeps were checked.
    pub check: Option<&'a Value>,
    pub frames: &'a [FrameRecord],
    pub outputs: &'a [FileRecord],
}

impl<'a> RunRecord<'a> {
    /// The record of `job`, finished.
    pub fn new(job: &'a Job, finished: &Finished<'a>) -> Self {
        let inputs = &job.inputs;
        Self {
            schema: RUN_SCHEMA,
            format: 1,
            fingerprint: finished.fingerprint,
            program: &job.program,
            scenario: scenario_record(job),
            references: &inputs.references,
            generator: job.generator.name(),
            model: model(job),
            ground: finished.ground,
            scenery: finished.scenery,
            sun: sun(&job.stage.scenery.sun(0.0)),
            vehicle: vehicle(&job.scenario.vehicle),
            path: json!({
                "waypoints": job.scenario.path.waypoints().len(),
                "waypoints_blake3": waypoints_hash(job.scenario),
            }),
            settings: finished.settings,
            pictures: json!({
                "kind": if job.pictures.colour { "RGB PNG" } else { "grey PNG" },
                "depth": job.pictures.depth.bits(),
                "one_file_for_each": if job.pictures.refresh { "refresh" } else { "update" },
            }),
            omissions: finished.omissions.iter().map(omission).collect(),
            limits: finished.limits.iter().map(limit).collect(),
            range: [finished.range.start, finished.range.end],
            totals: total_work(finished.frames),
            check: finished.check,
            frames: finished.frames,
            outputs: finished.outputs,
        }
    }

    /// The document, ending with a newline.
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).expect("records are plain values") + "\n"
    }
}

/// The scenario by name and hash.
pub(crate) fn scenario_record(job: &Job) -> Value {
    json!({ "file": job.inputs.scenario, "title": job.scenario.title, "shows": job.scenario.shows })
}

fn model(job: &Job) -> Value {
    let value = |value: &hardware_model::EffectiveValue| json!({ "key": value.key, "value": value.value, "origin": value.origin });
    json!({
        "name": job.inputs.model,
        "files": job.inputs.model_files,
        "values": job.inputs.model_values.iter().map(value).collect::<Vec<_>>(),
    })
}

/// What was left out, with weight and reason.
pub(crate) fn omission(omission: &Omission) -> Value {
    let weight = match omission.weight {
        Weight::Lossless => json!("lossless"),
        Weight::NotModelled => json!("not modelled"),
        Weight::Bounded(levels) => json!({ "bounded_grey_levels_of_255": levels }),
    };
    json!({ "block": omission.block, "what": omission.what, "why": omission.why, "weight": weight })
}

fn limit(report: &LimitReport) -> Value {
    let (what, unit, scale): (_, _, fn(f64) -> f64) = match report.what {
        Limit::Speed => ("speed", "m/s", |speed| speed),
        Limit::Turn => ("turn", "deg/s", degrees),
        Limit::Slope => ("slope", "deg", degrees),
    };
    json!({
        "limit": what,
        "unit": unit,
        "allowed": scale(report.allowed),
        "found": scale(report.found),
        "frame": report.frame,
        "time_s": report.time,
        "frames": [report.frames.start, report.frames.end],
    })
}
