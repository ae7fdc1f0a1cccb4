//! `truth.json`: which arrays there are, and what their numbers mean.

use std::path::Path;

use limits::Limit;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::{
    FileRecord, GroundRecord, OmissionRecord, Program, RecordError, ScenarioRecord, SceneryRecord,
    ViewRecord, frame::fault_of_files,
};

/// Schema of the record.
pub const TRUTH_SCHEMA: &str = "lunoid.truth/1";

/// The record of the truth of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TruthRecord {
    /// Name of the schema: [`TRUTH_SCHEMA`].
    pub schema: String,
    /// Version of the format of arrays and record.
    pub format: u32,
    /// BLAKE3 of everything that decides the arrays, hexadecimal.
    pub fingerprint: String,
    /// Fingerprint of the run.
    pub run_fingerprint: String,
    /// The program that drew.
    pub program: Program,
    /// Scenario that was drawn.
    pub scenario: ScenarioRecord,
    /// Files that the scenario refers to.
    pub references: Vec<FileRecord>,
    /// Name of the generator.
    pub generator: String,
    /// Ground of the run, with the hash of its words.
    pub ground: GroundRecord,
    /// What lies and stands on it.
    pub scenery: SceneryRecord,
    /// What was asked of every picture.
    pub view: ViewRecord,
    /// Arrays, each with its meaning.
    pub planes: Vec<Value>,
    /// Conventions of pixels, rows, frames and axes, by name.
    pub conventions: Value,
    /// Where a pixel looks.
    pub camera: Value,
    /// From a pixel, its range and the pose to a point of the landscape.
    pub point: Value,
    /// How wrong the numbers may be.
    pub error: Vec<String>,
    /// What the truth leaves out.
    pub not_in_it: Vec<String>,
    /// What was left out of the scene.
    pub omissions: Vec<OmissionRecord>,
    /// Records of the frames, ascending.
    pub frames: Vec<TruthFrame>,
    /// Other files of the truth.
    pub outputs: Vec<FileRecord>,
}

/// One frame of the truth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TruthFrame {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Seconds since the start of the mission.
    pub time_s: f64,
    /// From the folder of the truth; none where only poses were asked for.
    pub files: Vec<FileRecord>,
}

impl TruthRecord {
    /// The record in the file at `path`.
    ///
    /// # Errors
    /// If the file cannot be read, is no record of this schema, or leads out of its folder.
    pub fn read(path: &Path) -> Result<Self, RecordError> {
        let bytes = files::read_all(path, Limit::RecordBytes)?;
        let refused = |error: serde_json::Error| RecordError::Content(error.to_string());
        let record: Self = serde_json::from_slice(&bytes).map_err(refused)?;
        if record.schema != TRUTH_SCHEMA {
            let text = format!("schema {:?}, expected {TRUTH_SCHEMA:?}", record.schema);
            return Err(RecordError::Content(text));
        }
        match record.frames.iter().find_map(TruthFrame::fault) {
            Some(fault) => Err(RecordError::Content(fault)),
            None => Ok(record),
        }
    }

    /// Names of the files that it lists, from the folder of the truth.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        let files = self.frames.iter().flat_map(|frame| &frame.files).chain(&self.outputs);
        files.map(|listed| listed.file.as_str())
    }
}

impl TruthFrame {
    /// What no run can have written of a frame, in words: a file that leads out of the folder.
    pub fn fault(&self) -> Option<String> {
        fault_of_files(&self.files)
    }
}
