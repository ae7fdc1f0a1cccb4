//! Frames as a machine begins them that gives a frame whole fields more where one is too short.

use std::sync::OnceLock;

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

/// The fields of a mission, as many as it has frames. How many fields a frame takes is worked out once.
#[derive(Debug)]
pub struct Fields {
    taken: Vec<OnceLock<u64>>,
}

impl Fields {
    /// Fields of a mission of so many frames.
    pub fn of(frames: usize) -> Self {
        Self { taken: (0..frames).map(|_| OnceLock::new()).collect() }
    }

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
        let (mut frame, mut before) = (0, None);
        loop {
            let end = frame + self.taken(frame, &take)?;
            if number < end {
                return Ok(Field { frame, is_complete: number + 1 == end, before });
            }
            (frame, before) = (end, Some(frame));
        }
    }

    fn taken(&self, frame: u64, take: impl Fn(u64) -> Result<u64, FrameError>) -> Result<u64, FrameError> {
        let known = self.taken.get(frame as usize);
        if let Some(taken) = known.and_then(OnceLock::get) {
            return Ok(*taken);
        }
        let taken = take(frame)?.max(1);
        Ok(known.map_or(taken, |cell| *cell.get_or_init(|| taken)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames 0 and 3 take two fields, frame 5 three; frames 1, 4, 6 and 7 are never begun.
    #[test]
    fn a_frame_that_is_too_long_leaves_the_next_one_out() {
        let take = |frame: u64| Ok([2, 9, 1, 2, 9, 3, 9, 9, 1][frame as usize]);
        let fields = Fields::of(9);
        let shown: Vec<_> = (0..9).map(|number| fields.field(number, take).unwrap().shown()).collect();
        let expected = [None, Some(0), Some(2), Some(2), Some(3), Some(3), Some(3), Some(5), Some(8)];
        assert_eq!(shown, expected);
        // A field by itself is the same.
        let alone: Vec<_> = (0..9).map(|number| Fields::of(9).field(number, take).unwrap().shown()).collect();
        assert_eq!(alone, expected);
    }
}
