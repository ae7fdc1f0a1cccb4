//! Forward: from late words to the pixels that they changed.

use std::iter::once;

use control_plane::{ControlPlane, LateCrossing, MachineStage};
use generator::{FrameError, PlaneKind};
use machine::{OnTime, Twice};
use picture::{ChangedPixels, Depth, Encoder, PictureError, Transfer};
use scenario::Pose;
use sweep_program::SweepProgram;

use crate::late::{LEVELS, Late, late_words};

/// What the words that one fold found missing changed in the pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct LateEffect {
    /// The fold that found them missing.
    pub late: LateCrossing,
    /// The words; those still in force are wrong up to the end of the sweep.
    pub words: Vec<Late>,
    /// The frame of the words, then every later frame that can differ.
    pub frames: Vec<FrameEffect>,
    /// Which later frames can differ, and why no other can.
    pub later: String,
}

/// What late words changed in one picture.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameEffect {
    /// Frame of the mission, from 0.
    pub frame: u64,
    /// Time of the frame (s).
    pub time_s: f64,
    /// Pixels that are not as they would be with the words on time, in levels of 8 bits: what the lateness added or took.
    pub changed: ChangedPixels,
}

/// Why the effect of late words cannot be told.
#[derive(Debug, thiserror::Error)]
pub enum LateError {
    /// The frame, or one before that a tube still shows, cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// Pictures cannot be compared.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// There is no such sweep.
    #[error("{sweep}:{crossing}: a frame has sweeps 0..{sweeps}; expected one of them")]
    Sweep {
        /// Sweep that was asked for.
        sweep: u32,
        /// Crossing that was asked for.
        crossing: u32,
        /// Sweeps of a frame.
        sweeps: u32,
    },
    /// There is no such level.
    #[error(
        "{sweep}:{crossing}, coarse level: the machine draws one level of terrain; expected the fine one"
    )]
    Level {
        /// Sweep that was asked for.
        sweep: u32,
        /// Crossing that was asked for.
        crossing: u32,
    },
    /// No word was late there.
    #[error("{sweep}:{crossing}: {found}")]
    NotLate {
        /// Sweep that was asked for.
        sweep: u32,
        /// Crossing that was asked for.
        crossing: u32,
        /// What the sweep has instead, and where words were late.
        found: String,
    },
}

/// What the words that `late` names changed, on `stage` drawn by `machine` whose digital side is `control`; `pose` is that
/// of their frame. Only their sweep is drawn twice. Threads of the current pool draw.
///
/// # Errors
/// If no word was late there, or a frame cannot be drawn.
pub fn late_effect(
    machine: &dyn Twice,
    (stage, control): (&MachineStage, &ControlPlane),
    pose: &Pose,
    late: LateCrossing,
) -> Result<LateEffect, LateError> {
    let words = words(stage, control, pose, late)?;
    let on_time = OnTime { late, again: late.sweep..late.sweep + 1 };
    let settings = &stage.settings;
    let transfer = Transfer::new(settings.display.white as f32, settings.display.gamma as f32)?;
    let encoder = Encoder::new(transfer, Depth::Eight);
    let size = [settings.raster.columns, settings.raster.lines].map(|count| count as usize);
    let effect = |(frame, pose): (u64, &Pose)| {
        let [is, would_be] = machine.twice(frame, pose, &on_time)?;
        let both = [&would_be, &is].map(|planes| planes.get(PlaneKind::Intensity).unwrap_or_default());
        let changed = ChangedPixels::between(&encoder, both, size)?;
        Ok(FrameEffect { frame, time_s: pose.time, changed })
    };
    let shown = machine.later(late.frame);
    let course = stage.scenery.course();
    let later = shown.iter().map_while(|&frame| Some((frame, course.get(frame as usize)?)));
    let frames: Vec<FrameEffect> =
        once((late.frame, pose)).chain(later).map(effect).collect::<Result<_, LateError>>()?;
    Ok(LateEffect { late, words, later: told_later(&shown, &frames), frames })
}

/// The late words that are asked for.
fn words(
    stage: &MachineStage,
    control: &ControlPlane,
    pose: &Pose,
    late: LateCrossing,
) -> Result<Vec<Late>, LateError> {
    let LateCrossing { frame, sweep, level, crossing } = late;
    let sweeps = stage.settings.raster.sweeps;
    if sweep >= sweeps {
        return Err(LateError::Sweep { sweep, crossing, sweeps });
    }
    let all = control.sweeps(frame, pose)?;
    let programs = all.programs(sweep);
    let Some(program) = programs.get(level) else { return Err(LateError::Level { sweep, crossing }) };
    let words = late_words(program, level, crossing);
    if !words.is_empty() {
        return Ok(words);
    }
    let has_late =
        |sweep: &u32| all.programs(*sweep).iter().any(|program| !program.late_crossings().is_empty());
    let found = not_late(&programs, late, || (0..sweeps).filter(has_late).collect());
    Err(LateError::NotLate { sweep, crossing, found })
}

/// What to say of a crossing that was not late: late ones of the sweep, or else sweeps that have some.
fn not_late(programs: &[SweepProgram], late: LateCrossing, sweeps: impl FnOnce() -> Vec<u32>) -> String {
    let LateCrossing { frame, sweep, level, crossing } = late;
    let folds = programs[level].steps.iter().filter(|step| step.kind.fold().is_some()).count();
    let there = match crossing < folds as u32 {
        true => "no word that this crossing wanted was late".to_owned(),
        false => format!("the {} level has crossings 0..{folds} in sweep {sweep}", LEVELS[level]),
    };
    let of_level = programs.iter().zip(LEVELS).map(|(program, level)| (program.late_crossings(), level));
    let of_sweep: Vec<String> = of_level
        .filter(|(late, _)| !late.is_empty())
        .map(|(late, level)| format!("{} ({level} level)", some_of(&late)))
        .collect();
    if !of_sweep.is_empty() {
        return format!(
            "{there}; late in sweep {sweep} of frame {frame} are crossings {}",
            of_sweep.join("; ")
        );
    }
    match sweeps().as_slice() {
        [] => format!(
            "{there}, and none of frame {frame}; choose a model whose loader takes time, or another frame"
        ),
        sweeps => format!(
            "{there}, and none of sweep {sweep}; sweeps with late words in frame {frame} are {}",
            some_of(sweeps)
        ),
    }
}

/// Numbers, and how many more there are.
fn some_of(numbers: &[u32]) -> String {
    const MOST: usize = 20;
    let told: Vec<String> = numbers.iter().take(MOST).map(u32::to_string).collect();
    match numbers.len().saturating_sub(MOST) {
        0 => told.join(", "),
        more => format!("{} and {more} more", told.join(", ")),
    }
}

/// Which later frames can differ: of `shown`, in which a tube still shows the frame, the mission has those in `frames`.
fn told_later(shown: &[u64], frames: &[FrameEffect]) -> String {
    const NOTHING_ELSE: &str = "every sweep begins with full registers and with its own set-up, and the storage buffers hold the \
                                words whenever a register takes them";
    let numbers: Vec<String> = frames[1..].iter().map(|effect| effect.frame.to_string()).collect();
    match (shown, numbers.as_slice()) {
        ([], _) => format!("no later frame can change: {NOTHING_ELSE}; no tube keeps a picture"),
        (_, []) => format!(
            "no later frame can change: {NOTHING_ELSE}; a tube would show the frame longer than the mission lasts"
        ),
        _ => format!(
            "later frames that can change: {}, in which a tube still shows this frame. No other can: {NOTHING_ELSE}",
            numbers.join(", ")
        ),
    }
}
