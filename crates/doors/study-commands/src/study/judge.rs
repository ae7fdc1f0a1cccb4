//! `lunoid study judge`: a generator against the judge, frame by frame.

use clap::Args;
use front_door::Opened;
use generator::PlaneKind;
use study::judged::judged_frame;
use study::report::{JudgedReport, is_of};

use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, choose_frames};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};
use text::Span;

const AFTER: &str = "Examples:
  lunoid study judge scenarios/lod-descent.toml --every 60
  lunoid study judge scenarios/lod-descent.toml --every 10 --out studies/judge
  lunoid study judge scenarios/first-light.toml --machine sampled --frames 0..30 --json

The generator of the scenario and exact draw each frame from the same pose. Distances are
compared where both show something, light in every pixel, in grey levels of 255. A pixel with
sky in one picture alone counts as outline. --out gets judge.json, judge.csv, judge.md and a
plot.";

/// Pictures of a generator against those of exact, frame by frame: distance and light.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct JudgeStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to look at: A..B, A.., ..B or one number. All if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// Look at one frame of so many.
    #[arg(long, value_name = "COUNT", default_value_t = 1, value_parser = values::whole(1..=100_000_u32))]
    every: u32,
    #[command(flatten)]
    outputs: Outputs,
}

impl JudgeStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.outputs.expect_apart(|file| is_of("judge", file), &self.stage.sources())?;
        let opened = self.stage.load()?;
        expect_distances(&opened)?;
        let report = self.threads.pool()?.install(|| self.report(&opened))?;
        if let Some(folder) = &self.outputs.out {
            report.leave(folder)?;
        }
        self.outputs.print(&report.json(), &report.text())?;
        Ok(Verdict::Yes)
    }

    fn report(&self, opened: &Opened) -> Result<JudgedReport, Failure> {
        let chosen = choose_frames(opened, self.frames)?;
        let stage = opened.stage()?;
        let table = opened.poses(&stage, chosen.clone()).map_err(Failure::input)?;
        let judge = registry::configure_with(registry::judge(), &[])?;
        let [own, right] = [&opened.generator, &judge].map(|generator| generator.prepare(stage.clone()));
        let (own, right) = (own.map_err(Failure::input)?, right.map_err(Failure::input)?);
        let mut frames = Vec::new();
        for (frame, row) in chosen.zip(table.rows()).step_by(self.every as usize) {
            let found =
                judged_frame([&*own, &*right], &stage.view, frame, &row.pose).map_err(Failure::input)?;
            self.outputs.say(&format!(
                "frame {frame}: rms {:.4} m, worst {:.4} m",
                found.metres.rms, found.metres.worst
            ));
            frames.push(found);
        }
        Ok(JudgedReport {
            commit: COMMIT.into(),
            title: opened.scenario.title.clone(),
            machine: opened.drawn_by().to_owned(),
            judge: judge.name().to_owned(),
            frames,
        })
    }
}

/// Refuses a generator that draws no distances.
fn expect_distances(opened: &Opened) -> Result<(), Failure> {
    if opened.generator.planes().contains(&PlaneKind::Distance) {
        return Ok(());
    }
    let (file, name) = (opened.scenario_file(), opened.drawn_by());
    Err(Failure::usage(format!(
        "{file}: {name} draws no distances; give --machine a generator that does, as sampled, lod-mesh or smooth-faces"
    )))
}
