//! Timing records of shards into one.

use merge::{Gap, Timings, merge_timings};
use serde_json::{Value, json};

use super::MergeCommand;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict};

impl MergeCommand {
    /// Joins the timing records and says what came of it.
    pub(super) fn timings(&self) -> Result<Verdict, Failure> {
        let sources: Vec<Place> =
            self.folders.iter().map(|file| Place::file("a record to join,", file)).collect();
        expect_outputs(&[Place::file("--out", &self.out)], &sources)?;
        let out = self.out.display();
        match merge_timings(&self.folders, self.asked()?.as_ref())? {
            Timings::Joined(record) => {
                timing::write(&self.out, &record)?;
                let frames = record.frames.len();
                match (self.saying.json, self.saying.quiet) {
                    (true, _) => print_json(&json!({
                        "schema": "lunoid.merge/1",
                        "joined": true,
                        "file": out.to_string(),
                        "frames": record.frames.iter().map(|frame| frame.frame).collect::<Vec<_>>(),
                    }))?,
                    (_, true) => {}
                    _ => {
                        print(&format!("{out}: timing of {frames} frames of {} files\n", self.folders.len()))?
                    }
                }
                Ok(Verdict::Yes)
            }
            Timings::Gaps(gaps) => self.tell_gaps_of_timing(&gaps),
        }
    }

    /// A timing record does not say which words made it.
    fn tell_gaps_of_timing(&self, gaps: &[Gap]) -> Result<Verdict, Failure> {
        if self.saying.json {
            let gap = |gap: &Gap| json!({ "frames": [gap.frames.start, gap.frames.end] });
            let gaps: Vec<Value> = gaps.iter().map(gap).collect();
            print_json(&json!({ "schema": "lunoid.merge/1", "joined": false, "gaps": gaps }))?;
            return Ok(Verdict::No);
        }
        let line = |gap: &Gap| {
            let (start, end) = (gap.frames.start, gap.frames.end);
            format!(
                "frames {start}..{end} are missing; record them as the others were, with --frames {start}..{end} and a file of \
                 their own\n"
            )
        };
        print(&gaps.iter().map(line).collect::<String>())?;
        Ok(Verdict::No)
    }
}
