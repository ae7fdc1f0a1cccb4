//! Data sets of one plan into one.

use std::ops::Range;

use dataset::{CARD, DataFolder, Joined, join};
use replay::Control;
use serde_json::{Value, json};

use super::MergeCommand;
use crate::commands::again::quoted;
use command_line::interrupt;
use command_line::output::{print, print_json, tell};
use command_line::{Failure, Verdict};

impl MergeCommand {
    /// Joins the data sets and says what came of it.
    pub(super) fn data_sets(&self) -> Result<Verdict, Failure> {
        if let Some(span) = self.frames {
            let refused = format!(
                "--frames {span}: a data set says itself how many samples it has; leave the option out"
            );
            return Err(Failure::usage(refused));
        }
        let pool = self.threads.pool()?;
        let folder = DataFolder::claim(&self.out)?;
        let cancel = interrupt::listen();
        let display = self.saying.display();
        let progress = |progress| display.hear(progress);
        let control = Control { pool: &pool, cancel, progress: &progress };
        let joined = join(&self.folders, &folder, &control);
        display.end();
        match joined? {
            Joined::Interrupted => {
                tell("interrupted; the same command again goes on\n");
                Ok(Verdict::Interrupted)
            }
            Joined::Gaps { gaps, plan } => self.tell_gaps_of_samples(&gaps, &plan),
            Joined::Whole { samples, overlap } => self.tell_joined_samples(samples, overlap),
        }
    }

    fn tell_gaps_of_samples(&self, gaps: &[Range<u64>], plan: &str) -> Result<Verdict, Failure> {
        let command = |gap: &Range<u64>| {
            let plan = quoted(plan);
            let out = format!("{}-samples-{}-{}", self.out.display(), gap.start, gap.end);
            format!("lunoid dataset {plan} --only {}..{} --out {}", gap.start, gap.end, quoted(&out))
        };
        if self.saying.json {
            let gap = |gap: &Range<u64>| json!({ "samples": [gap.start, gap.end], "command": command(gap) });
            let gaps: Vec<Value> = gaps.iter().map(gap).collect();
            print_json(&json!({ "schema": "lunoid.merge/1", "joined": false, "gaps": gaps }))?;
            return Ok(Verdict::No);
        }
        let line = |gap: &Range<u64>| {
            format!(
                "samples {}..{} are missing; this makes them, in the folder of {plan}:\n  {}\n",
                gap.start,
                gap.end,
                command(gap)
            )
        };
        print(&gaps.iter().map(line).collect::<String>())?;
        Ok(Verdict::No)
    }

    fn tell_joined_samples(&self, samples: u64, overlap: u64) -> Result<Verdict, Failure> {
        let (out, open) = (self.out.display(), self.out.join(CARD));
        if self.saying.json {
            print_json(&json!({
                "schema": "lunoid.merge/1",
                "joined": true,
                "folder": out.to_string(),
                "samples": samples,
                "overlap": overlap,
                "open": open.display().to_string(),
            }))?;
        } else if !self.saying.quiet {
            let overlap = match overlap {
                0 => String::new(),
                count => format!("  {count} samples in more than one folder, all equal\n"),
            };
            print(&format!(
                "{out}: {samples} samples of {} folders\n{overlap}open {}\n",
                self.folders.len(),
                open.display()
            ))?;
        }
        Ok(Verdict::Yes)
    }
}
