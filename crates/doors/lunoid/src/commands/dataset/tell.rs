//! What came of a data set, in words and as JSON.

use std::ops::Range;
use std::path::Path;

use dataset::{CARD, Estimate, MANIFEST, Plan, Split};
use serde_json::json;

use super::DatasetCommand;
use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};

impl DatasetCommand {
    pub(super) fn tell_estimate(
        &self,
        plan: &Plan,
        estimate: &Estimate,
        threads: usize,
    ) -> Result<Verdict, Failure> {
        let Estimate { samples, splits, measured, seconds, bytes, refused } = estimate;
        let total = seconds * *samples as f64 / threads as f64;
        let disk = bytes * *samples as f64;
        let named = || Split::ALL.iter().map(|split| split.name()).zip(splits);
        if self.saying.json {
            let splits: serde_json::Map<_, _> =
                named().map(|(name, count)| (name.to_owned(), json!(count))).collect();
            print_json(&json!({
                "schema": "lunoid.dataset-list/1",
                "samples": samples,
                "of": plan.samples(),
                "combinations": plan.combinations(),
                "splits": splits,
                "measured": measured,
                "seconds_per_sample": seconds,
                "bytes_per_sample": bytes,
                "threads": threads,
                "seconds": total,
                "bytes": disk,
                "refused_poses": refused,
            }))?;
            return Ok(Verdict::Yes);
        }
        let splits: Vec<String> = named().map(|(name, count)| format!("{name} {count}")).collect();
        let refused: Vec<String> =
            refused.iter().map(|(reason, count)| format!("{reason} {count}")).collect();
        let refused = if refused.is_empty() { "none".into() } else { refused.join(", ") };
        print(&format!(
            "{}: {samples} samples of {} in {} combinations: {}\n\
             measured on {measured}: {:.3} s and {:.0} kB a sample; poses refused: {refused}\n\
             by {threads} threads about {}, {}\n",
            plan.title,
            plan.samples(),
            plan.combinations(),
            splits.join(", "),
            seconds,
            bytes / 1e3,
            duration(total),
            size(disk),
        ))?;
        Ok(Verdict::Yes)
    }

    pub(super) fn tell_made(&self, out: &Path, samples: &Range<u64>, made: u64) -> Result<Verdict, Failure> {
        let Range { start, end } = samples;
        let open = out.join(CARD);
        if self.saying.json {
            print_json(&json!({
                "schema": "lunoid.dataset-made/1",
                "folder": out.display().to_string(),
                "samples": [start, end],
                "made": made,
                "manifest": out.join(MANIFEST).display().to_string(),
                "open": open.display().to_string(),
            }))?;
        } else if !self.saying.quiet {
            print(&format!(
                "{}: samples {start}..{end}, {made} of them made now\nopen {}\n",
                out.display(),
                open.display()
            ))?;
        }
        Ok(Verdict::Yes)
    }
}

/// A time for people.
fn duration(seconds: f64) -> String {
    match seconds {
        _ if seconds < 120.0 => format!("{seconds:.0} s"),
        _ if seconds < 7200.0 => format!("{:.0} min", seconds / 60.0),
        _ => format!("{:.1} h", seconds / 3600.0),
    }
}

/// A number of bytes for people.
fn size(bytes: f64) -> String {
    match bytes {
        _ if bytes < 1e6 => format!("{:.0} kB", bytes / 1e3),
        _ if bytes < 1e9 => format!("{:.1} MB", bytes / 1e6),
        _ => format!("{:.1} GB", bytes / 1e9),
    }
}
