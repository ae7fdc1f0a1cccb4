//! `lunoid merge`: the shards of a run into the run of one machine.

mod data_sets;
mod page;
mod tell;
mod timings;

use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use dataset::is_data_set;
use merge::{Merge, Outcome, merge};
use replay::{Control, HeldRun, PAGE, PAGE_DATA, Phases, RunFolder};
use text::Span;

use command_line::interrupt;
use command_line::loading::{StageArgs, Threads};
use command_line::of_run::stage_of;
use command_line::output::tell;
use command_line::progress::Saying;
use command_line::words::words;
use command_line::{Failure, Verdict};
use page::Page;

const AFTER: &str = "Examples:
  lunoid merge runs/first-light-shard-1-of-2 runs/first-light-shard-2-of-2 --out runs/first-light
  lunoid merge runs/1-of-4.json runs/2-of-4.json runs/3-of-4.json runs/4-of-4.json \\
    --out runs/timing.json

The folders may be given in any order. They must be of one run; frames that several of them have
must agree. For each gap the command that fills it is printed, and nothing is written. The
joined folder is that of one machine, byte for byte, but for performance.json, which holds wall
times. The same command again goes on where it was interrupted. Files are timing records, which
are joined alike, and so are the folders of a data set. docs/shards.md has the laws.";

/// Join the shards of a run into the run of one machine.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct MergeCommand {
    /// Run folders to join, in any order; or data sets; or timing records.
    #[arg(required = true, value_name = "FOLDER")]
    folders: Vec<PathBuf>,
    /// Folder of the joined run; of timing records, the file.
    #[arg(short, long, value_name = "FOLDER")]
    out: PathBuf,
    /// Frames of the whole run, where the folders are no shards that say so: A..B without B.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// Write no page, which is made from the scenario and its files.
    #[arg(long)]
    no_page: bool,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    saying: Saying,
}

impl MergeCommand {
    /// Joins the folders and says what came of it.
    pub fn run(&self) -> Result<Verdict, Failure> {
        if self.folders.iter().all(|path| path.is_file()) {
            return self.timings();
        }
        if self.folders.iter().any(|path| is_data_set(path)) {
            return self.data_sets();
        }
        let mut phases = Phases::since(Instant::now());
        let pool = self.threads.pool()?;
        let page = if self.no_page { None } else { Page::of(&self.folders)? };
        let folder = RunFolder::claim(&self.out, false)?;
        folder.expect_own(page.iter().flat_map(|_| [PAGE, PAGE_DATA].map(str::to_owned)))?;
        let cancel = interrupt::listen();
        let display = self.saying.display();
        let progress = |progress| display.hear(progress);
        let control = Control { pool: &pool, cancel, progress: &progress };
        let frames = self.asked()?;
        let wish = Merge { folders: &self.folders, frames: frames.as_ref() };
        let outcome = merge(wish, &folder, &control);
        display.end();
        match outcome? {
            Outcome::Interrupted { done, of } => {
                tell(&format!(
                    "interrupted: {done} of {of} frames are whole; the same command again goes on\n"
                ));
                Ok(Verdict::Interrupted)
            }
            Outcome::Gaps { gaps, words } => {
                self.tell_gaps(&gaps, &words.unwrap_or_else(|| self.usual_words()))
            }
            Outcome::Joined(joined) => {
                if let Some(page) = &page {
                    page.write(&self.folders, &folder, &pool, &mut phases)?;
                }
                self.tell_joined(&joined, page.is_some())
            }
        }
    }

    /// The frames asked for.
    fn asked(&self) -> Result<Option<Range<u64>>, Failure> {
        let Some(span) = self.frames else { return Ok(None) };
        let within = span.within(&(0..u64::MAX)).filter(|frames| frames.end < u64::MAX);
        within.map(Some).ok_or_else(|| {
            Failure::usage(format!(
                "--frames {span}: expected A..B with both ends, the frames of the whole run"
            ))
        })
    }

    /// Words that draw the run, where no folder is a shard that has them: those of a page, or the scenario alone.
    fn usual_words(&self) -> Vec<String> {
        let runs = self.folders.iter().filter_map(|folder| Some((folder, HeldRun::read(folder).ok()?)));
        let words_of = |(folder, run): (&PathBuf, HeldRun)| {
            let of_page = stage_of(&StageArgs::of(folder)).ok().map(|stage| words(&stage));
            of_page.unwrap_or_else(|| run.scenario.file.iter().map(|file| file.file.clone()).collect())
        };
        runs.map(words_of).next().unwrap_or_default()
    }
}
