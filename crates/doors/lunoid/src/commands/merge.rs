//! `lunoid merge`: the shards of a run into the run of one machine.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use front_door::Opened;
use merge::{Gap, Joined, Merge, Outcome, merge};
use rayon::ThreadPool;
use replay::{
    CONTACT_SHEET, Control, HeldRun, Job, PAGE, PAGE_DATA, Phases, Pictures, RunFolder, expect_run_of,
};
use run_page::{Making, gather};
use serde_json::{Value, json};
use text::{Span, visible};

use super::again::quoted;
use super::of_run::stage_of;
use super::replay::program;
use super::words::words;
use crate::interrupt;
use crate::loading::{StageArgs, Threads};
use crate::output::{print, print_json, tell};
use crate::progress::Saying;
use crate::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid merge runs/first-light-shard-1-of-2 runs/first-light-shard-2-of-2 --out runs/first-light

The folders may be given in any order. They must be of one run; frames that several of them have must agree. For each gap the
command that fills it is printed, and nothing is written. The joined folder is that of one machine, byte for byte, but for
performance.json, which holds wall times. The same command again goes on where it was interrupted. docs/shards.md has the laws.";

/// Join the shards of a run into the run of one machine.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct MergeCommand {
    /// Run folders to join, in any order.
    #[arg(required = true, value_name = "FOLDER")]
    folders: Vec<PathBuf>,
    /// Folder of the joined run.
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
        let mut phases = Phases::since(Instant::now());
        let pool = self.threads.pool()?;
        let page = if self.no_page { None } else { self.page(&pool)? };
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

    /// What the page is made from, if a folder has a page.
    fn page(&self, pool: &ThreadPool) -> Result<Option<Page>, Failure> {
        let mut with_page: Vec<(u64, &PathBuf)> = Vec::new();
        for folder in self.folders.iter().filter(|folder| folder.join(PAGE_DATA).is_file()) {
            // A run that is not finished says so when it is joined.
            let Ok(run) = HeldRun::read(folder) else { continue };
            with_page.push((run.range[0], folder));
        }
        let Some((_, folder)) = with_page.into_iter().min() else { return Ok(None) };
        let stage = stage_of(&StageArgs::of(folder)).map_err(without_page)?;
        let opened = stage.load_any_view().map_err(without_page)?;
        let stage_made = pool.install(|| opened.stage())?;
        Ok(Some(Page { stage, opened, made: stage_made }))
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

    fn tell_gaps(&self, gaps: &[Gap], words: &[String]) -> Result<Verdict, Failure> {
        let command = |gap: &Gap| self.command(gap, words);
        if self.saying.json {
            let entry = |gap: &Gap| json!({ "frames": [gap.frames.start, gap.frames.end], "truth": gap.truth, "command": command(gap) });
            let gaps: Vec<Value> = gaps.iter().map(entry).collect();
            print_json(&json!({ "schema": "lunoid.merge/1", "joined": false, "gaps": gaps }))?;
            return Ok(Verdict::No);
        }
        let line = |gap: &Gap| {
            let what = if gap.truth { "ground truth of frames" } else { "frames" };
            let Range { start, end } = gap.frames;
            format!("{what} {start}..{end} are missing; this makes them:\n  {}\n", command(gap))
        };
        print(&gaps.iter().map(line).collect::<String>())?;
        Ok(Verdict::No)
    }

    /// The command that fills a gap.
    fn command(&self, gap: &Gap, words: &[String]) -> String {
        let Range { start, end } = gap.frames;
        let beside = || PathBuf::from(format!("{}-frames-{start}-{end}", self.out.display()));
        let folder = gap.folder.clone().unwrap_or_else(beside);
        let words = words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ");
        format!(
            "lunoid replay {words} --frames {start}..{end} --out {}",
            quoted(&folder.display().to_string())
        )
    }

    fn tell_joined(&self, joined: &Joined, has_page: bool) -> Result<Verdict, Failure> {
        let open = self.out.join(if has_page { PAGE } else { CONTACT_SHEET });
        let Range { start, end } = joined.frames;
        if self.saying.json {
            print_json(&json!({
                "schema": "lunoid.merge/1",
                "joined": true,
                "folder": self.out.display().to_string(),
                "frames": [start, end],
                "overlap": joined.overlap,
                "truth": joined.truth,
                "left_check_out": joined.left_check_out,
                "open": open.display().to_string(),
            }))?;
            return Ok(Verdict::Yes);
        }
        if self.saying.quiet {
            return Ok(Verdict::Yes);
        }
        let mut text =
            format!("{}: frames {start}..{end} of {} folders\n", self.out.display(), self.folders.len());
        if joined.overlap > 0 {
            text += &format!("  {} frames in more than one folder, all equal\n", joined.overlap);
        }
        if joined.truth > 0 {
            text += &format!("  ground truth of {} frames\n", joined.truth);
        }
        if joined.left_check_out {
            text +=
                "  a check of a part is left out; the same replay with --check makes one of the whole run\n";
        }
        print(&visible(&format!("{text}open {}\n", open.display())))?;
        Ok(Verdict::Yes)
    }
}

/// A page is made from the scenario, which may not be here.
fn without_page(failure: Failure) -> Failure {
    let added = |message: String| format!("{message}; or leave the page out with --no-page");
    match failure {
        Failure::Input(message) => Failure::Input(added(message)),
        other => other,
    }
}

/// What a page is made from.
struct Page {
    stage: StageArgs,
    opened: Opened,
    made: generator::Stage,
}

impl Page {
    /// Writes the page of the joined run, with the sweeps that were recorded in its parts.
    fn write(
        &self,
        from: &[PathBuf],
        folder: &RunFolder,
        pool: &ThreadPool,
        phases: &mut Phases,
    ) -> Result<(), Failure> {
        let run = HeldRun::read(folder.path())?;
        let [start, end] = run.range;
        let job = Job {
            program: program(),
            inputs: self.opened.inputs.clone(),
            scenario: &self.opened.scenario,
            generator: std::sync::Arc::clone(&self.opened.generator),
            stage: self.made.clone(),
            frames: start..end,
            shard: None,
            pictures: Pictures::of_record(&run.pictures),
            check: 0,
        };
        expect_run_of(&job, folder)?;
        gather(from.iter().map(PathBuf::as_path).collect::<Vec<&Path>>(), folder)?;
        let words = words(&self.stage);
        Ok(Making { job: &job, words, opened: &self.opened, requests: &[], pool }.write(folder, phases)?)
    }
}
