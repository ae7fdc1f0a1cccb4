//! `dataset.json`: what a data set was made from, and what its files hold.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use front_door::open;
use limits::Limit;
use replay::Fingerprint;
use run_record::{FileRecord, Program, hash, is_as_sealed, sealed};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::folder::{MANIFEST, RECORD};
use crate::plan::{KeyDraw, Plan};
use crate::row::Row;
use crate::{DatasetError, Split};

/// Schema of the record.
pub const SCHEMA: &str = "lunoid.dataset/1";

/// The record of a data set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Schema of the record: [`SCHEMA`].
    pub schema: String,
    /// Samples of the folder: the first, and the end.
    pub samples: [u64; 2],
    /// Number of samples of the plan.
    pub of: u64,
    /// Everything that decides a sample: program, plan and files.
    pub made_from: MadeFrom,
    /// The plan in its values.
    pub plan: PlanRecord,
    /// The arrays of a sample, each with its meaning.
    pub arrays: Vec<Value>,
    /// Files beside the samples.
    pub outputs: Vec<FileRecord>,
}

/// What decides a sample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MadeFrom {
    /// The program that drew.
    pub program: Program,
    /// The plan by the name of its file: a folder does not depend on where the plan lies.
    pub plan: FileRecord,
    /// Files that scenarios and machines are read from; paths from the folder of the plan.
    pub files: Vec<FileRecord>,
}

/// The plan in its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanRecord {
    /// Title of the data set.
    pub title: String,
    /// What it is for.
    pub about: String,
    /// Licence of the samples.
    pub licence: String,
    /// Seed of all draws.
    pub seed: u64,
    /// Names of the scenarios.
    pub scenarios: Vec<String>,
    /// Names of the machines.
    pub machines: Vec<String>,
    /// Names of faults, each with its overlay and the keys that are drawn.
    pub faults: BTreeMap<String, Value>,
    /// Keys that all samples have set.
    pub set: BTreeMap<String, String>,
    /// Quantities that are drawn, each with its range in words.
    pub drawn: BTreeMap<String, String>,
    /// Side of a block of ground (m).
    pub block_m: f64,
    /// Distance within which all ground is of the split of the sample (m).
    pub reach_m: f64,
    /// Share of each split.
    pub shares: BTreeMap<String, f64>,
}

impl MadeFrom {
    /// What decides the samples of `plan`, drawn by `program`.
    ///
    /// # Errors
    /// If a file that the plan names cannot be read.
    pub fn of(plan: &Plan, program: Program) -> Result<Self, DatasetError> {
        let mut files = BTreeMap::new();
        // The first samples have every combination.
        for wanted in (0..plan.combinations()).map(|sample| plan.wanted(sample)) {
            let scenario = plan.file(&plan.scenarios[wanted.of.scenario]);
            let inputs = open(&scenario, &plan.wishes(wanted.of, &wanted.drawn, false))?.inputs;
            let all = inputs.scenario.into_iter().chain(inputs.references).chain(inputs.model_files);
            files.extend(all.map(|record| (record.file, record.blake3)));
        }
        let inside = |file: String| {
            let path = PathBuf::from(&file);
            path.strip_prefix(plan.folder()).map_or(file, |inside| inside.display().to_string())
        };
        let files = files.into_iter().map(|(file, blake3)| FileRecord { file: inside(file), blake3 });
        let name = plan.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let plan = FileRecord { file: name, blake3: hash(&plan.text) };
        Ok(Self { program, plan, files: files.collect() })
    }

    /// The same with the samples `samples`, as a journal has it.
    pub(crate) fn fingerprint(&self, samples: &Range<u64>) -> Fingerprint {
        let mut document = json!(self);
        document["samples"] = json!([samples.start, samples.end]);
        Fingerprint::new(document)
    }
}

