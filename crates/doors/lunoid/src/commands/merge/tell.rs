//! What came of joining, in words and as JSON.

use std::ops::Range;
use std::path::PathBuf;

use merge::{Gap, Joined};
use replay::{CONTACT_SHEET, PAGE};
use serde_json::{Value, json};

use super::MergeCommand;
use crate::commands::again::quoted;
use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};

impl MergeCommand {
    pub(super) fn tell_gaps(&self, gaps: &[Gap], words: &[String]) -> Result<Verdict, Failure> {
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

    pub(super) fn tell_joined(&self, joined: &Joined, has_page: bool) -> Result<Verdict, Failure> {
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
        print(&format!("{text}open {}\n", open.display()))?;
        Ok(Verdict::Yes)
    }
}
