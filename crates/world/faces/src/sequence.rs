//! Faces or objects that take turns.

use crate::error::{FaceError, within};

/// Order in which the members of a sequence show.
#[derive(Debug, Clone, PartialEq)]
pub enum Mode {
    /// From the first to the last, then again (reported).
    Cycle,
    /// From the first to the last, which stays.
    Once,
    /// To the last and back; both ends show once a turn.
    PingPong,
    /// By the value of a signal.
    Driven(Drive),
}

/// How a signal chooses a member: member 0 below `low + step`, then one more for each `step`.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Name of the signal.
    pub signal: String,
    /// Value at which member 0 begins, in the signal's unit.
    pub low: f64,
    /// Width of one member, in the signal's unit, not 0.
    pub step: f64,
}

/// Members that show one at a time, each for the same number of frames.
#[derive(Debug, Clone, PartialEq)]
pub struct Sequence<T> {
    members: Vec<T>,
    frames: u64,
    start: i64,
    mode: Mode,
}

impl<T> Sequence<T> {
    /// Members that show for `frames` frames each, the first of them from frame `start` (any sign).
    ///
    /// # Errors
    /// If no member is given, one is missing, `frames` is 0, or a drive is not finite or has step 0.
    pub fn new(members: Vec<Option<T>>, frames: u64, start: i64, mode: Mode) -> Result<Self, FaceError> {
        let count = members.len();
        within("number of members", count as f64, count > 0, "1 or more")?;
        within("frames of a member", frames as f64, frames > 0, "1 or more")?;
        if let Mode::Driven(drive) = &mode {
            within("low end of a drive", drive.low, true, "a finite number")?;
            within("step of a drive", drive.step, drive.step != 0.0, "a finite number other than 0")?;
        }
        let found = |(missing, member): (usize, Option<T>)| {
            member.ok_or(FaceError::MissingMember { missing, members: count })
        };
        let members = members.into_iter().enumerate().map(found).collect::<Result<_, _>>()?;
        Ok(Self { members, frames, start, mode })
    }

    /// Number of the member that shows in `frame`, the first before the start; `signal` matters to a driven sequence only.
    ///
    /// A driven sequence clamps at its ends; a signal that is no number shows the first member.
    pub fn index(&self, frame: u64, signal: f64) -> usize {
        self.index_late(frame, 0, signal)
    }

    /// The same of a pointer whose every step comes `late` frames too late; a driven sequence has no steps.
    pub fn index_late(&self, frame: u64, late: u32, signal: f64) -> usize {
        let since = (i128::from(frame) - i128::from(self.start)).max(0) as u128;
        let frames = u128::from(self.frames) + u128::from(late);
        let (step, last) = (since / frames, self.members.len() as u128 - 1);
        let index = match &self.mode {
            Mode::Cycle => step % (last + 1),
            Mode::Once => step.min(last),
            Mode::PingPong if last == 0 => 0,
            Mode::PingPong => last.abs_diff((step + last) % (2 * last)),
            Mode::Driven(drive) => {
                return (drive.member(signal).max(0.0) as usize).min(self.members.len() - 1);
            }
        };
        index as usize
    }

    /// Whether a driven sequence is clamped at this value of its signal.
    pub fn is_clamped(&self, signal: f64) -> bool {
        match &self.mode {
            Mode::Driven(drive) => !(0.0..self.members.len() as f64).contains(&drive.member(signal)),
            _ => false,
        }
    }

    /// The member that shows in `frame`; see [`Self::index`].
    pub fn shown(&self, frame: u64, signal: f64) -> &T {
        &self.members[self.index(frame, signal)]
    }

    /// All members in order, each for the same number of frames.
    pub fn members(&self) -> &[T] {
        &self.members
    }

    /// Name of the signal that drives the sequence, if one does.
    pub fn signal(&self) -> Option<&str> {
        match &self.mode {
            Mode::Driven(drive) => Some(&drive.signal),
            _ => None,
        }
    }

    /// Frames of one whole round; 0 for a driven sequence.
    pub fn round(&self) -> u64 {
        let count = self.members.len() as u64;
        match self.mode {
            Mode::Cycle | Mode::Once => count * self.frames,
            Mode::PingPong => (2 * count).saturating_sub(2).max(1) * self.frames,
            Mode::Driven(_) => 0,
        }
    }
}

impl<T: Clone> Sequence<T> {
    /// Copy `number` of `copies` that start evenly staggered over one round, so that the return to the first member is hidden.
    pub fn staggered(&self, number: u64, copies: u64) -> Self {
        let ahead = u128::from(self.round()) * u128::from(number) / u128::from(copies.max(1));
        Self { start: self.start.saturating_sub_unsigned(ahead as u64), ..self.clone() }
    }
}

impl Drive {
    /// Number of the member for a value of the signal, unclamped.
    fn member(&self, signal: f64) -> f64 {
        ((signal - self.low) / self.step).floor()
    }
}
