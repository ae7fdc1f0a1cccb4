//! A small scene, its run, and the truth beside it.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use front_door::{Opened, Wishes, open};
use machine::MachineStage;
use picture::Depth;
use rayon::{ThreadPool, ThreadPoolBuilder};
use replay::{Control, Job, Phases, Pictures, Progress, RunFolder, TruthItems, run, write_truth};
use robot_log::{FinishedRun, LateWord, LateWords, LogError, Outcome, write_exr, write_mcap};
use run_record::Program;

/// What a test wants to be different.
pub struct Wish {
    pub machine: &'static str,
    pub set: Vec<(&'static str, &'static str)>,
    pub threads: usize,
    /// One picture for each showing of the display.
    pub refresh: bool,
    pub truth: &'static str,
    /// Told to end after so many frames of a log.
    pub cancel_after: Option<u64>,
}

impl Default for Wish {
    fn default() -> Self {
        Self { machine: "ideal", set: vec![], threads: 2, refresh: false, truth: "all", cancel_after: None }
    }
}

/// A finished run in a folder of its own.
pub struct Made {
    folder: tempfile::TempDir,
    opened: Opened,
    stage: MachineStage,
    wish: Wish,
    pool: ThreadPool,
}

impl Made {
    /// Draws the scene as `wish` says.
    pub fn new(wish: Wish) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/logs/scene.toml");
        let set = wish.set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
        let wishes = Wishes { machine: Some(wish.machine.into()), set, ..Wishes::default() };
        let opened = open(&path, &wishes).expect("the scene");
        let stage = opened.machine_stage().expect("its ground");
        let pool = ThreadPoolBuilder::new().num_threads(wish.threads).build().expect("threads");
        let made = Self { folder: tempfile::tempdir().expect("a folder"), opened, stage, wish, pool };
        made.with(None, |job, folder, control| {
            run(job, folder, control, &mut Phases::since(Instant::now())).expect("drawn");
            write_truth(job, &made.truth(), folder, control).expect("its truth");
        });
        made
    }

    /// Path of the run folder.
    pub fn path(&self) -> PathBuf {
        self.folder.path().join("run")
    }

    /// Path of a file beside the run folder.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The truth that was asked for.
    fn truth(&self) -> TruthItems {
        self.wish.truth.parse().expect("a list")
    }

    /// Writes the robot log.
    pub fn write_log(&self, file: &Path) -> Result<Outcome, LogError> {
        self.with(self.wish.cancel_after, |job, folder, control| {
            let items = self.truth();
            let run = FinishedRun::read(job, folder, Some(&items))?;
            let late = self.opened.is_machine().then(|| LateWords::new(self.stage.clone()));
            write_mcap(&run, late.as_ref(), file, control)
        })
    }

    /// Late words of every frame.
    pub fn late_words(&self) -> Vec<Vec<LateWord>> {
        let late = LateWords::new(self.stage.clone());
        self.with(None, |job, _, _| {
            let poses = job.poses(job.frames.clone()).expect("a path");
            poses.rows().iter().map(|row| late.of(row).expect("a frame")).collect()
        })
    }

    /// Writes the OpenEXR files.
    pub fn exr(&self) -> Result<Outcome, LogError> {
        self.with(self.wish.cancel_after, |job, folder, control| {
            let items = self.truth();
            write_exr(&FinishedRun::read(job, folder, Some(&items))?, control)
        })
    }

    fn with<T>(&self, cancel_after: Option<u64>, act: impl FnOnce(&Job, &RunFolder, &Control) -> T) -> T {
        let cancel = AtomicBool::new(false);
        let progress = |progress| {
            if let Progress::Frame { done } = progress {
                cancel.fetch_or(cancel_after.is_some_and(|after| done >= after), Ordering::Relaxed);
            }
        };
        let folder = RunFolder::claim(&self.path(), false).expect("the folder");
        let control = Control { pool: &self.pool, cancel: &cancel, progress: &progress };
        let job = Job {
            program: Program {
                name: "lunoid".into(),
                version: "0.1.0".into(),
                commit: "unknown".into(),
                result_family: "unfused".into(),
            },
            inputs: self.opened.inputs.clone(),
            scenario: &self.opened.scenario,
            generator: Arc::clone(&self.opened.generator),
            stage: self.stage.stage(),
            frames: 0..self.opened.frames(),
            shard: None,
            pictures: Pictures {
                depth: Depth::Eight,
                colour: false,
                refresh: self.wish.refresh,
                film: false,
            },
            check: 0,
        };
        act(&job, &folder, &control)
    }
}
