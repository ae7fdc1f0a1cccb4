//! `truth.json`: which arrays there are, what their numbers mean, and how wrong they may be.

use generator::Omission;
use landscape::LUNOID_RADIUS;
use run_record::{FileRecord, OmissionRecord, TRUTH_SCHEMA, TruthFrame, TruthRecord};
use scenario::{Curvature, Projection};
use serde_json::{Value, json};

use super::{TruthItem, TruthItems};
use crate::HeldRun;
use crate::camera::camera;
use crate::job::Job;
use crate::record::scenario_record;
use crate::world::World;

/// Version of the format of arrays and record.
pub(super) const FORMAT: u32 = 1;

/// What is known when the truth is finished.
pub(super) struct Finished<'a> {
    pub job: &'a Job<'a>,
    pub run: &'a HeldRun,
    pub items: &'a TruthItems,
    pub fingerprint: &'a str,
    pub frames: &'a [TruthFrame],
    pub outputs: &'a [FileRecord],
    pub omissions: &'a [Omission],
}

/// The record. Equal for equal inputs: no clock, no threads.
pub(super) fn truth_record(finished: &Finished) -> TruthRecord {
    let Finished { job, run, items, fingerprint, frames, outputs, omissions } = finished;
    let World { ground, scenery, view, .. } = World::of(job);
    let plane = |item: TruthItem| item.description(view.lines, view.columns);
    TruthRecord {
        schema: TRUTH_SCHEMA.into(),
        format: FORMAT,
        fingerprint: (*fingerprint).into(),
        run_fingerprint: run.fingerprint.clone(),
        program: job.program.clone(),
        scenario: scenario_record(job),
        references: job.inputs.references.clone(),
        generator: registry::judge().name.into(),
        planes: items.iter().map(plane).collect(),
        ground,
        scenery,
        view,
        conventions: json!({
            "pixel": "every value is that of the ray through the centre of its pixel",
            "rows": "index [line, column], from the top left",
            "frames": "counted at the update rate, whatever pictures the run keeps",
            "axes": "x north, y east, height above the lunoid; metres",
            "no_number": "no value is NaN",
        }),
        camera: camera(&job.stage),
        point: point(job),
        error: TRUTH_ERROR.map(str::to_owned).into(),
        not_in_it: NOT_IN_IT.map(str::to_owned).into(),
        omissions: omissions.iter().map(OmissionRecord::from).collect(),
        frames: frames.to_vec(),
        outputs: outputs.to_vec(),
    }
}

/// From a pixel, its range and the pose to a point of the landscape.
fn point(job: &Job) -> Value {
    let laws = &job.stage.view.laws;
    let (ray, rise) = match laws.projection {
        Projection::Exact => ("d = rotation [1, X, Y]", "t = -d[2] / sqrt(d[0]^2 + d[1]^2)"),
        Projection::Corrected => (UPRIGHT_RAY, "t = -Y' / sqrt(1 + X'^2)"),
        Projection::AsReported => (UPRIGHT_RAY, "t = tan(pitch - atan(Y'))"),
    };
    let (drop, radius) = match laws.curvature {
        Curvature::Parabolic => (" + s^2 / (2 lunoid_radius_m)", Some(LUNOID_RADIUS)),
        Curvature::Exact => (" + lunoid_radius_m - sqrt(lunoid_radius_m^2 - s^2)", Some(LUNOID_RADIUS)),
        Curvature::None => ("", None),
    };
    json!({
        "ray": ray,
        "rise": rise,
        "point": format!(
            "u = d[0:2] / sqrt(d[0]^2 + d[1]^2), s = range: x = eye_m[0] + s u[0], y = eye_m[1] + s u[1], \
             height = eye_m[2] + s t{drop}"
        ),
        "lunoid_radius_m": radius,
    })
}

/// Under the laws that are not a perspective, azimuth and elevation come from the upright view-plane.
const UPRIGHT_RAY: &str = "X' = X cos(yoke) - Y sin(yoke), Y' = X sin(yoke) + Y cos(yoke), \
    a = heading + atan(X'), d = [cos(a), sin(a)]";

/// How wrong the numbers of the truth may be, in words; `docs/truth-format.md` says the same at length.
pub const TRUTH_ERROR: [&str; 6] = [
    "range: first root along the ray of the closed form of the ground, in f64; good to 1e-12 of the range, but where \
     the ray only grazes the ground, where a crest that it touches may count or not",
    "height, normal, reflectivity: closed forms at that place",
    "shadow: local shadow from the normal; remote shadow is a root along the sunbeam, which begins 1e-10 (1 + |height|) \
     m above the ground, so that a boundary moves by that over the tangent of the sun's elevation; for light the map is \
     flat, the lunoid's drop counts for sight alone",
    "label: of what the ray meets first",
    "numbers are stored as f32: 6e-8 of the value; poses are f64",
    "one ray a pixel: what lies between the centres of pixels is not seen",
];

/// What the truth leaves out.
const NOT_IN_IT: [&str; 4] = [
    "ground nearer than the first range of the sweeps, where sweeps can be drawn, and ground beyond their last, counts as \
     sky; far silhouettes have a label and a reflectivity and no place",
    "texture: the small detail that is added to the picture has no height, no normal and no share in reflectivity",
    "line means, sweeps, sweep memory, white point and gamma: whatever comes between the scene and the picture",
    "pictures between updates: a refresh shows the update before it",
];
