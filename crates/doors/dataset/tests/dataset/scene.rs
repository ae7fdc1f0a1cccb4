//! A tiny scene with a plan in a folder of its own, and data sets of it.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use dataset::{DataFolder, DatasetError, Job, Outcome, Plan, Record, Row, run};
use replay::{Control, Progress};
use run_record::Program;

const SCENARIO: &str = include_str!("../../../drive/tests/scene.toml");

/// Two faults and a healthy machine on small blocks of the tiny scene.
pub const PLAN: &str = r#"format = 1
title = "Tiny"
about = "Nothing but a test."
licence = "CC0-1.0"
seed = 7
draws = 3
scenarios = ["scene.toml"]
machines = ["ideal"]
truth = ["range", "label"]
counters = ["late_words"]
compare = true
set = ["scenario.raster.columns=40", "scenario.raster.lines=30"]

[draw.number]
"scenario.sun.azimuth_deg" = [0, 360]
"scenario.sun.elevation_deg" = [10, 40]

[pose]
x_m = [20, 380]
y_m = [20, 380]
heading_deg = [0, 360]

[splits]
block_m = 80
reach_m = 15
train = 0.5
validation = 0.25
test = 0.25

[[fault]]
name = "none"

[[fault]]
name = "tear"
number = { "loader.access_ns" = [3000, 9000] }

[[fault]]
name = "coarse"
overlay = "coarse"
"#;

/// A folder that is removed at the end, with scenario and plan in it.
pub struct Scene {
    pub folder: tempfile::TempDir,
}

impl Scene {
    /// The tiny scene with the plan `text`.
    pub fn new(text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scene.toml"), SCENARIO).unwrap();
        fs::write(folder.path().join("plan.toml"), text).unwrap();
        Self { folder }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn plan(&self) -> Plan {
        Plan::read(&self.path("plan.toml")).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The samples `samples` in the folder `out`, by two threads.
    pub fn make(&self, out: &str, samples: Range<u64>) -> Result<Outcome, DatasetError> {
        self.make_until(out, samples, u64::MAX)
    }

    /// The same, told to end when `most` samples are there.
    pub fn make_until(&self, out: &str, samples: Range<u64>, most: u64) -> Result<Outcome, DatasetError> {
        let plan = self.plan();
        let folder = DataFolder::claim(&self.path(out))?;
        let job = Job { plan: &plan, program: program(), samples };
        control(most, |control| run(&job, &folder, control))
    }

    /// All samples in the folder `out`.
    pub fn make_all(&self, out: &str) -> PathBuf {
        let all = 0..self.plan().samples();
        self.make(out, all).unwrap_or_else(|error| panic!("{error}"));
        self.path(out)
    }
}

pub fn program() -> Program {
    let [name, version, commit, result_family] = ["lunoid", "0", "c", "unfused"].map(str::to_owned);
    Program { name, version, commit, result_family }
}

/// Two threads, which are told to end when `most` samples are there.
pub fn control<T>(most: u64, work: impl FnOnce(&Control) -> T) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let cancel = AtomicBool::new(false);
    let progress = |progress| {
        if matches!(progress, Progress::Frame { done } if done >= most) {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    work(&Control { pool: &pool, cancel: &cancel, progress: &progress })
}

/// Every file of a folder, by its path from there, but for locks.
pub fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        if path.is_dir() {
            all.extend(files(&path).into_iter().map(|(below, bytes)| (format!("{name}/{below}"), bytes)));
        } else if !name.contains("lock") {
            all.insert(name, fs::read(&path).unwrap());
        }
    }
    all
}

/// The rows of a finished folder.
pub fn rows(folder: &Path) -> Vec<Row> {
    Record::read(folder).unwrap().expect("a record").rows(folder).unwrap()
}
