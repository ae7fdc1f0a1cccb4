//! `lunoid farm status`: how far the shards in a folder are.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use clap::Args;
use farm::{RunStatus, ShardStatus, State, status};
use serde_json::json;

use command_line::interrupt;
use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid farm status runs
  lunoid farm status data/full-drive-farm --watch
  lunoid farm status data/full-drive-farm --json

A shard is a folder whose name ends in shard-K-of-N. States: done; running, a process draws into
the folder; stale, begun and no process draws; failed, set aside or damaged; waiting, no folder
yet. The same replay goes on in a stale folder. Exit code 1 if a shard has failed.";

/// Time between two looks.
const EVERY: Duration = Duration::from_secs(2);
/// Time after which an interrupt is seen.
const PATIENCE: Duration = Duration::from_millis(100);

/// Say how far the shards in a folder are.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Status {
    /// Folder that the shards lie in.
    folder: PathBuf,
    /// Look again every two seconds, until every shard is done or failed.
    #[arg(long)]
    watch: bool,
    /// Print JSON, one document for each look.
    #[arg(long)]
    json: bool,
}

impl Status {
    /// Looks once, or until every shard is done or failed.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let told = self.watch.then(interrupt::listen);
        loop {
            let runs = status(&self.folder, SystemTime::now()).map_err(Failure::input)?;
            self.print(&runs)?;
            let has_failed = runs.iter().any(|run| run.count(State::Failed) > 0);
            let verdict = if has_failed { Verdict::No } else { Verdict::Yes };
            match told {
                Some(told) if !runs.iter().all(RunStatus::is_over) => {
                    if was_told_within(EVERY, told) {
                        return Ok(Verdict::Interrupted);
                    }
                }
                _ => return Ok(verdict),
            }
        }
    }

    fn print(&self, runs: &[RunStatus]) -> Result<(), Failure> {
        let folder = self.folder.display().to_string();
        match self.json {
            true => print_json(&json!({ "schema": "lunoid.farm-status/1", "folder": folder, "runs": runs })),
            false => print(&runs.iter().map(text).collect::<String>()),
        }
    }
}

/// Waits for `time`, or until `told`.
fn was_told_within(time: Duration, told: &AtomicBool) -> bool {
    let end = Instant::now() + time;
    while Instant::now() < end && !told.load(Ordering::Relaxed) {
        thread::sleep(PATIENCE);
    }
    told.load(Ordering::Relaxed)
}

/// The state of a run in words: a line of sums, one of frames, a table of the shards.
fn text(run: &RunStatus) -> String {
    let count = |state: State| Some((run.count(state), state.word())).filter(|(count, _)| *count > 0);
    let counts = State::ALL.into_iter().filter_map(count).map(|(count, word)| format!("{count} {word}"));
    let counts = counts.collect::<Vec<_>>().join(", ");
    let of = run.frames.map_or_else(String::new, |[start, end]| format!(" of {}", end - start));
    let rate = run.rate_hz.map_or_else(String::new, |rate| format!(", {} a second", text::rate(rate)));
    let left = run.left_s.map_or_else(String::new, |left| format!(", {left:.0} s left"));
    let name = if run.run.is_empty() { String::new() } else { format!("{}: ", run.run) };
    let head = ["shard", "state", "frames", "done", ""].map(str::to_owned).to_vec();
    let rows: Vec<_> = [head].into_iter().chain(run.shards.iter().map(row)).collect();
    format!(
        "{name}{} shards: {counts}\n{}{of} frames{rate}{left}\n{}",
        run.shards.len(),
        run.done,
        text::table(&rows)
    )
}

fn row(shard: &ShardStatus) -> Vec<String> {
    let range = shard.range.map_or_else(|| "?".to_owned(), |[start, end]| format!("{start}..{end}"));
    let why = shard.why.clone().unwrap_or_default();
    vec![shard.shard.clone(), shard.state.word().to_owned(), range, shard.done.to_string(), why]
}
