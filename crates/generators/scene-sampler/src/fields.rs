//! Frames as a machine begins them that gives a frame whole fields more where one is too short.

use std::sync::{Mutex, MutexGuard, PoisonError};

use generator::{FrameError, PrepareError, Stage};
use scenario::{Course, Pose};

/// What the machine does in a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Field {
    /// Frame that it works on.
    pub frame: u64,
    /// Whether that frame is complete when the field ends.
    pub is_complete: bool,
    /// Frame that was complete last before the field; none before the first one.
    pub before: Option<u64>,
}

impl Field {
    /// Frame whose picture the field shows: the one that it completes, or the last one again. None before the first one.
    pub fn shown(self) -> Option<u64> {
        if self.is_complete { Some(self.frame) } else { self.before }
    }
}

/// The frame that a picture shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Number of the frame.
    pub frame: u64,
    /// Pose of that frame.
    pub pose: Pose,
    /// Whether no picture has shown it before.
    pub is_new: bool,
    /// Whether nothing is complete yet: the picture is dark.
    pub is_dark: bool,
}

impl Shown {
    /// A picture that shows its own frame.
    pub fn own(frame: u64, pose: &Pose) -> Self {
        Self { frame, pose: *pose, is_new: true, is_dark: false }
    }

    /// The picture of a field of a mission.
    ///
    /// # Errors
    /// If the mission has no such frame.
    pub fn of(field: Field, course: &Course) -> Result<Self, FrameError> {
        let shown = field.shown();
        let frame = shown.unwrap_or(field.frame);
        let pose = pose(course, frame)?;
        Ok(Self { frame, pose, is_new: field.is_complete, is_dark: shown.is_none() })
    }
}

/// Pose of frame `frame` of a mission.
///
/// # Errors
/// If it is not among the frames of the mission.
pub fn pose(course: &Course, frame: u64) -> Result<Pose, FrameError> {
    let reason = || "it is not among the frames of the mission; choose one of those".to_owned();
    let pose = course.get(frame as usize).copied();
    pose.ok_or_else(|| FrameError::Refused { frame, reason: reason() })
}

/// Expects the course of the mission on a stage for `what` of a generator.
///
/// # Errors
/// If it is not there.
pub fn expect_course(stage: &Stage, generator: &'static str, what: &str) -> Result<(), PrepareError> {
    match stage.scenery.course().is_empty() {
        true => Err(PrepareError::Unsupported {
            generator,
            what: format!("{what} without the frames before"),
            remedy: "give the stage the course of its mission".into(),
        }),
        false => Ok(()),
    }
}

/// A frame that the machine has begun, with its fields.
#[derive(Debug, Clone, Copy)]
struct Begun {
    frame: u64,
    /// Field after its last one.
    end: u64,
}

/// The fields of a mission, as far as anybody has asked. How many fields a frame takes is worked out once, in order of frames.
#[derive(Debug, Default)]
pub struct Fields {
    begun: Mutex<Vec<Begun>>,
}

impl Fields {
    /// Field `number`. The machine begins frame 0 in field 0, and the frame of a field's number when the last one is complete.
    /// `take` counts the fields of a frame by itself, at least 1; it is told the frame that the machine began before, if any.
    ///
    /// # Errors
    /// Those of `take`.
    pub fn field(
        &self,
        number: u64,
        take: impl Fn(u64, Option<u64>) -> Result<u64, FrameError>,
    ) -> Result<Field, FrameError> {
        loop {
            let (next, before) = match self.known(number) {
                Ok(field) => return Ok(field),
                Err(next) => next,
            };
            // Fields are counted without the lock: that takes threads, which may come to wait for it.
            let end = next + take(next, before)?.max(1);
            let mut begun = self.lock();
            if begun.last().map_or(0, |last| last.end) == next {
                begun.push(Begun { frame: next, end });
            }
        }
    }

    /// Field `number`, or the next frame to count if that comes first, with the one that was begun before it.
    fn known(&self, number: u64) -> Result<Field, (u64, Option<u64>)> {
        let begun = self.lock();
        let place = begun.partition_point(|earlier| earlier.end <= number);
        let Some(Begun { frame, end }) = begun.get(place).copied() else {
            return Err((begun.last().map_or(0, |last| last.end), begun.last().map(|last| last.frame)));
        };
        let before = place.checked_sub(1).map(|before| begun[before].frame);
        Ok(Field { frame, is_complete: number + 1 == end, before })
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Begun>> {
        self.begun.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// Frames 0 and 3 take two fields, frame 5 three; frames 1, 4, 6 and 7 are never begun.
    #[test]
    fn a_frame_that_is_too_long_leaves_the_next_one_out() {
        let taken = Cell::new(0);
        let take = |frame: u64, before: Option<u64>| {
            taken.update(|count| count + 1);
            assert_eq!(
                before,
                [None, None, Some(0), Some(2), None, Some(3), None, None, Some(5)][frame as usize]
            );
            Ok([2, 9, 1, 2, 9, 3, 9, 9, 1][frame as usize])
        };
        let fields = Fields::default();
        let shown: Vec<_> = (0..9).map(|number| fields.field(number, take).unwrap().shown()).collect();
        let expected = [None, Some(0), Some(2), Some(2), Some(3), Some(3), Some(3), Some(5), Some(8)];
        assert_eq!(shown, expected);
        assert_eq!(taken.get(), 5, "each frame is counted once");
        // A field by itself is the same.
        let alone: Vec<_> =
            (0..9).map(|number| Fields::default().field(number, take).unwrap().shown()).collect();
        assert_eq!(alone, expected);
    }
}
