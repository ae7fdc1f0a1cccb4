//! How far shards are, from folders that runs have left.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use farm::{FAILED_SCHEMA, Failure, RunStatus, State, note_of, status};
use files::Lock;
use replay::{Fingerprint, JOURNAL, Journal};
use run_record::FrameRecord;
use tempfile::TempDir;

fn frame(number: u64) -> FrameRecord {
    FrameRecord {
        frame: number,
        time_s: number as f64,
        pixels_blake3: "p".into(),
        files: vec![],
        counts: generator::FrameCounts::default(),
    }
}

/// A folder of shards.
struct Farm(TempDir);

impl Farm {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn shard(&self, name: &str) -> PathBuf {
        let folder = self.path().join(name);
        fs::create_dir_all(folder.join("frames")).expect("made");
        folder
    }

    /// A shard with a journal of `frames`, and a picture of each, written at `written`.
    fn begun(&self, name: &str, frames: &[(u64, SystemTime)]) -> PathBuf {
        let folder = self.shard(name);
        let fingerprint = Fingerprint { hash: "f".into(), of: serde_json::json!({}) };
        let records: Vec<FrameRecord> = frames.iter().map(|(number, _)| frame(*number)).collect();
        Journal::begin(folder.join(JOURNAL), &fingerprint, &records).expect("begun");
        for (number, written) in frames {
            let picture =
                fs::File::create(folder.join(format!("frames/frame-{number:06}.png"))).expect("made");
            picture.set_modified(*written).expect("dated");
        }
        folder
    }

    fn only(&self, now: SystemTime) -> RunStatus {
        let mut runs = status(self.path(), now).expect("looked at");
        assert_eq!(runs.len(), 1, "{runs:?}");
        runs.remove(0)
    }
}

fn states(run: &RunStatus) -> Vec<State> {
    run.shards.iter().map(|shard| shard.state).collect()
}

#[test]
fn a_shard_is_running_while_its_lock_is_held_and_stale_after() {
    let farm = Farm::new();
    let now = SystemTime::now();
    let folder = farm.begun("drive-shard-2-of-3", &[(4, now), (5, now)]);
    assert_eq!(states(&farm.only(now)), [State::Waiting, State::Stale, State::Waiting]);
    let lock = Lock::take(&folder).expect("free");
    let run = farm.only(now);
    assert_eq!((states(&run)[1], run.done, run.shards[1].done), (State::Running, 2, 2));
    // Looking takes nothing away from who draws.
    assert!(Lock::take(&folder).is_err());
    drop(lock);
    let run = farm.only(now);
    assert_eq!((states(&run)[1], run.rate_hz), (State::Stale, None));
    // A killed run leaves the file of its lock.
    fs::write(folder.join(files::LOCK), "1").expect("written");
    assert_eq!(states(&farm.only(now))[1], State::Stale);
}

#[test]
fn a_note_makes_a_shard_failed_until_a_process_draws_it() {
    let farm = Farm::new();
    let folder = farm.path().join("shard-1-of-2");
    let note =
        Failure { schema: FAILED_SCHEMA.into(), tries: 3, why: "no space".into(), command: "lunoid".into() };
    fs::write(note_of(&folder), serde_json::to_string(&note).expect("text")).expect("written");
    let run = farm.only(SystemTime::now());
    assert_eq!((run.run.as_str(), states(&run)), ("", vec![State::Failed, State::Waiting]));
    assert_eq!(run.shards[0].why.as_deref(), Some("no space"));
    assert!(!run.is_over());
    farm.shard("shard-1-of-2");
    let _lock = Lock::take(&folder).expect("free");
    assert_eq!(states(&farm.only(SystemTime::now()))[0], State::Running);
}

#[test]
fn damage_is_a_failure_with_the_file_in_its_words() {
    let farm = Farm::new();
    let now = SystemTime::now();
    fs::write(farm.shard("a-shard-1-of-3").join("run.json"), "{}").expect("written");
    fs::write(farm.shard("a-shard-2-of-3").join(JOURNAL), "x").expect("written");
    fs::write(note_of(&farm.shard("a-shard-3-of-3")), "{\"schema\":\"x\"}").expect("written");
    let run = farm.only(now);
    assert_eq!(states(&run), [State::Failed; 3]);
    for (shard, file) in run.shards.iter().zip(["run.json", JOURNAL, "a-shard-3-of-3.failed.json"]) {
        assert!(shard.why.as_ref().is_some_and(|why| why.contains(file)), "{shard:?}");
    }
    assert!(run.is_over());
}

#[test]
fn the_rate_counts_the_pictures_of_ten_minutes() {
    let farm = Farm::new();
    let now = SystemTime::now();
    let ago = |seconds| now - Duration::from_secs(seconds);
    let folder = farm.begun("a-shard-1-of-2", &[(0, ago(3000)), (1, ago(40)), (2, ago(20))]);
    farm.begun("a-shard-2-of-2", &[(6, ago(30)), (7, ago(10))]);
    assert_eq!(farm.only(now).rate_hz, None, "nobody draws");
    let _lock = Lock::take(&folder).expect("free");
    let run = farm.only(now);
    assert_eq!((run.rate_hz, run.done), (Some(0.1), 5));
    // The heading of these journals does not say how many frames the run has.
    assert_eq!((run.frames, run.left_s), (None, None));
    assert_eq!(farm.only(now + Duration::from_secs(700)).rate_hz, None);
}

#[test]
fn runs_are_told_apart_by_name_and_number_and_other_folders_are_none() {
    let farm = Farm::new();
    for name in
        ["a-shard-1-of-2", "a-shard-3-of-3", "b-shard-1-of-2", "shard-0-of-2", "shard-3-of-2", "frames"]
    {
        farm.shard(name);
    }
    let runs = status(farm.path(), SystemTime::now()).expect("looked at");
    let names: BTreeMap<_, _> = runs.iter().map(|run| ((run.run.as_str(), run.shards.len()), ())).collect();
    assert_eq!(names.into_keys().collect::<Vec<_>>(), [("a", 2), ("a", 3), ("b", 2)]);
    let empty = tempfile::tempdir().expect("a folder");
    let said = status(empty.path(), SystemTime::now()).expect_err("refused").to_string();
    assert!(said.contains("found no shards") && said.contains("shard-2-of-7"), "{said}");
    let gone = status(&empty.path().join("gone"), SystemTime::now()).expect_err("refused").to_string();
    assert!(gone.contains("gone: cannot list the folder"), "{gone}");
}
