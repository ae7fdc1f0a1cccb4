//! A mission that is drawn whole or in shards.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};
use std::time::Instant;

use front_door::{Opened, Wishes, open};
use generator::Stage;
use merge::{Joined, Merge, MergeError, Outcome, merge};
use picture::Depth;
use rayon::ThreadPool;
use replay::{Control, Job, Phases, Pictures, Progress, RunFolder, TruthItems, run, write_truth};
use run_record::{Program, ShardRecord};
use shard::{Shard, block_by_count};

/// How frames become files where nothing else is asked for.
pub const GREY: Pictures = Pictures { depth: Depth::Eight, colour: false, refresh: false, film: false };

/// Shadow boundaries of all drives, so that a whole run and its shards find them once. What an earlier run of the tests left is removed.
static SHADOWS: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("joins-shadows");
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("a folder of these tests");
    }
    folder
});

/// A scenario of the repository, its ground made once.
pub struct Drive {
    pub opened: Opened,
    pub stage: Stage,
    pub pool: ThreadPool,
    /// Frames of the whole run.
    pub frames: Range<u64>,
    pub pictures: Pictures,
    pub truth: Option<TruthItems>,
    /// Commit of the program that draws.
    pub commit: String,
}

impl Drive {
    /// The scenario `name` with a raster of 24 sweeps and 40 samples, drawn by `machine`.
    pub fn new(name: &str, machine: Option<&str>, frames: Range<u64>) -> Self {
        let wishes = Wishes {
            machine: machine.map(str::to_owned),
            sweeps: Some(24),
            samples: Some(40),
            ..Wishes::default()
        };
        Self::with(name, &wishes, frames)
    }

    /// The scenario `name` with these wishes.
    pub fn with(name: &str, wishes: &Wishes, frames: Range<u64>) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
        let file = root.join(format!("scenarios/{name}.toml"));
        let wishes = Wishes { shadow_cache: Some(SHADOWS.clone()), ..wishes.clone() };
        let opened = open(&file, &wishes).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(frames.end <= opened.frames(), "{name} has {} frames", opened.frames());
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
        let stage = pool.install(|| opened.stage()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let pictures = Pictures { colour: opened.generator.draws_colour(&stage), ..GREY };
        Self { opened, stage, pool, frames, pictures, truth: None, commit: "c".into() }
    }

    /// Draws `frames` into `out`.
    pub fn draw(&self, frames: Range<u64>, shard: Option<ShardRecord>, out: &Path) {
        let [name, version, result_family] = ["lunoid", "0", "unfused"].map(str::to_owned);
        let job = Job {
            program: Program { name, version, commit: self.commit.clone(), result_family },
            inputs: self.opened.inputs.clone(),
            scenario: &self.opened.scenario,
            generator: Arc::clone(&self.opened.generator),
            stage: self.stage.clone(),
            frames,
            shard,
            pictures: self.pictures,
            check: 0,
        };
        let cancel = AtomicBool::new(false);
        let control = Control { pool: &self.pool, cancel: &cancel, progress: &|_| () };
        let folder = RunFolder::claim(out, false).expect("a folder");
        run(&job, &folder, &control, &mut Phases::since(Instant::now())).expect("drawn");
        if let Some(items) = &self.truth {
            write_truth(&job, items, &folder, &control).expect("truth");
        }
    }

    /// Draws the whole run into `out`.
    pub fn whole(&self, out: &Path) {
        self.draw(self.frames.clone(), None, out);
    }

    /// Draws shard `number` of `of` into `out`.
    pub fn shard(&self, number: u32, of: u32, out: &Path) {
        let shard = Shard::new(number, of).expect("a shard");
        let block = block_by_count(shard, &self.frames).expect("a block");
        let record = ShardRecord {
            shard: shard.to_string(),
            by: "count".into(),
            of: [self.frames.start, self.frames.end],
            words: vec!["a.toml".into(), "--machine".into(), "m".into()],
        };
        self.draw(block, Some(record), out);
    }

    /// Draws all shards of `of` below `at`, and returns their folders.
    pub fn shards(&self, of: u32, at: &Path) -> Vec<PathBuf> {
        let folder = |number: u32| at.join(format!("{number}-of-{of}"));
        (1..=of).for_each(|number| self.shard(number, of, &folder(number)));
        (1..=of).map(folder).collect()
    }
}

/// Joins `folders` into `out`.
pub fn join(folders: &[PathBuf], out: &Path) -> Result<Outcome, MergeError> {
    join_frames(folders, None, out)
}

/// The same, where the frames of the whole run are stated.
pub fn join_frames(
    folders: &[PathBuf],
    frames: Option<&Range<u64>>,
    out: &Path,
) -> Result<Outcome, MergeError> {
    join_until(folders, frames, out, u64::MAX)
}

/// The same, told to end after `most` frames.
pub fn join_until(
    folders: &[PathBuf],
    frames: Option<&Range<u64>>,
    out: &Path,
    most: u64,
) -> Result<Outcome, MergeError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
    let cancel = AtomicBool::new(false);
    let progress = |progress| {
        if matches!(progress, Progress::Frame { done } if done >= most) {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let control = Control { pool: &pool, cancel: &cancel, progress: &progress };
    let folder = RunFolder::claim(out, false)?;
    merge(Merge { folders, frames }, &folder, &control)
}

/// Joins folders that are known to be whole.
pub fn joined(folders: &[PathBuf], out: &Path) -> Joined {
    match join(folders, out) {
        Ok(Outcome::Joined(joined)) => joined,
        other => panic!("{other:?}"),
    }
}

/// Why folders are not joined. Nothing is left at `out`.
pub fn refused(folders: &[PathBuf], out: &Path) -> String {
    let said = join(folders, out).expect_err("refused").to_string();
    assert!(!out.exists(), "{} is there", out.display());
    said
}

/// Every file below `folder` but the wall times, by its name.
pub fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.strip_prefix(folder).expect("below").display().to_string();
            if path.is_dir() {
                folders.push(path);
            } else if name != "performance.json" {
                found.insert(name, fs::read(&path).expect("a file"));
            }
        }
    }
    found
}

/// Both folders have the same files, byte for byte, but for the wall times.
pub fn expect_equal(whole: &Path, joined: &Path, what: &str) {
    let (whole, joined) = (content(whole), content(joined));
    let names: std::collections::BTreeSet<&String> = whole.keys().chain(joined.keys()).collect();
    let differ: Vec<_> = names.into_iter().filter(|name| whole.get(*name) != joined.get(*name)).collect();
    assert!(differ.is_empty() && whole.contains_key("run.json"), "{what}: {differ:?}");
}
