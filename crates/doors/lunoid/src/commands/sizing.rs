//! `lunoid sizing`: the arithmetic of the hardware report, section 4, measured by running; and what would just do.

use clap::Args;
use deadlines::sizing::Report;
use deadlines::{Other, Rehearsal, Rehearsed, sizing, spread};
use front_door::Opened;

use crate::rehearsing::{choose, expect_deadlines, record, rehearse_timed};
use command_line::loading::{StageArgs, Threads, of_deadlines};
use command_line::output::{print, print_json, tell};
use command_line::values::positive;
use command_line::{Failure, Verdict};
use text::Span;
use timing::TimingRecord;

/// Frames that are measured where none are named, spread over the mission.
const USUAL_FRAMES: u64 = 3;

const AFTER: &str = "Example:
  lunoid sizing scenarios/first-light.toml --machine pra-nominal --sweeps 105

docs/timing.md says what each line is, and what a tear is that shows.";

/// Hold a machine in time against its formulas, and search for the slowest parts of a hardware model that would do.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_deadlines))]
pub struct Sizing {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to measure, counted at the update rate: A..B without B. Three, spread over the mission, if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// Step of the ground that shows as a tear, in lines of the picture.
    #[arg(long, value_name = "LINES", value_parser = positive, default_value_t = 0.5)]
    shows: f64,
    /// Measure only; do not search.
    #[arg(long)]
    no_search: bool,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
}

impl Sizing {
    /// Measures the frames, searches for the slowest parts, and prints the report.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let usual = |opened: &Opened| {
            expect_deadlines(opened)?;
            choose(opened, self.frames, spread(USUAL_FRAMES))
        };
        let (rehearsal, frames) = rehearse_timed(&self.stage, &self.threads, usual)?;
        let report = match &rehearsal {
            Rehearsed::Machine(machine) => self.of_machine(machine, &frames)?,
            Rehearsed::Other(other) => {
                of_other(other, &record(!self.no_progress, |hear| rehearsal.record(&frames, hear))?)?
            }
        };
        match self.json {
            true => print_json(&report.json())?,
            false => print(&report.text())?,
        }
        Ok(Verdict::Yes)
    }

    fn of_machine(&self, rehearsal: &Rehearsal, frames: &[u64]) -> Result<Report, Failure> {
        let record = record(!self.no_progress, |hear| rehearsal.record(frames, hear))?;
        let sizing = sizing::Sizing::new(rehearsal, frames, self.shows)?;
        let report = sizing.report(&record)?;
        if self.no_search {
            return Ok(report);
        }
        if !self.no_progress {
            tell("searching for the slowest parts\n");
        }
        Ok(report.with(sizing.search()?))
    }
}

/// A generator has formulas, and no parts to search for.
fn of_other(other: &Other, record: &TimingRecord) -> Result<Report, Failure> {
    Report::of(other, record).ok_or_else(|| {
        let name = &record.machine;
        Failure::usage(format!("--machine {name}: it has no formulas; expected a hardware model"))
    })
}
