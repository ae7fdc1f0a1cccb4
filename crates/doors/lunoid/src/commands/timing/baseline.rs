//! `lunoid timing record` and `lunoid timing check`.

use std::path::PathBuf;

use clap::Args;
use deadlines::{
    DeadlineError, Rehearsal, Rehearsed, Routine, changed_pixels, first, first_moved, routines_text,
};
use front_door::Opened;
use hardware_model::{HardwareModel, ModelSource};
use picture::ChangedPixels;
use serde_json::json;
use timing::{Allowance, Comparison, Difference, TimingRecord, Tolerance, Totals, compare};

use crate::commands::changed;
use crate::rehearsing::{choose, record, rehearse, rehearse_timed};
use command_line::loading::{StageArgs, Threads, of_timed};
use command_line::output::{Place, expect_outputs, print, print_json, warn};
use command_line::sharing::{Sharing, part};
use command_line::values::not_negative;
use command_line::{Failure, Verdict};
use text::Span;

/// Frames of a baseline that names none.
const USUAL_FRAMES: u64 = 2;
/// Differences that are told one by one.
const TOLD: usize = 60;

/// Write the timing of some frames as a baseline.
#[derive(Debug, Args)]
#[command(
    mut_args(of_timed),
    after_help = "Example:\n  lunoid timing record scenarios/first-light.toml --machine pra-nominal --sweeps 21 --frames 0..2 --out baseline.json\n  lunoid timing record scenarios/first-light.toml --frames 0..8 --shard 2/4 --out runs/2-of-4.json"
)]
pub struct Record {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to record, counted at the update rate: A..B without B. The first two if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    #[command(flatten)]
    sharing: Sharing,
    /// File of the timing record to write.
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print the totals as JSON.
    #[arg(long)]
    json: bool,
}

impl Record {
    /// Records the timing of the frames and writes the record.
    pub fn run(&self) -> Result<Verdict, Failure> {
        expect_outputs(&[Place::file("--out", &self.out)], &self.stage.sources())?;
        let shard = self.sharing.asked()?;
        let usual =
            |opened: &Opened| part(shard, choose(opened, self.frames, first(USUAL_FRAMES))?, "frames");
        let (rehearsal, frames) = rehearse_timed(&self.stage, &self.threads, usual)?;
        let record = record(!self.no_progress, |hear| rehearsal.record(&frames, hear))?;
        timing::write(&self.out, &record)?;
        self.tell(&record, &rehearsal.routines(&record))?;
        Ok(Verdict::Yes)
    }

    fn tell(&self, record: &TimingRecord, routines: &[Routine]) -> Result<(), Failure> {
        let file = self.out.display();
        if self.json {
            let mut document = json!({
                "schema": "lunoid.timing.record/1",
                "file": file.to_string(),
                "inputs": record.inputs,
                "frames": frames_of(record),
                "totals": Totals::of(record),
            });
            if !routines.is_empty() {
                document["routines"] = json!(routines);
            }
            return print_json(&document);
        }
        print(&format!("{file}: {}{}", record.text(), routines_text(routines)))
    }
}

/// Hold the timing to a baseline.
#[derive(Debug, Args)]
#[command(
    mut_args(of_timed),
    after_help = "Example:\n  lunoid timing check scenarios/first-light.toml --machine pra-nominal --sweeps 21 --baseline baseline.json --junit timing.xml --pictures changed"
)]
pub struct Check {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// The baseline, as `lunoid timing record` wrote it.
    #[arg(long, value_name = "FILE")]
    baseline: PathBuf,
    /// Frames to check: A..B without B. Those of the baseline if left out; frames of the baseline that are left out
    /// here are not looked at.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// How far instants may be apart (samples). Digital times, counters and events are exact.
    #[arg(long, value_name = "SAMPLES", value_parser = not_negative, default_value_t = 1e-6)]
    tolerance_samples: f64,
    /// How far ground ranges may be apart (m).
    #[arg(long, value_name = "METRES", value_parser = not_negative, default_value_t = 1e-6)]
    tolerance_m: f64,
    /// Let the timing differ as long as a total is within a bound: late-words<=N, late-sets<=N, missed<=N, slack>=N;
    /// missed and slack of one deadline as slack.transfer>=N. May be given several times; each must hold.
    #[arg(long, value_name = "BOUND")]
    allow: Vec<Allowance>,
    /// Write the result as JUnit XML as well.
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write a PNG of each frame that differs, changed-NNNNNN.png: changed pixels on the dimmed picture, orange where they are
    /// brighter than under the machine of the baseline, blue where they are darker.
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print the comparison as JSON.
    #[arg(long)]
    json: bool,
}

