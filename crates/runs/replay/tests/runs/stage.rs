//! A tiny scene and a way to run it.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use control_plane::MachineStage;
use hardware_model::{HardwareModel, Settings};
use machine::HybridMachine;
use picture::Depth;
use replay::{Control, HeldRun, Job, Outcome, Phases, Pictures, Progress, ReplayError, RunFolder, run};
use run_record::{Inputs, Program};
use scenario::Scenario;
use serde_json::Value;

pub const SCENARIO: &str = r#"
format = 1
title = "A bump <ahead>"
shows = "Nothing but a test."
frames = 12

[landscape.generated]
seed = 3
extent_m = [400, 400]
region_size_m = 50
[landscape.generated.undulation]
rms_height_m = 2
hurst = 0.9
longest_m = 300
shortest_m = 160
waves = 20

[sun]
azimuth_deg = 100
elevation_deg = 15

[path]
keyframes = [
  { t_s = 0, x_m = 100, y_m = 200 },
  { t_s = 5, x_m = 108, y_m = 205 },
]

[raster]
sweeps = 40
samples_per_sweep = 80
update_hz = 10
refresh_hz = 30

[range]
programme = "geometric"
start_m = 2
end_m = 300
"#;

/// What a test wants to be different.
#[derive(Clone)]
pub struct Wish {
    pub frames: Range<u64>,
    pub pictures: Pictures,
    pub threads: usize,
    pub scenario: String,
    pub fresh: bool,
    /// Cancel after so many frames.
    pub cancel_after: Option<u64>,
    /// A folder that comes in the way of a file when drawing begins.
    pub blocked: Option<&'static str>,
    /// Sweeps to be checked.
    pub check: u32,
    /// Shades of grey in the video, which is without noise if there is no number.
    pub grey: Option<u32>,
}

impl Default for Wish {
    fn default() -> Self {
        let pictures = Pictures { depth: Depth::Eight, colour: false, refresh: false, film: false };
        Self {
            frames: 0..12,
            pictures,
            threads: 2,
            scenario: SCENARIO.into(),
            fresh: false,
            cancel_after: None,
            blocked: None,
            check: 0,
            grey: None,
        }
    }
}

impl Wish {
    pub fn in_place_of(self, old: &str, new: &str) -> Self {
        assert!(self.scenario.contains(old));
        Self { scenario: self.scenario.replace(old, new), ..self }
    }

    pub fn run(&self, out: &Path) -> Result<Outcome, ReplayError> {
        let folder = RunFolder::claim(out, self.fresh)?;
        self.run_in(&folder)
    }

    pub fn run_in(&self, folder: &RunFolder) -> Result<Outcome, ReplayError> {
        self.run_after(folder, &mut Phases::since(Instant::now()))
    }

    /// The run as a part of a command that has done `phases` before.
    pub fn run_after(&self, folder: &RunFolder, phases: &mut Phases) -> Result<Outcome, ReplayError> {
        let scenario = Scenario::parse("test.toml", &self.scenario).expect("the scenario is right");
        let mut settings = settings(&scenario);
        settings.analog.memory.grey = self.grey;
        let generator = Arc::new(HybridMachine::new(settings));
        let job = Job { check: self.check, generator, ..job(&scenario, self.frames.clone(), self.pictures) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads).build().expect("threads");
        let cancel = AtomicBool::new(self.cancel_after == Some(0));
        let progress = |progress| {
            if let (Progress::Begins { .. }, Some(name)) = (progress, self.blocked) {
                fs::create_dir_all(folder.path().join(name)).expect("a folder");
            }
            if let (Progress::Frame { done }, Some(after)) = (progress, self.cancel_after)
                && done >= after
            {
                cancel.store(true, Ordering::Relaxed);
            }
        };
        let control = Control { pool: &pool, cancel: &cancel, progress: &progress };
        run(&job, folder, &control, phases)
    }
}

/// A job for the machine, ideal parts.
pub fn job(scenario: &Scenario, frames: Range<u64>, pictures: Pictures) -> Job<'_> {
    let [name, version, commit, result_family] = ["lunoid", "0", "c", "unfused"].map(str::to_owned);
    Job {
        program: Program { name, version, commit, result_family },
        inputs: Inputs { model: "ideal".into(), ..Inputs::default() },
        scenario,
        generator: Arc::new(HybridMachine::new(settings(scenario))),
        stage: stage(scenario).stage(),
        frames,
        shard: None,
        pictures,
        check: 0,
    }
}

pub fn stage(scenario: &Scenario) -> MachineStage {
    front_door::build(scenario, settings(scenario)).expect("a stage")
}

pub fn settings(scenario: &Scenario) -> Settings {
    front_door::settings(scenario, &HardwareModel::ideal()).expect("settings")
}

/// Every file of a folder but the wall times.
pub fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for (prefix, folder) in [("", folder.to_owned()), ("frames/", folder.join("frames"))] {
        for entry in fs::read_dir(folder).expect("a folder") {
            let entry = entry.expect("an entry");
            let name = entry.file_name().to_string_lossy().into_owned();
            if entry.path().is_file() && name != "performance.json" {
                found.insert(format!("{prefix}{name}"), fs::read(entry.path()).expect("a file"));
            }
        }
    }
    found
}

/// Names of the files that differ.
pub fn differences(a: &Path, b: &Path) -> Vec<String> {
    let (a, b) = (content(a), content(b));
    let names: std::collections::BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    names.into_iter().filter(|name| a.get(*name) != b.get(*name)).cloned().collect()
}

/// The record of a run as a document.
pub fn document(run: &HeldRun) -> Value {
    serde_json::to_value(&**run).expect("records are plain values")
}
