//! `lunoid timing show`: a timing record as text, JSON or plots.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;
use timing::Totals;

use super::rehearsal::{Rehearsal, choose, spread};
use crate::loading::{Loaded, StageArgs, Threads};
use crate::output::{print, print_json};
use crate::progress::Display;
use crate::values::Span;
use crate::{Failure, Verdict};

/// Frames that are shown where none are named, spread over the mission.
const USUAL_FRAMES: u64 = 8;

/// Show deadlines, use of units, misses and the critical path.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid timing show scenarios/first-light.toml --machine pra-nominal --frames 0..4")]
pub struct Show {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to show, counted at the update rate: A..B without B. Eight, spread over the mission, if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// No progress.
    #[arg(long)]
    no_progress: bool,
    /// Print the record as JSON.
    #[arg(long)]
    json: bool,
    #[arg(skip)]
    _unused: Option<PathBuf>,
}

impl Show {
    /// Shows.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let usual = |loaded: &Loaded| choose(loaded, self.frames, spread(USUAL_FRAMES));
        let (rehearsal, frames) = Rehearsal::open(&self.stage, &self.threads, usual)?;
        let record = rehearsal.record(&frames, &Display::new(!self.no_progress))?;
        if self.json {
            print_json(&json!({
                "schema": "lunoid.timing.show/1",
                "record": record,
                "totals": Totals::of(&record),
            }))?;
        } else {
            print(&record.text())?;
        }
        Ok(Verdict::Yes)
    }
}
