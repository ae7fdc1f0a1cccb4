//! `lunoid sizing`: the arithmetic of the hardware report, section 4, measured by running; and what would just do.

mod level;
mod report;
mod search;
mod tear;

use clap::Args;
use front_door::Opened;
use generator::FrameError;
use machine::FrameSweeps;
use timing::TimingRecord;

use self::level::LevelFigures;
use self::report::Report;
use self::search::Search;
use self::tear::TearLaw;
use crate::commands::timing::rehearsal::{Rehearsal, choose, spread};
use crate::loading::{StageArgs, Threads, of_models};
use crate::output::{print, print_json, tell};
use crate::progress::Display;
use crate::values::{Span, positive};
use crate::{Failure, Verdict};

/// Frames that are measured where none are named, spread over the mission.
const USUAL_FRAMES: u64 = 3;

const AFTER: &str = "Example:
  lunoid sizing scenarios/first-light.toml --machine pra-nominal --sweeps 105

docs/timing.md says what each line is, and what a tear is that shows.";

/// Hold the machine in time against its formulas, and search for the slowest parts that would do.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
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
    /// Measure only.
    #[arg(long)]
    no_search: bool,
    /// No progress.
    #[arg(long)]
    no_progress: bool,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl Sizing {
    /// Measures, and searches.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let usual = |opened: &Opened| choose(opened, self.frames, spread(USUAL_FRAMES));
        let (rehearsal, frames) = Rehearsal::open(&self.stage, &self.threads, usual)?;
        let record = rehearsal.record(&frames, &Display::new(!self.no_progress))?;
        let report = self.report(&rehearsal, &frames, &record)?;
        if self.json {
            print_json(&report.json())?
        } else {
            print(&report.text())?
        }
        Ok(Verdict::Yes)
    }

    fn report(
        &self,
        rehearsal: &Rehearsal,
        frames: &[u64],
        record: &TimingRecord,
    ) -> Result<Report, Failure> {
        let poses = rehearsal.poses(frames)?;
        let law = TearLaw::new(&rehearsal.stage.settings.raster, self.shows);
        let sweeps = |row: &scenario::PoseRow| rehearsal.control.sweeps(row.frame, &row.pose);
        let levels = rehearsal.pool.install(|| {
            let frames = poses.iter().map(sweeps).collect::<Result<Vec<FrameSweeps<'_>>, _>>()?;
            Ok(LevelFigures::measure(rehearsal, &frames, &law))
        });
        let levels = levels.map_err(|error: FrameError| Failure::input(error))?;
        let searches = if self.no_search { Vec::new() } else { self.search(rehearsal, &poses, &law)? };
        Ok(Report::new(rehearsal, record, &levels, &poses, searches, self.shows))
    }

    fn search(
        &self,
        rehearsal: &Rehearsal,
        poses: &[scenario::PoseRow],
        law: &TearLaw,
    ) -> Result<Vec<Search>, Failure> {
        if !self.no_progress {
            tell("searching for the slowest parts\n");
        }
        rehearsal.pool.install(|| search::all(rehearsal, poses, law)).map_err(Failure::input)
    }
}