impl Check {
    /// Measures the frames and compares their timing with the baseline.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let sources = [vec![Place::file("--baseline", &self.baseline)], self.stage.sources()].concat();
        let pictures = self.pictures.iter().map(|folder| changed::place(folder));
        let outputs: Vec<_> = Place::given([("--junit", &self.junit)]).into_iter().chain(pictures).collect();
        expect_outputs(&outputs, &sources)?;
        let tolerance = Tolerance::new(self.tolerance_samples, self.tolerance_m).map_err(Failure::usage)?;
        let mut baseline = timing::read(&self.baseline)?;
        let (rehearsal, frames) =
            rehearse_timed(&self.stage, &self.threads, |opened| self.choose(opened, &baseline))?;
        if self.frames.is_some() {
            baseline.frames.retain(|frame| frames.contains(&frame.frame));
        }
        let found = record(!self.no_progress, |hear| rehearsal.record(&frames, hear))?;
        let mut comparison = compare(&baseline, &found, &tolerance)
            .within(&self.allow, [&baseline, &found])
            .map_err(|unknown| Failure::usage(format!("--allow {unknown}")))?;
        let mut pictures = Vec::new();
        if !comparison.is_same() {
            let again = self.again(&baseline, &comparison, &frames);
            if let (Some((again, known)), Rehearsed::Machine(found)) = (&again, &rehearsal) {
                comparison.first_event = first_moved(again, found, known)?;
                pictures = self.draw(again, found, &changed_frames(&comparison, known))?;
            } else if self.pictures.is_some() {
                warn(
                    "--pictures: none, for the run of the baseline cannot be made again; record it anew with the machine as it was",
                );
            }
        }
        self.tell(&comparison, &pictures)?;
        Ok(if comparison.is_met() { Verdict::Yes } else { Verdict::No })
    }

    /// What is asked for, or the frames of the baseline that the scenario has.
    fn choose(&self, opened: &Opened, baseline: &TimingRecord) -> Result<Vec<u64>, Failure> {
        if self.frames.is_some() {
            return choose(opened, self.frames, first(0));
        }
        let all = opened.frames();
        let frames: Vec<u64> = frames_of(baseline).into_iter().filter(|&frame| frame < all).collect();
        if frames.is_empty() {
            let (file, first) = (self.baseline.display(), baseline.frames[0].frame);
            return Err(Failure::input(format!(
                "{file}: its first frame is {first}, the scenario has frames 0..{all}; expected a baseline of this scenario"
            )));
        }
        Ok(frames)
    }

    /// The baseline's run made again, on the same scenario with the values that its hardware model and its raster had, and the
    /// frames that both have. `None` if it cannot be made: the check has its answer without.
    fn again(
        &self,
        baseline: &TimingRecord,
        comparison: &Comparison,
        frames: &[u64],
    ) -> Option<(Rehearsal, Vec<u64>)> {
        let stage = self.as_baseline(comparison)?;
        let recorded = frames_of(baseline);
        let known: Vec<u64> = frames.iter().copied().filter(|frame| recorded.contains(frame)).collect();
        let (again, known) = rehearse(&stage, &self.threads, |_| Ok(known)).ok()?;
        (again.inputs() == baseline.inputs).then_some((again, known))
    }

    /// Draws `frames` by both machines, and writes the pictures of what changed, if they are asked for.
    fn draw(
        &self,
        baseline: &Rehearsal,
        found: &Rehearsal,
        frames: &[u64],
    ) -> Result<Vec<(u64, ChangedPixels)>, Failure> {
        let Some(folder) = &self.pictures else { return Ok(Vec::new()) };
        let mut pictures = Vec::new();
        for &frame in frames {
            let changed = match changed_pixels(baseline, found, frame) {
                // The check has its answer without.
                Err(error @ DeadlineError::OtherSize { .. }) => {
                    warn(&format!("--pictures: none: {error}"));
                    break;
                }
                changed => changed?,
            };
            changed::write(folder, frame, &changed)?;
            pictures.push((frame, changed));
        }
        Ok(pictures)
    }

    /// What makes the baseline's run again; `None` if its keys are not known, or others than the machine's and the raster's differ.
    fn as_baseline(&self, comparison: &Comparison) -> Option<StageArgs> {
        let mut stage = self.stage.clone();
        if !comparison.has_keys {
            return None;
        }
        for Difference { place, baseline, .. } in &comparison.keys {
            match (place.split_once('.')?, baseline) {
                (("machine", key), Some(value)) => stage.options.set.push((key.to_owned(), value.clone())),
                // A key that a model may leave out means what the ideal model has.
                (("machine", key), None) => stage.options.set.push((key.to_owned(), ideal_value(key)?)),
                (("asked", "sweeps"), count) => {
                    stage.options.sweeps = count.as_ref().map(|count| count.parse()).transpose().ok()?;
                }
                (("asked", "samples"), count) => {
                    stage.options.samples = count.as_ref().map(|count| count.parse()).transpose().ok()?;
                }
                _ => return None,
            }
        }
        Some(stage)
    }

    fn tell(&self, comparison: &Comparison, pictures: &[(u64, ChangedPixels)]) -> Result<(), Failure> {
        if let Some(junit) = &self.junit {
            let text = comparison.junit(TOLD);
            files::write_atomic(junit, |out| out.write_all(text.as_bytes()))?;
        }
        if !self.json {
            let told = |(frame, changed): &(u64, ChangedPixels)| {
                let (all, seen) = (changed.pixels().len(), changed.seen());
                format!(
                    "picture of frame {frame}: {all} pixels changed, {seen} of them by a grey level or more\n"
                )
            };
            return print(&(comparison.text(TOLD) + &pictures.iter().map(told).collect::<String>()));
        }
        let picture = |(frame, changed): &(u64, ChangedPixels)| json!({ "frame": frame, "changed": changed.pixels().len(), "seen": changed.seen() });
        let mut document = comparison.json();
        document["schema"] = "lunoid.timing.check/1".into();
        document["pictures"] = pictures.iter().map(picture).collect();
        document["baseline"] = self.baseline.display().to_string().into();
        print_json(&document)
    }
}

/// Of `known`, the frames that differ from the baseline.
fn changed_frames(comparison: &Comparison, known: &[u64]) -> Vec<u64> {
    let differ = comparison.frames.iter().filter(|frame| !frame.differences.is_empty());
    differ.map(|frame| frame.frame).filter(|frame| known.contains(frame)).collect()
}

fn frames_of(record: &TimingRecord) -> Vec<u64> {
    record.frames.iter().map(|frame| frame.frame).collect()
}

/// What the ideal model has for a key, as written.
fn ideal_value(key: &str) -> Option<String> {
    let ideal = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]).ok()?;
    ideal.values.into_iter().find(|value| value.key == key).map(|value| value.value)
}

#[cfg(test)]
mod tests {
    use super::ideal_value;

    #[test]
    fn a_key_that_is_left_out_means_the_ideal_one() {
        assert_eq!(ideal_value("level_turn.rate_deg_s").as_deref(), Some("\"never\""));
        assert_eq!(ideal_value("level_turn.rate"), None);
    }
}
