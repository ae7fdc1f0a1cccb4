//! `run.json`: what was drawn from what.

use std::path::Path;

use files::FileError;
use generator::FrameCounts;
use limits::Limit;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::{
    ChannelRecord, FileRecord, FrameRecord, GroundRecord, LimitRecord, ModelRecord, OmissionRecord,
    PathRecord, SceneryRecord, ShardRecord, SkyRecord, SunRecord, VehicleRecord, ViewRecord,
    frame::fault_of_files, is_as_sealed, sealed,
};

/// Schema of the record.
pub const RUN_SCHEMA: &str = "lunoid.run/2";

/// Version of the format within the schema. From 2 on a record ends with its seal.
pub const RUN_FORMAT: u32 = 2;

/// Why a record cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file is no record.
    #[error("{0}")]
    Content(String),
}

/// The record of a run, in the order in which it is read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunRecord {
    /// Name of the schema: [`RUN_SCHEMA`].
    pub schema: String,
    /// Version of the format within its schema: [`RUN_FORMAT`], or 1 of a record without a seal.
    pub format: u32,
    /// BLAKE3 of everything that decides the pixels, hexadecimal.
    pub fingerprint: String,
    /// The program that drew.
    pub program: Program,
    /// Scenario that was drawn.
    pub scenario: ScenarioRecord,
    /// Files that the scenario refers to.
    pub references: Vec<FileRecord>,
    /// Name of the generator: "hybrid", or that of its row in the registry.
    pub generator: String,
    /// Word for one line of the generator's signals, as "sweep"; nothing where it has no signals.
    pub line: Option<String>,
    /// Hardware model with all its values.
    pub model: ModelRecord,
    /// Ground of the run, with the hash of its words.
    pub ground: GroundRecord,
    /// What lies and stands on it.
    pub scenery: SceneryRecord,
    /// The sun at the start of the mission.
    pub sun: SunRecord,
    /// Sun and Earth at the start of a mission with a date.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sky: Option<SkyRecord>,
    /// Size and limits of the vehicle.
    pub vehicle: VehicleRecord,
    /// Path that the vehicle takes.
    pub path: PathRecord,
    /// Channel that is looked through, where the run has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub channel: Option<ChannelRecord>,
    /// What was asked of every picture.
    pub view: ViewRecord,
    /// The generator's own settings; of the hybrid machine a [`MachineRecord`](hardware_model::MachineRecord).
    pub settings: Value,
    /// How frames became files.
    pub pictures: PicturesRecord,
    /// What was left out.
    pub omissions: Vec<OmissionRecord>,
    /// Where the vehicle does more than it can.
    pub limits: Vec<LimitRecord>,
    /// First frame, and the frame behind the last.
    pub range: [u64; 2],
    /// The part of a larger run that this run is, where a worker drew it as a shard.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shard: Option<ShardRecord>,
    /// Work of all frames.
    pub totals: FrameCounts,
    /// Error against the judge, where sweeps of the run have been checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub check: Option<CheckRecord>,
    /// Records of the frames, ascending.
    pub frames: Vec<FrameRecord>,
    /// Other files that follow from the inputs.
    pub outputs: Vec<FileRecord>,
}

/// The program that drew.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Program {
    /// Name of the program.
    pub name: String,
    /// Version of the program.
    pub version: String,
    /// Commit of the program, or "unknown".
    pub commit: String,
    /// Result family: runs of one family are equal to the bit.
    pub result_family: String,
}

/// The scenario by name and hash.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScenarioRecord {
    /// Its file, if it came from one.
    pub file: Option<FileRecord>,
    /// Title of the scenario.
    pub title: String,
    /// What the scenario shows, in words.
    pub shows: String,
}

/// How frames became files.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PicturesRecord {
    /// Kind of picture: "grey PNG" or "RGB PNG".
    pub kind: String,
    /// Bits of a channel.
    pub depth: u32,
    /// Clock that each file belongs to: "update" or "refresh".
    pub one_file_for_each: String,
}

