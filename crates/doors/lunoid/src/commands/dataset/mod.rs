//! `lunoid dataset`: labelled frames for learning, from a plan.

mod tell;

use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use dataset::{DataFolder, Estimate, Job, Outcome, Plan, run};
use replay::Control;
use shard::Shard;
use text::Span;

use command_line::interrupt;
use command_line::loading::Threads;
use command_line::output::tell;
use command_line::program::program;
use command_line::progress::Saying;
use command_line::sharing::{Sharing, numbers};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid dataset scenarios/datasets/first-look.toml --list
  lunoid dataset scenarios/datasets/first-look.toml --out runs/first-look
  lunoid dataset scenarios/datasets/first-look.toml --only 7
  lunoid dataset scenarios/datasets/first-look.toml --shard 2/7

Every sample is a function of the plan and its number, so any part can be made alone, on any
machine. The same command again goes on where it was interrupted. `lunoid merge` joins shards
into the folder of one machine, byte for byte. docs/dataset-plan.md has the plan.";

/// Make labelled frames for learning: samples drawn by a plan, their truth, splits, manifest and data card.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct DatasetCommand {
    /// Plan to read: a TOML file.
    plan: PathBuf,
    /// Folder of the data set; runs/NAME-OF-THE-PLAN if left out, of a shard with -shard-K-of-N behind, of --only with its numbers.
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Samples to make: one number, or A..B without B. All if left out.
    #[arg(long, value_name = "N|A..B", conflicts_with = "shard")]
    only: Option<Span>,
    #[command(flatten)]
    sharing: Sharing,
    /// Make no files: say how many samples there are, and how long they take and how large they are, measured on a few.
    #[arg(long)]
    list: bool,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    saying: Saying,
}

impl DatasetCommand {
    /// Makes the data set, or measures it, and says what came of it.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let plan = Plan::read(&self.plan)?;
        let shard = self.sharing.asked()?;
        let samples = self.samples(&plan, shard)?;
        if self.list {
            let estimate = Estimate::measure(&plan, &samples)?;
            let threads = self.threads.pool()?.current_num_threads();
            return self.tell_estimate(&plan, &estimate, threads);
        }
        let out = self.out.clone().unwrap_or_else(|| self.usual(shard, &samples));
        let pool = self.threads.pool()?;
        let folder = DataFolder::claim(&out)?;
        let cancel = interrupt::listen();
        let display = self.saying.display();
        let progress = |progress| display.hear(progress);
        let control = Control { pool: &pool, cancel, progress: &progress };
        let job = Job { plan: &plan, program: program(), samples: samples.clone() };
        let outcome = run(&job, &folder, &control);
        display.end();
        match outcome? {
            Outcome::Interrupted { done, of } => {
                tell(&format!(
                    "interrupted: {done} of {of} samples are whole; the same command again goes on\n"
                ));
                Ok(Verdict::Interrupted)
            }
            Outcome::Finished { made } => self.tell_made(&out, &samples, made),
        }
    }

    /// The samples that are asked for.
    fn samples(&self, plan: &Plan, shard: Option<Shard>) -> Result<Range<u64>, Failure> {
        let all = 0..plan.samples();
        match (shard, self.only) {
            (Some(shard), _) => numbers(shard, &all, "samples"),
            (None, None) => Ok(all),
            (None, Some(span)) => span.within(&all).ok_or_else(|| {
                Failure::usage(format!("--only {span}: expected a sample, or A..B, of 0..{}", all.end))
            }),
        }
    }

    /// The folder where none is named.
    fn usual(&self, shard: Option<Shard>, samples: &Range<u64>) -> PathBuf {
        let name = self.plan.file_stem().unwrap_or_default().to_string_lossy();
        let part = match (shard, self.only) {
            (Some(shard), _) => format!("-shard-{}-of-{}", shard.number(), shard.of()),
            (None, Some(_)) => format!("-samples-{}-{}", samples.start, samples.end),
            (None, None) => String::new(),
        };
        Path::new("runs").join(format!("{name}{part}"))
    }
}
