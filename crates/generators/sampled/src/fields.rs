//! Frames as a machine begins them that gives a frame whole fields more where one is too short.

use std::sync::{Mutex, MutexGuard, PoisonError};

use generator::FrameError;

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
    /// `take` counts the fields of a frame by itself, at least 1.
    ///
    /// # Errors
    /// Those of `take`.
    pub fn field(
        &self,
        number: u64,
        take: impl Fn(u64) -> Result<u64, FrameError>,
    ) -> Result<Field, FrameError> {
        loop {
            let next = match self.known(number) {
                Ok(field) => return Ok(field),
                Err(next) => next,
            };
            // Fields are counted without the lock: that takes threads, which may come to wait for it.
            let end = next + take(next)?.max(1);
            let mut begun = self.lock();
            if begun.last().map_or(0, |last| last.end) == next {
                begun.push(Begun { frame: next, end });
            }
        }
    }

    /// Field `number`, or the next frame to count if that comes first.
    fn known(&self, number: u64) -> Result<Field, u64> {
        let begun = self.lock();
        let place = begun.partition_point(|earlier| earlier.end <= number);
        let Some(Begun { frame, end }) = begun.get(place).copied() else {
            return Err(begun.last().map_or(0, |last| last.end));
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
        let take = |frame: u64| {
            taken.update(|count| count + 1);
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
