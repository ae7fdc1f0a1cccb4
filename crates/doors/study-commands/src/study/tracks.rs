//! `lunoid study tracks`: corners that are followed while levels of detail change.

use std::ops::Range;

use clap::Args;
use front_door::Opened;
use generator::{Session, Stage};
use scenario::Pose;
use study::report::{LadderTracks, TrackReport, is_of};
use study::tracks::{Flight, TrackOutcome, distances, flown, held};

use super::error::failure;
use super::level_ladders::chosen;
use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, choose_frames, levelled};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict};
use text::Span;

/// Frames that are looked at if none are asked for.
const FRAMES: u64 = 100;

const AFTER: &str = "Examples:
  lunoid study tracks scenarios/lod-landing.toml --only one-level
  lunoid study tracks scenarios/lod-descent.toml --frames 840..940 --out studies/tracks
  lunoid study tracks scenarios/lod-descent.toml --set lod.tolerance_px=8 --only tolerance --json

Corners of the first picture are followed from frame to frame, in each way that the generator
has for levels of detail. First the camera stands at the middle frame and levels go on: a corner
should stay. Then the camera flies: a corner should be where the distance of the finest ground
and the poses put it. At last each rung of the ladders of levels is flown. A jump is a step of
more than 0.1 pixel off the true one. --out gets tracks.json, tracks.csv with every frame,
tracks.md and a plot.";

/// Corners that are followed over frames while levels of detail change: a stand-in for navigation by camera.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct TrackStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to look at: A..B, A.. or ..B, at least two. The 100 in the middle of the mission if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// This ladder alone; may be given several times.
    #[arg(long, value_name = "LADDER")]
    only: Vec<String>,
    #[command(flatten)]
    outputs: Outputs,
}

impl TrackStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.outputs.expect_apart(|file| is_of("tracks", file), &self.stage.sources())?;
        let opened = self.stage.load()?;
        let row = levelled(&opened)?;
        let ladders = chosen(row, &self.only)?;
        let frames = self.chosen(&opened)?;
        let report = self.threads.pool()?.install(|| -> Result<TrackReport, Failure> {
            let stage = opened.stage()?;
            let table = opened.poses(&stage, frames.clone()).map_err(Failure::input)?;
            let poses: Vec<Pose> = table.rows().iter().map(|row| row.pose).collect();
            let flight = Flight { view: &stage.view, first: frames.start, poses: &poses };
            let prepare = |sets: &[(&str, &str)]| prepare(&opened, &stage, sets);
            let finest = prepare(row.details[0].sets)?;
            let truth = distances(&*finest, &flight).map_err(failure)?;
            drop(finest);
            let (mut standing, mut flying) = (Vec::new(), Vec::new());
            for (number, way) in row.details.iter().enumerate() {
                self.outputs.say(way.name);
                let session = prepare(way.sets)?;
                // The finest ground alone has no levels that go on.
                if number > 0 {
                    standing.push(held(way.name, &*session, &flight).map_err(failure)?);
                }
                flying.push(flown(way.name, &*session, &flight, &truth).map_err(failure)?);
            }
            let mut climbed = Vec::new();
            for ladder in ladders {
                self.outputs.say(ladder.what);
                let rung = |(value, _): &(&'static str, f64)| -> Result<TrackOutcome, Failure> {
                    let label = value.trim_matches('"');
                    self.outputs.say(&format!("  {label}"));
                    let sets: Vec<_> = ladder.fixed.iter().copied().chain([(ladder.key, *value)]).collect();
                    flown(label, &*prepare(&sets)?, &flight, &truth).map_err(failure)
                };
                let rungs = ladder.rungs.iter().map(rung).collect::<Result<_, _>>()?;
                climbed.push(LadderTracks { name: ladder.name, what: ladder.what, rungs });
            }
            Ok(TrackReport {
                commit: COMMIT.into(),
                title: opened.scenario.title.clone(),
                machine: opened.drawn_by().to_owned(),
                first: frames.start,
                times: poses.iter().map(|pose| pose.time).collect(),
                held: standing,
                flown: flying,
                ladders: climbed,
            })
        })?;
        if report.flown.iter().all(|outcome| outcome.tracks.is_empty()) {
            let title = format!("frames {}..{}: no corner to follow", frames.start, frames.end);
            return Err(Failure::input(format!("{title}; look at lit ground, or choose other --frames")));
        }
        if let Some(folder) = &self.outputs.out {
            report.leave(folder)?;
        }
        self.outputs.print(&report.json(), &report.text())?;
        Ok(Verdict::Yes)
    }

    /// The frames asked for, or those in the middle of the mission.
    fn chosen(&self, opened: &Opened) -> Result<Range<u64>, Failure> {
        let frames = match self.frames {
            Some(span) => choose_frames(opened, Some(span))?,
            None => middle(opened.frames()),
        };
        match frames.end - frames.start {
            0 | 1 => Err(Failure::usage(format!(
                "--frames {}..{}: one frame; expected at least two, for a track goes from frame to frame",
                frames.start, frames.end
            ))),
            _ => Ok(frames),
        }
    }
}

/// The generator with some keys set over the scenario's own, made ready.
fn prepare(opened: &Opened, stage: &Stage, sets: &[(&str, &str)]) -> Result<Box<dyn Session>, Failure> {
    opened.configure_with(sets)?.prepare(stage.clone()).map_err(Failure::input)
}

/// The frames in the middle of so many.
fn middle(all: u64) -> Range<u64> {
    let count = FRAMES.min(all);
    let first = (all - count) / 2;
    first..first + count
}

#[cfg(test)]
mod tests {
    use super::middle;

    #[test]
    fn a_hundred_frames_lie_in_the_middle() {
        assert_eq!((middle(1800), middle(600), middle(40)), (850..950, 250..350, 0..40));
    }
}
