//! `truth.json`: which arrays there are, what their numbers mean, and how wrong they may be.

use std::path::Path;

use generator::Omission;
use landscape::LUNOID_RADIUS;
use scenario::{Curvature, Projection};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::TruthItems;
use crate::camera::camera;
use crate::ground_record::GroundRecord;
use crate::held::stays_inside;
use crate::job::Job;
use crate::record::{omission, scenario_record};
use crate::scenery_record::SceneryRecord;
use crate::view_record::ViewRecord;
use crate::{HeldRun, ReplayError};
use run_record::{FileRecord, MAX_BYTES};

/// Version of the format of arrays and record.
pub(super) const FORMAT: u32 = 1;

/// Schema of the record.
const SCHEMA: &str = "lunoid.truth/1";

/// One frame of the truth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct TruthFrame {
    pub frame: u64,
    pub time_s: f64,
    /// From the folder of the truth; none where only poses were asked for.
    pub files: Vec<FileRecord>,
}

/// What an earlier record says.
#[derive(Debug, Deserialize)]
pub(super) struct HeldTruth {
    schema: String,
    pub fingerprint: String,
    pub frames: Vec<TruthFrame>,
}

impl HeldTruth {
    /// The record at `path`, if there is one.
    pub fn read_if_there(path: &Path) -> Result<Option<Self>, ReplayError> {
        if !path.exists() {
            return Ok(None);
        }
        let refused = |reason: String| ReplayError::TruthRecord { path: path.to_owned(), reason };
        let bytes = files::read_all(path, MAX_BYTES)?;
        let held: Self = serde_json::from_slice(&bytes).map_err(|error| refused(error.to_string()))?;
        if held.schema != SCHEMA {
            return Err(refused(format!("schema {:?}, expected {SCHEMA:?}", held.schema)));
        }
        let mut files = held.frames.iter().flat_map(|frame| &frame.files);
        match files.find(|file| !stays_inside(&file.file)) {
            Some(file) => Err(refused(format!("it lists `{}`, expected files of its folder", file.file))),
            None => Ok(Some(held)),
        }
    }
}

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
pub(super) fn document(finished: &Finished) -> Value {
    let Finished { job, run, items, fingerprint, frames, outputs, omissions } = finished;
    let stage = &job.stage;
    let view = &stage.view;
    json!({
        "schema": SCHEMA,
        "format": FORMAT,
        "fingerprint": fingerprint,
        "run_fingerprint": run.fingerprint,
        "program": job.program,
        "scenario": scenario_record(job),
        "references": job.inputs.references,
        "generator": "exact",
        "ground": GroundRecord::new(&job.scenario.ground, &stage.landscape),
        "scenery": SceneryRecord::new(stage),
        "view": ViewRecord::new(view),
        "planes": items.iter().map(|item| item.description(view.lines, view.columns)).collect::<Vec<_>>(),
        "conventions": {
            "pixel": "every value is that of the ray through the centre of its pixel",
            "rows": "index [line, column], from the top left",
            "frames": "counted at the update rate, whatever pictures the run keeps",
            "axes": "x north, y east, height above the lunoid; metres",
            "no_number": "no value is NaN",
        },
        "camera": camera(stage),
        "point": point(job),
        "error": ERROR,
        "not_in_it": NOT_IN_IT,
        "omissions": omissions.iter().map(omission).collect::<Vec<_>>(),
        "frames": frames,
        "outputs": outputs,
    })
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

/// How wrong the numbers may be; `docs/truth-format.md` says the same at length.
const ERROR: [&str; 6] = [
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
