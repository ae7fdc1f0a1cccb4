//! Forward: from late words to the pixels that they changed.

use std::iter::once;
use std::ops::Range;

use control_plane::{FrameSweeps, LateOf, LateWords, MachineStage};
use generator::{FrameError, PlaneKind};
use machine::{OnTime, Twice};
use picture::{ChangedPixels, Depth, Encoder, PictureError, Transfer};
use scenario::Pose;
use serde::Serialize;

use crate::late::{Late, LateLoad, late_words};
use crate::not_late::{no_late_load, no_late_word, place_of};

/// What late words changed in the pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct LateEffect {
    /// What waited for them, and in which sweep.
    pub late: LateWords,
    /// The words themselves, and when they came.
    pub missed: Missed,
    /// The frame of the words, then every later frame that can differ.
    pub frames: Vec<FrameEffect>,
    /// Which later frames can differ, and why no other can.
    pub later: String,
}

/// Words that were late.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Missed {
    /// Those that one fold found missing; what is in force is wrong up to the end of the sweep.
    Words(Vec<Late>),
    /// Those of a crater or of a shadow boundary, a single entry.
    Load([LateLoad; 1]),
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
    #[error("{place}: a frame has sweeps 0..{sweeps}; expected one of them")]
    Sweep {
        /// What was asked for.
        place: String,
        /// Sweeps of a frame.
        sweeps: u32,
    },
    /// There is no such level.
    #[error("{place}, coarse level: the machine draws one level of terrain; expected the fine one")]
    Level {
        /// What was asked for.
        place: String,
    },
    /// No word was late there.
    #[error("{place}: {found}")]
    NotLate {
        /// What was asked for.
        place: String,
        /// What the sweep has instead, and where words were late.
        found: String,
    },
}

/// What the words that `late` names changed, on `stage` drawn by `machine`; `sweeps` are those of their frame as its digital side makes
/// them from `pose`, with shadow gates where a boundary is asked for. Only sweeps that the words can change are drawn twice. Threads of
/// the current pool draw.
///
/// # Errors
/// If no word was late there, or a frame cannot be drawn.
pub fn late_effect(
    machine: &dyn Twice,
    (stage, sweeps): (&MachineStage, &FrameSweeps<'_>),
    pose: &Pose,
    late: LateWords,
) -> Result<LateEffect, LateError> {
    let missed = missed(stage, sweeps, late)?;
    let on_time = OnTime { late, again: again(stage, sweeps, late) };
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
    Ok(LateEffect { late, missed, later: told_later(&shown, &frames), frames })
}

/// Sweeps that the words can change: their own, or for a shadow boundary all that are drawn with the same set-up.
fn again(stage: &MachineStage, sweeps: &FrameSweeps<'_>, late: LateWords) -> Range<u32> {
    let LateOf::Boundary(_) = late.of else { return late.sweep..late.sweep + 1 };
    let set_up = sweeps.set_up_of(late.sweep);
    let is_alike = |sweep: &u32| sweeps.set_up_of(*sweep) == set_up;
    let last = (late.sweep..stage.settings.raster.sweeps).take_while(is_alike).last();
    set_up..last.unwrap_or(late.sweep) + 1
}

/// The late words that are asked for.
fn missed(stage: &MachineStage, sweeps: &FrameSweeps<'_>, late: LateWords) -> Result<Missed, LateError> {
    let (place, count) = (place_of(late), stage.settings.raster.sweeps);
    if late.sweep >= count {
        return Err(LateError::Sweep { place, sweeps: count });
    }
    let found = match late.of {
        LateOf::Crossing { level, crossing } => {
            let programs = sweeps.programs(late.sweep);
            let Some(program) = programs.get(level) else { return Err(LateError::Level { place }) };
            let words = late_words(program, level, crossing);
            match words.is_empty() {
                true => Err(no_late_word(sweeps, late, (level, crossing), count)),
                false => Ok(Missed::Words(words)),
            }
        }
        LateOf::Crater(_) | LateOf::Boundary(_) => {
            let misses = sweeps.load_misses(late.sweep);
            let load = misses.iter().find(|miss| miss.of == late.of);
            load.map(|miss| Missed::Load([LateLoad::of(miss)])).ok_or_else(|| no_late_load(&misses, late))
        }
    };
    found.map_err(|found| LateError::NotLate { place, found })
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
