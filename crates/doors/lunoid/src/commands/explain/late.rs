//! `lunoid explain --late`: from late words to the pixels that they changed.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use deadlines::Rehearsal;
use event_list::{LEVELS, LatePlace, PlaceOf};
use explain::{LateEffect, LateError, boundary_at, late_effect};
use front_door::Opened;
use machine::{FrameSweeps, LateOf, LateWords, prepare_twice};

use crate::commands::{again::command, changed};
use crate::frame::FrameArgs;
use command_line::loading::StageArgs;
use command_line::output::{expect_outputs, print, print_json};
use command_line::{Failure, Verdict};

/// Late words in place of a pixel.
#[derive(Debug, Args)]
pub struct LateArgs {
    /// Late words instead of a pixel: the sweep and the crossing that found them missing, both from 0; the sweep and a crater
    /// (260:crater.7) or a shadow boundary (260:boundary.3); or the line of `lunoid trace` that tells them, as text, CSV or JSON.
    /// Only of the hybrid machine.
    #[arg(long, value_name = "SWEEP:PLACE|LINE", conflicts_with_all = ["pixel", "no_exact"])]
    pub late: Option<LatePlace>,
    /// Level of terrain of the crossing, where the words are named by SWEEP:CROSSING [default: fine].
    #[arg(long, value_name = "LEVEL", requires = "late", value_parser = PossibleValuesParser::new(LEVELS))]
    level: Option<String>,
    /// Write a PNG for each frame that can differ, changed-NNNNNN.png: changed pixels on the dimmed picture, orange where the
    /// lateness made them brighter, blue where darker.
    #[arg(long, value_name = "FOLDER", requires = "late")]
    pictures: Option<PathBuf>,
}

impl LateArgs {
    /// Tells what the words at `place` changed. `chosen` names the frame and the machine; then what was asked for, and the stage that it is.
    pub fn explain(
        &self,
        place: LatePlace,
        (chosen, [asked, stage]): (&FrameArgs, [&StageArgs; 2]),
        opened: Opened,
        json: bool,
    ) -> Result<Verdict, Failure> {
        let outputs: Vec<_> = self.pictures.iter().map(|folder| changed::place(folder)).collect();
        expect_outputs(&outputs, &stage.sources())?;
        let rehearsal = Rehearsal::new(opened, chosen.threads.pool()?)?;
        let Rehearsal { stage: machine, control, pool, .. } = &rehearsal;
        let frame = chosen.frame;
        let pose = rehearsal.poses(&[frame])?[0].pose;
        let twice = prepare_twice(machine.clone());
        let told = pool.install(|| {
            let sweeps = match place.of.needs_gates() {
                true => control.sweeps_with_gates(frame, &pose),
                false => control.sweeps(frame, &pose),
            }?;
            let late = LateWords { frame, sweep: place.sweep, of: self.asked(place, &sweeps)? };
            late_effect(&*twice, (machine, &sweeps), &pose, late).map_err(failure)
        })?;
        if let Some(folder) = &self.pictures {
            told.frames
                .iter()
                .try_for_each(|effect| changed::write(folder, effect.frame, &effect.changed))?;
        }
        match json {
            true => print_json(&told.json())?,
            false => print(&(told.text() + "\n" + &next(&told, asked)))?,
        }
        Ok(Verdict::Yes)
    }

    /// What waited for the words at `place` of the frame of `sweeps`.
    fn asked(&self, place: LatePlace, sweeps: &FrameSweeps<'_>) -> Result<LateOf, Failure> {
        match place.of {
            PlaceOf::Said(of) => Ok(of),
            PlaceOf::Crossing(crossing) => {
                let level = LEVELS.iter().position(|name| self.level.as_deref() == Some(name));
                Ok(LateOf::Crossing { level: level.unwrap_or(0), crossing })
            }
            PlaceOf::LineGenerator(number, range) => boundary_at(sweeps, place.sweep, number, range).ok_or_else(|| {
                Failure::usage(format!(
                    "--late: no word of line-generator.{number} was late at {range} m in sweep {} of this frame; expected a line of \
                     this frame, scenario and model",
                    place.sweep
                ))
            }),
        }
    }
}

/// Option and value that name the words of a crossing.
pub fn option(sweep: u32, late: &explain::Late) -> String {
    let level = if late.level == LEVELS[0] { String::new() } else { format!(" --level {}", late.level) };
    format!("--late {sweep}:{}{level}", late.crossing)
}

/// Commands that go on: the pixel that changed most, and the events of the sweep.
fn next(told: &LateEffect, stage: &StageArgs) -> String {
    let LateWords { frame, sweep, .. } = told.late;
    let largest = told.frames[0].changed.largest();
    let pixel = largest.map(|pixel| ("explain", format!("--pixel {},{}", pixel.column, pixel.line)));
    let commands = pixel.into_iter().chain([("trace", format!("--sweep {sweep}"))]);
    commands.map(|(name, rest)| command(name, stage, frame, &rest) + "\n").collect()
}

fn failure(error: LateError) -> Failure {
    match error {
        LateError::Frame(error) => error.into(),
        LateError::Picture(error) => Failure::input(error),
        LateError::Sweep { .. } | LateError::Level { .. } | LateError::NotLate { .. } => {
            Failure::usage(format!("--late {error}"))
        }
    }
}
