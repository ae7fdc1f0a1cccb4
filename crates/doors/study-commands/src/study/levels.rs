//! `lunoid study levels`: what levels of detail lose, against triangles and time.

use std::ops::Range;

use clap::Args;
use generator::ErrorLadder;
use scenario::Pose;
use study::levels::{Looks, level_ladder, mark_fronts};
use study::report::{LevelReport, is_of};

use super::error::failure;
use super::level_ladders::chosen;
use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, choose_frames, levelled};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};
use text::Span;

/// Frames that are looked at, and turns that are timed, if nothing is asked for.
const FRAMES: u64 = 9;
const REPETITIONS: u32 = 5;

const AFTER: &str = "Examples:
  lunoid study levels scenarios/lod-landing.toml
  lunoid study levels scenarios/lod-descent.toml --count 5 --only tolerance --out studies/levels
  lunoid study levels scenarios/lod-descent.toml --frames 600..1200 --only one-level --json

Ladders are those of the generator that are held against its finest ground alone. The error of a
rung is that of the drawn ground at the posts of the finest mesh inside the picture: in metres,
in pixels across the line of sight (height x focal length / distance), and as what places are
moved by in the picture. Times are of one thread of this computer; triangles do not depend on
it. --out gets levels.json, levels.csv, levels.md and two plots: error against time and against
triangles, each with its Pareto front.";

/// Levels of detail against what is lost: triangles, error, time, and what nothing beats.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct LevelStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to look at: A..B, A.., ..B or one number. All if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// How many of these frames are drawn, evenly spread over them.
    #[arg(long, value_name = "N", default_value_t = FRAMES, value_parser = values::whole(1..=1000_u64))]
    count: u64,
    /// Turns over all frames that are timed.
    #[arg(long, value_name = "N", default_value_t = REPETITIONS, value_parser = values::whole(1..=1000_u32))]
    repetitions: u32,
    /// This ladder alone; may be given several times.
    #[arg(long, value_name = "LADDER")]
    only: Vec<String>,
    #[command(flatten)]
    outputs: Outputs,
}

impl LevelStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.outputs.expect_apart(|file| is_of("levels", file), &self.stage.sources())?;
        let opened = self.stage.load()?;
        let ladders = chosen(levelled(&opened)?, &self.only)?;
        let all = choose_frames(&opened, self.frames)?;
        let one = Threads::one()?;
        let report = self.threads.pool()?.install(|| -> Result<LevelReport, Failure> {
            let stage = opened.stage()?;
            let table = opened.poses(&stage, all.clone()).map_err(Failure::input)?;
            let pose = |frame: u64| (frame, table.rows()[(frame - all.start) as usize].pose);
            let frames: Vec<(u64, Pose)> = spread(&all, self.count).map(pose).collect();
            let looks = Looks { stage: &stage, frames: &frames, repetitions: self.repetitions, one: &one };
            let configure =
                |sets: &[(&str, &str)]| opened.configure_with(sets).map_err(|error| error.to_string());
            let climb = |ladder: &ErrorLadder| {
                self.outputs.say(ladder.what);
                let mut hear = |label: &str| self.outputs.say(&format!("  {label}"));
                level_ladder((ladder, &configure), &looks, &mut hear).map_err(failure)
            };
            let mut ladders = ladders.into_iter().map(climb).collect::<Result<Vec<_>, _>>()?;
            mark_fronts(&mut ladders);
            Ok(LevelReport {
                commit: COMMIT.into(),
                title: opened.scenario.title.clone(),
                machine: opened.drawn_by().to_owned(),
                frames: frames.iter().map(|(frame, _)| *frame).collect(),
                repetitions: self.repetitions,
                ladders,
            })
        })?;
        if let Some(folder) = &self.outputs.out {
            report.leave(folder)?;
        }
        self.outputs.print(&report.json(), &report.text())?;
        Ok(Verdict::Yes)
    }
}

/// So many of `frames`, each in the middle of its equal part of them; all of fewer.
fn spread(frames: &Range<u64>, count: u64) -> impl Iterator<Item = u64> {
    let (first, all) = (frames.start, frames.end - frames.start);
    let count = count.min(all);
    (0..count).map(move |index| first + (2 * index + 1) * all / (2 * count))
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn frames_are_spread_evenly() {
        assert_eq!(spread(&(0..1800), 3).collect::<Vec<_>>(), [300, 900, 1500]);
        assert_eq!(spread(&(7..9), 9).collect::<Vec<_>>(), [7, 8]);
        assert_eq!(spread(&(5..6), 1).collect::<Vec<_>>(), [5]);
    }
}
