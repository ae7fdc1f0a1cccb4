//! A tiny scene in a folder of its own, and a run of it.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use drive::{Drive, Wishes};
use picture::Depth;
use replay::{Control, HeldRun, Job, Phases, Pictures, RunFolder, TruthItems, run, write_truth};
use run_record::Program;

pub const SCENARIO: &str = include_str!("../scene.toml");

/// LUNSIM draws what its program could not.
pub const FREE: [(&str, &str); 1] = [("lunsim.restrictions", "false")];

/// A folder that is removed at the end, with a scenario in it.
pub struct Scene {
    pub folder: tempfile::TempDir,
    pub wishes: Wishes,
}

impl Scene {
    /// The tiny scene with `more` behind it, and keys over it.
    pub fn new(more: &str, set: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scene.toml"), format!("{SCENARIO}{more}")).unwrap();
        let set = set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
        Self { folder, wishes: Wishes { set, ..Wishes::default() } }
    }

    /// The same by a hardware model or a generator.
    pub fn by(self, machine: &str) -> Self {
        Self { wishes: Wishes { machine: Some(machine.into()), ..self.wishes }, ..self }
    }

    pub fn path(&self) -> PathBuf {
        self.folder.path().join("scene.toml")
    }

    pub fn drive(&self) -> Arc<Drive> {
        self.drive_with(0)
    }

    pub fn drive_with(&self, threads: usize) -> Arc<Drive> {
        let drive = Drive::open(&self.path(), &self.wishes, threads);
        Arc::new(drive.unwrap_or_else(|error| panic!("{error}")))
    }

    /// Hashes of the pixels as a run of `scenario` has them, and its folder; with `truth` of these items.
    pub fn run(&self, scenario: &Path, truth: Option<&str>) -> (Vec<String>, PathBuf) {
        let opened = front_door::open(scenario, &self.wishes).unwrap_or_else(|error| panic!("{error}"));
        let stage = opened.stage().unwrap_or_else(|error| panic!("{error}"));
        let pictures = Pictures {
            depth: Depth::Eight,
            colour: opened.generator.draws_colour(&stage),
            refresh: false,
            film: false,
        };
        let frames: Range<u64> = 0..opened.frames();
        let [name, version, commit, result_family] = ["lunoid", "0", "c", "unfused"].map(str::to_owned);
        let job = Job {
            program: Program { name, version, commit, result_family },
            inputs: opened.inputs.clone(),
            scenario: &opened.scenario,
            generator: Arc::clone(&opened.generator),
            stage,
            frames,
            pictures,
            check: 0,
            shard: None,
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let control = Control { pool: &pool, cancel: &AtomicBool::new(false), progress: &|_| () };
        let out = self.folder.path().join("run");
        let folder = RunFolder::claim(&out, true).unwrap();
        run(&job, &folder, &control, &mut Phases::since(Instant::now())).unwrap();
        if let Some(items) = truth {
            let items: TruthItems = items.parse().unwrap();
            write_truth(&job, &items, &folder, &control).unwrap();
        }
        let held = HeldRun::read(&out).unwrap();
        (held.frames.iter().map(|frame| frame.pixels_blake3.clone()).collect(), out)
    }
}
