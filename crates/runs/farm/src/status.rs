//! All shards of a folder.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde::Serialize;
use shard::Shard;

use crate::name::named;
use crate::rate::rate_hz;
use crate::shards::{ShardStatus, State, look};

/// How far the shards of one run are.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunStatus {
    /// Words before `-shard-K-of-N` in the names of the folders; empty if there are none.
    pub run: String,
    /// Frames of the whole run; `None` while no shard says so.
    pub frames: Option<[u64; 2]>,
    /// Frames that are done, of all shards.
    pub done: u64,
    /// Frames a second, while a shard is running.
    pub rate_hz: Option<f64>,
    /// Time until all frames are done at that rate (s).
    pub left_s: Option<f64>,
    /// All shards, in order.
    pub shards: Vec<ShardStatus>,
}

/// A folder whose shards cannot be looked at.
#[derive(Debug, thiserror::Error)]
pub enum StatusError {
    /// The folder cannot be listed.
    #[error("{path}: cannot list the folder: {source}")]
    Folder {
        /// Path of the folder.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The folder has no shards.
    #[error(
        "{path}: found no shards, expected folders whose names end in shard-K-of-N, as shard-2-of-7; name the folder that they lie in"
    )]
    NoShards {
        /// Path of the folder.
        path: PathBuf,
    },
}

/// The runs whose shards lie in `folder`, by name, as they are at the time `now`.
///
/// # Errors
/// If the folder cannot be listed or has no shards.
pub fn status(folder: &Path, now: SystemTime) -> Result<Vec<RunStatus>, StatusError> {
    let failed = |source| StatusError::Folder { path: folder.to_owned(), source };
    let mut runs = BTreeSet::new();
    for entry in folder.read_dir().map_err(failed)? {
        let name = entry.map_err(failed)?.file_name();
        let name = name.to_string_lossy();
        // A shard that never began may have a note alone.
        let name = name.strip_suffix(".failed.json").unwrap_or(&name);
        runs.extend(named(name).map(|(run, shard)| (run.to_owned(), shard.of())));
    }
    if runs.is_empty() {
        return Err(StatusError::NoShards { path: folder.to_owned() });
    }
    Ok(runs.into_iter().map(|(run, of)| run_status(folder, run, of, now)).collect())
}

fn run_status(folder: &Path, run: String, of: u32, now: SystemTime) -> RunStatus {
    let place = |number: u32| {
        let dash = if run.is_empty() { "" } else { "-" };
        folder.join(format!("{run}{dash}shard-{number}-of-{of}"))
    };
    let name = |number| Shard::new(number, of).map_or_else(String::new, |shard| shard.to_string());
    let looked: Vec<_> = (1..=of).map(|number| look(name(number), place(number))).collect();
    let frames = looked.iter().find_map(|(_, whole)| *whole);
    let shards: Vec<ShardStatus> = looked.into_iter().map(|(shard, _)| shard).collect();
    let done = shards.iter().map(|shard| shard.done).sum();
    let is_running = shards.iter().any(|shard| shard.state == State::Running);
    let rate = || rate_hz(shards.iter().map(|shard| shard.folder.as_path()), now);
    let rate_hz = is_running.then(rate).flatten();
    let left = frames.map(|[start, end]| (end - start).saturating_sub(done) as f64);
    let left_s = left.zip(rate_hz).map(|(left, rate)| left / rate);
    RunStatus { run, frames, done, rate_hz, left_s, shards }
}

impl RunStatus {
    /// Number of shards in `state`.
    pub fn count(&self, state: State) -> usize {
        self.shards.iter().filter(|shard| shard.state == state).count()
    }

    /// Whether nothing more comes by itself: every shard is done or failed.
    pub fn is_over(&self) -> bool {
        self.count(State::Done) + self.count(State::Failed) == self.shards.len()
    }
}
