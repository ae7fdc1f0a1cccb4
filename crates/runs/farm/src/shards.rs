//! The state of one shard.

use std::path::{Path, PathBuf};

use files::is_locked;
use replay::{HeldRun, JOURNAL, RUN_RECORD, held_truth, read_journal};
use run_record::{FrameRecord, RunRecord, ShardRecord};
use serde::Serialize;

use crate::failure;

/// What becomes of a shard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// Every frame is there, with the truth that the shard's command asks for.
    Done,
    /// A process draws into the folder.
    Running,
    /// The shard was begun, and no process draws into its folder.
    Stale,
    /// The shard was set aside, or a file of it cannot be read.
    Failed,
    /// The shard has no folder.
    Waiting,
}

impl State {
    /// All states, in the order in which they are listed.
    pub const ALL: [Self; 5] = [Self::Done, Self::Running, Self::Stale, Self::Failed, Self::Waiting];

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Running => "running",
            Self::Stale => "stale",
            Self::Failed => "failed",
            Self::Waiting => "waiting",
        }
    }
}

/// How far a shard is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ShardStatus {
    /// Number of the shard and of all shards, as `3/7`.
    pub shard: String,
    /// Folder of the shard, whether or not it is there.
    pub folder: PathBuf,
    /// State of the shard.
    pub state: State,
    /// Its first frame, and the frame behind its last; `None` while no file says so.
    pub range: Option<[u64; 2]>,
    /// Frames that are done.
    pub done: u64,
    /// Why the shard failed, in words.
    pub why: Option<String>,
}

/// What the files of a shard's folder say.
#[derive(Default)]
struct Found {
    range: Option<[u64; 2]>,
    done: u64,
    is_whole: bool,
    shard: Option<ShardRecord>,
}

/// The state of shard `name` with this `folder`, and the frames of the whole run where a file says so.
pub(crate) fn look(name: String, folder: PathBuf) -> (ShardStatus, Option<[u64; 2]>) {
    let is_running = is_locked(&folder);
    let found = if folder.is_dir() { found(&folder).map(Some) } else { Ok(None) };
    let (state, why) = match (&found, failure::read(&folder)) {
        _ if is_running => (State::Running, None),
        (Ok(Some(found)), _) if found.is_whole => (State::Done, None),
        (Err(error), _) => (State::Failed, Some(error.clone())),
        (_, Err(error)) => (State::Failed, Some(error)),
        (_, Ok(Some(failure))) => (State::Failed, Some(failure.why)),
        (Ok(Some(_)), Ok(None)) => (State::Stale, None),
        (Ok(None), Ok(None)) => (State::Waiting, None),
    };
    let Found { range, done, shard, .. } = found.ok().flatten().unwrap_or_default();
    (ShardStatus { shard: name, folder, state, range, done, why }, shard.map(|shard| shard.of))
}

fn found(folder: &Path) -> Result<Found, String> {
    if folder.join(RUN_RECORD).exists() {
        let run = HeldRun::read(folder).map_err(|error| error.to_string())?.into_record();
        let is_whole = !asks_for_truth(&run) || has_truth(folder, &run)?;
        let done = run.frames.len() as u64;
        return Ok(Found { range: Some(run.range), done, is_whole, shard: run.shard });
    }
    let journal = read_journal::<FrameRecord>(&folder.join(JOURNAL)).map_err(|error| error.to_string())?;
    let Some(journal) = journal else { return Ok(Found::default()) };
    let done = journal.frames.len() as u64;
    let (range, shard) = journal.span.map_or((None, None), |span| (Some(span.range), span.shard));
    Ok(Found { range, done, is_whole: false, shard })
}

/// Whether the command of the shard makes truth.
fn asks_for_truth(run: &RunRecord) -> bool {
    run.shard.as_ref().is_some_and(|shard| shard.words.iter().any(|word| word == "--truth"))
}

fn has_truth(folder: &Path, run: &RunRecord) -> Result<bool, String> {
    let truth = held_truth(folder).map_err(|error| error.to_string())?;
    Ok(truth.is_some_and(|truth| truth.frames.len() == run.frames.len()))
}