/// Error of a run against the judge, from some of its sweeps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckRecord {
    /// Name of the judge.
    pub against: String,
    /// Sweeps that were checked.
    pub sweeps: u32,
    /// Confidence of the intervals, 0..1.
    pub confidence: f64,
    /// How they were found.
    pub interval_by: String,
    /// Errors over all of these sweeps.
    pub errors: Vec<ErrorRecord>,
    /// Errors sweep by sweep.
    pub checked: Vec<CheckedSweep>,
}

/// One error over all sweeps that were checked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ErrorRecord {
    /// Name of what is off.
    pub error: String,
    /// Unit of the error.
    pub unit: String,
    /// Root of the mean over the sweeps of the mean squared difference.
    pub rms: f64,
    /// Where that of all sweeps of the run lies; `None` of a single sweep.
    pub interval: Option<[f64; 2]>,
    /// Largest difference over all checked sweeps.
    pub max: f64,
}

/// What was found of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckedSweep {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Sweep, from 0 at the left.
    pub sweep: u32,
    /// Column of the picture at its place.
    pub column: usize,
    /// Root of the mean squared difference, and the largest, of picture, height, slope and reflectivity; `None` where
    /// there was nothing to compare.
    pub rms_and_max: [Option<[f64; 2]>; 4],
}

impl RunRecord {
    /// The record in the file at `path`.
    ///
    /// # Errors
    /// If the file cannot be read, is no record of this schema, or leads out of its folder.
    pub fn read(path: &Path) -> Result<Self, RecordError> {
        Self::parse(&files::read_all(path, Limit::RecordBytes)?)
    }

    /// The record in `bytes`.
    ///
    /// # Errors
    /// If they are no record of this schema, or lead out of the record's folder.
    pub fn parse(bytes: &[u8]) -> Result<Self, RecordError> {
        let refused = |error: serde_json::Error| RecordError::Content(error.to_string());
        let Schema { schema } = serde_json::from_slice(bytes).map_err(refused)?;
        if schema != RUN_SCHEMA {
            return Err(RecordError::Content(format!("schema {schema:?}, expected {RUN_SCHEMA:?}")));
        }
        let record: Self = serde_json::from_slice(bytes).map_err(refused)?;
        record.expect_sealed(bytes).map_err(RecordError::Content)?;
        let fault = record.frames.iter().find_map(FrameRecord::fault);
        if let Some(fault) = fault.or_else(|| fault_of_files(&record.outputs)) {
            return Err(RecordError::Content(fault));
        }
        record.expect_frames_in_a_row().map_err(RecordError::Content)?;
        Ok(record)
    }

    /// Names of the files of the run's folder that it lists.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        let files = self.frames.iter().flat_map(|frame| &frame.files).chain(&self.outputs);
        files.map(|listed| listed.file.as_str())
    }

    /// The document with its seal, ending with a newline.
    pub fn text(&self) -> String {
        sealed(&serde_json::to_string_pretty(self).expect("records are plain values"))
    }

    /// The record is as it was written.
    fn expect_sealed(&self, bytes: &[u8]) -> Result<(), String> {
        let is_whole = || str::from_utf8(bytes).is_ok_and(is_as_sealed);
        match self.format {
            1 => Ok(()),
            RUN_FORMAT if is_whole() => Ok(()),
            RUN_FORMAT => {
                Err("it was changed since it was written: its `seal` is not the hash of the lines above"
                    .into())
            }
            other => Err(format!("format {other}, expected 1 to {RUN_FORMAT}")),
        }
    }

    /// The frames are those of the range, each once: whoever reads the record counts on it.
    fn expect_frames_in_a_row(&self) -> Result<(), String> {
        let [start, end] = self.range;
        let expected = || format!("expected frames {start}..{end}, each once and ascending");
        let number = |at: usize| start.checked_add(at as u64);
        let odd = self.frames.iter().enumerate().find(|(at, frame)| Some(frame.frame) != number(*at));
        match odd {
            Some((at, frame)) => {
                let number = number(at).unwrap_or(u64::MAX);
                Err(format!("it lists frame {} in place of frame {number}; {}", frame.frame, expected()))
            }
            None if start.checked_add(self.frames.len() as u64) != Some(end) => {
                Err(format!("it lists {} frames; {}", self.frames.len(), expected()))
            }
            None => Ok(()),
        }
    }
}

/// What is asked of a document before all else.
#[derive(Deserialize)]
struct Schema {
    schema: String,
}
