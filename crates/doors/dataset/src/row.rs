//! A line of the manifest: a sample and its labels.

use std::collections::BTreeMap;

use replay::Entry;
use run_record::{FileRecord, stays_inside};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::Split;

/// A sample as the manifest has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Number of the sample.
    pub sample: u64,
    /// What the sample is for.
    pub split: Split,
    /// File of its arrays, with its hash.
    #[serde(flatten)]
    pub file: FileRecord,
    /// BLAKE3 of the pixels, as `run.json` has it.
    pub pixels_blake3: String,
    /// Lines and columns of the picture, and 3 behind them for colour.
    pub shape: Vec<usize>,
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the machine.
    pub machine: String,
    /// Name of the fault.
    pub fault: String,
    /// Keys that were drawn, with their values.
    pub drawn: BTreeMap<String, Value>,
    /// Frame whose time the sample has.
    pub frame: u64,
    /// Where the vehicle is, and how it looks.
    pub pose: PoseLabel,
    /// Azimuth and elevation of the sun (degrees).
    pub sun_deg: [f64; 2],
    /// Tangents of half the field of view, across and down.
    pub tan_half_field: [f64; 2],
    /// Mean code of the picture, 0..=255.
    pub mean_code: f64,
    /// Poses that were drawn and not taken, by the reason.
    pub refused: BTreeMap<String, u32>,
    /// Ground of this split and of others in the picture.
    pub ground: GroundSeen,
    /// Pixels of each label, where the plane `label` is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labels: Option<BTreeMap<String, u64>>,
    /// Counters that are asked for; one that the machine does not keep is missing.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub counts: BTreeMap<String, u64>,
    /// Pixels that differ from the picture of the healthy machine, where that is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changed: Option<u64>,
}

/// The pose of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PoseLabel {
    /// Seconds since the start of the scenario.
    pub time_s: f64,
    /// Eye, north of the origin (m).
    pub x_m: f64,
    /// Eye, east of the origin (m).
    pub y_m: f64,
    /// Eye above the tangent plane (m).
    pub z_m: f64,
    /// Clockwise from north (degrees).
    pub heading_deg: f64,
    /// Pitch, nose up (degrees).
    pub pitch_deg: f64,
    /// Roll, starboard down (degrees).
    pub roll_deg: f64,
    /// Angle by which the yoke turns the picture (degrees).
    pub yoke_deg: f64,
}

impl From<drive::EyePose> for PoseLabel {
    fn from(pose: drive::EyePose) -> Self {
        let drive::EyePose { time_s, eye_m: [x_m, y_m, z_m], heading_deg, pitch_deg, roll_deg, yoke_deg } =
            pose;
        Self { time_s, x_m, y_m, z_m, heading_deg, pitch_deg, roll_deg, yoke_deg }
    }
}

/// Whose ground a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct GroundSeen {
    /// Pixels with ground of the split of the sample.
    pub own: u64,
    /// Pixels with ground of another split.
    pub other: u64,
    /// Least ground range of the second (m); none without such a pixel.
    pub nearest_other_m: Option<f64>,
}

impl Entry for Row {
    fn fault(&self) -> Option<String> {
        (!stays_inside(&self.file.file))
            .then(|| format!("it lists `{}`, expected files of its folder", self.file.file))
    }
}
