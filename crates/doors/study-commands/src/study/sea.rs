//! `lunoid study sea`: contrast and spectrum of a sea of false normals beside a sea of waves.

use clap::Args;
use front_door::Opened;
use scenario::Pose;
use study::report::{SeaReport, is_of};
use study::sea::{SeaLook, WaveTheory};
use wind_waves::Wind;

use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, choose_frames};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict};
use text::Span;

const AFTER: &str = "Examples:
  lunoid study sea scenarios/sea-waves.toml --every 15 --out studies/sea
  lunoid study sea scenarios/sea-waves.toml --frames 0..300 --every 10 --columns 4 --json

The machine of the scenario draws its sea of false normals, and exact draws the waves of [sea]
waves. Pixels that show the sea in both are compared: contrast, spread, and the spectrum of
their light over time. Neither is an error of the other. --out gets sea.json, sea.csv with the
spectra, sea.md and a plot.";

/// Frames without which a spectrum says nothing.
const LEAST_FRAMES: usize = 8;

/// Contrast and spectrum of a sea of false normals beside a sea of true waves.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct SeaStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to look at: A..B, A.., ..B or one number. All if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// Look at one frame of so many.
    #[arg(long, value_name = "COUNT", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    every: u32,
    /// Look at so many columns of the picture, spread evenly.
    #[arg(long, value_name = "COUNT", default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=8192))]
    columns: u32,
    #[command(flatten)]
    outputs: Outputs,
}

impl SeaStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.outputs.expect_apart(|file| is_of("sea", file), &self.stage.sources())?;
        let opened = self.stage.load()?;
        let wind = wind(&opened)?;
        let pool = self.threads.pool()?;
        let report = pool.install(|| -> Result<SeaReport, Failure> {
            let look = self.look(&opened)?;
            self.outputs.say(opened.drawn_by());
            let imitation = look.imitation(&*opened.generator).map_err(Failure::input)?;
            self.outputs.say("exact");
            let waves = look.waves().map_err(Failure::input)?;
            let pixels = imitation.shared(&waves);
            if pixels.is_empty() {
                return Err(Failure::input(
                    "no pixel shows the sea in every frame of both: look at the sea, or choose other --frames or --columns",
                ));
            }
            let (first, last) = (&look.frames[0], &look.frames[look.frames.len() - 1]);
            let sun = look.stage.scenery.sun(first.1.time);
            Ok(SeaReport {
                commit: COMMIT.into(),
                title: opened.scenario.title.clone(),
                frames: [first.0, last.0, look.frames.len() as u64],
                pixels: pixels.len(),
                step_hz: look.step_hz(),
                figures: [&imitation, &waves].map(|film| film.figures(&pixels, look.step)),
                theory: WaveTheory::new(&wind, sun).map_err(Failure::input)?,
            })
        })?;
        if let Some(folder) = &self.outputs.out {
            report.leave(folder)?;
        }
        self.outputs.print(&report.json(), &report.text())?;
        Ok(Verdict::Yes)
    }

    /// Columns and frames that are asked for.
    fn look(&self, opened: &Opened) -> Result<SeaLook, Failure> {
        let stage = opened.stage()?;
        let chosen = choose_frames(opened, self.frames)?;
        let table = opened.poses(&stage, chosen.clone()).map_err(Failure::input)?;
        let poses = table.rows().iter().map(|row| row.pose);
        let frames: Vec<(u64, Pose)> = chosen.zip(poses).step_by(self.every as usize).collect();
        if frames.len() < LEAST_FRAMES {
            return Err(Failure::usage(format!(
                "{} frames are looked at: a spectrum needs {LEAST_FRAMES} or more; choose more --frames or a lower --every",
                frames.len()
            )));
        }
        let [per_second, seconds] = stage.view.update.fraction().map(|part| part as f64);
        let all = stage.view.columns;
        let count = self.columns.min(all);
        let columns = (0..count).map(|k| ((2 * k + 1) * all / (2 * count)) as usize).collect();
        Ok(SeaLook { stage, columns, frames, step: f64::from(self.every) * seconds / per_second })
    }
}

/// The wind of the scenario, and a machine that draws its sea of false normals.
fn wind(opened: &Opened) -> Result<Wind, Failure> {
    let sea = opened.scenario.faces.sea.as_ref();
    let Some(wind) = sea.and_then(|sea| sea.waves) else {
        return Err(Failure::input(
            "the scenario has no `waves` in `[sea]`; give one that has them, as scenarios/sea-waves.toml",
        ));
    };
    if opened.drawn_by() == exact::ROW.name {
        return Err(Failure::usage(
            "--machine exact: it draws the waves; choose who draws false normals: --machine smooth-faces",
        ));
    }
    Ok(wind)
}