impl PlanRecord {
    /// The values of `plan`.
    pub fn of(plan: &Plan) -> Self {
        let words = |keys: &[KeyDraw]| -> BTreeMap<String, String> {
            keys.iter().map(|key| (key.key.clone(), key.draw.words())).collect()
        };
        let fault = |fault: &crate::Fault| {
            (fault.name.clone(), json!({ "overlay": fault.overlay, "drawn": words(&fault.keys) }))
        };
        let mut drawn = words(&plan.keys);
        let pose = &plan.pose;
        let ends = |[low, high]: [f64; 2]| format!("{low} to {high}");
        drawn.insert("x_m".into(), ends(pose.x_m));
        drawn.insert("y_m".into(), ends(pose.y_m));
        drawn.insert("heading_deg".into(), ends(pose.heading_deg));
        drawn.insert("frame".into(), format!("whole, {} to {}", pose.frames[0], pose.frames[1]));
        if let Some(flight) = &pose.flight {
            drawn.insert("z_m".into(), ends(flight.z_m));
            drawn.insert("pitch_deg".into(), ends(flight.pitch_deg));
            drawn.insert("roll_deg".into(), ends(flight.roll_deg));
        }
        let shares = Split::ALL.iter().zip(plan.splits.shares);
        let scenario = |file: &String| crate::check::stem(file).unwrap_or_default().to_owned();
        Self {
            title: plan.title.clone(),
            about: plan.about.clone(),
            licence: plan.licence.clone(),
            seed: plan.seed,
            scenarios: plan.scenarios.iter().map(scenario).collect(),
            machines: plan.machines.clone(),
            faults: plan.faults.iter().map(fault).collect(),
            set: plan.set.iter().cloned().collect(),
            drawn,
            block_m: plan.splits.block_m,
            reach_m: plan.splits.reach_m,
            shares: shares.map(|(split, share)| (split.name().to_owned(), share)).collect(),
        }
    }
}

impl Record {
    /// The record in `folder`; `None` if it has none.
    ///
    /// # Errors
    /// If it cannot be read, or is not as it was sealed.
    pub fn read(folder: &Path) -> Result<Option<Self>, DatasetError> {
        let path = folder.join(RECORD);
        if !path.exists() {
            return Ok(None);
        }
        let bytes = files::read_all(&path, Limit::RecordBytes)?;
        let refuse = |reason: String| DatasetError::Record { path: path.clone(), reason };
        let text = String::from_utf8(bytes).map_err(|error| refuse(error.to_string()))?;
        if !is_as_sealed(&text) {
            return Err(refuse("not as it was sealed: somebody changed it; make the data set anew".into()));
        }
        let record: Self = serde_json::from_str(&text).map_err(|error| refuse(error.to_string()))?;
        match record.schema == SCHEMA {
            true => Ok(Some(record)),
            false => Err(refuse(format!("schema {:?}, expected {SCHEMA:?}", record.schema))),
        }
    }

    /// The lines of the manifest in `folder`, which are as the record lists them.
    ///
    /// # Errors
    /// If the manifest is gone, cannot be read, or is another one.
    pub fn rows(&self, folder: &Path) -> Result<Vec<Row>, DatasetError> {
        let path = folder.join(MANIFEST);
        let refuse = |reason: String| DatasetError::Record { path: path.clone(), reason };
        if !path.exists() {
            return Err(refuse("this file is gone; make the data set again, by the same command".into()));
        }
        let bytes = files::read_all(&path, Limit::RecordBytes)?;
        let is_listed = self.outputs.iter().any(|file| file.file == MANIFEST && file.blake3 == hash(&bytes));
        if !is_listed {
            return Err(refuse(format!("not what {RECORD} lists; make the data set anew")));
        }
        let lines = bytes.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
        let rows: Result<Vec<Row>, _> = lines.map(serde_json::from_slice).collect();
        let rows = rows.map_err(|error| refuse(error.to_string()))?;
        match rows.iter().find_map(replay::Entry::fault) {
            Some(fault) => Err(refuse(fault)),
            None => Ok(rows),
        }
    }

    /// The text of the file.
    pub(crate) fn text(&self) -> String {
        sealed(&(serde_json::to_string_pretty(self).expect("records are plain values") + "\n"))
    }
}
