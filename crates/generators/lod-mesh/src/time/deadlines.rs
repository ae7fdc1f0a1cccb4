//! Deadlines of a frame, as they are met or missed.

use std::collections::BTreeMap;

use timing::{Cause, Deadline, Missed, Slack, Task};

use super::work::{self, CPU};

/// Every percentage has a slot of the uniform array; its slack is a tick a slot.
const SLOT: Deadline = Deadline::new("uniform-slot");
/// The picture has a place in the memory that holds pictures until the run ends; its slack is a tick a picture.
const CAPTURE: Deadline = Deadline::new("capture-memory");

/// Deadlines of a frame as they are met or missed. Ticks are nanoseconds from when the frame begins.
#[derive(Debug, Default)]
pub struct Judged {
    /// Slack of each kind of deadline that the machine has.
    pub deadlines: BTreeMap<Deadline, Slack>,
    /// Deadlines that were missed.
    pub misses: Vec<Missed>,
}

impl Judged {
    fn add(&mut self, deadline: Deadline, slack: i64, missed: impl FnOnce(Missed) -> Missed) {
        self.deadlines.entry(deadline).or_default().add(slack);
        if slack < 0 {
            self.misses.push(missed(Missed::of(deadline, 0, Cause::Occupied)));
        }
    }

    /// Whether a frame of these tasks ends within `ticks`; a miss names the unit that takes most.
    pub fn frame_tasks(&mut self, tasks: &[Task], ticks: u64) {
        let (came, part) = (work::frame_time(tasks), work::slowest(tasks));
        self.add(Deadline::FRAME_TASKS, difference(ticks, came), |missed| Missed {
            due: ticks as f64,
            came: Some(came as f64),
            part: Some(part.into()),
            cause: if part == CPU { Cause::Processor } else { Cause::Access },
            ..missed
        });
    }

    /// A frame that is never begun, since the one before takes its time.
    pub fn never_begun(&mut self, ticks: u64) {
        let slack = difference(0, ticks);
        self.add(Deadline::FRAME_TASKS, slack, |missed| Missed {
            due: ticks as f64,
            cause: Cause::Queue,
            ..missed
        });
    }

    /// Whether so many percentages find slots.
    pub fn slots(&mut self, words: u64, slots: u32) {
        self.add(SLOT, difference(slots.into(), words), |missed| Missed {
            part: Some(format!("tile.{slots}")),
            due: f64::from(slots),
            ..missed
        });
    }

    /// Whether the picture of frame `frame` finds a place, where so many do.
    pub fn capture(&mut self, frame: u64, places: u64) {
        self.add(CAPTURE, difference(places, frame.saturating_add(1)), |missed| Missed {
            part: Some(format!("picture.{frame}")),
            due: places as f64,
            ..missed
        });
    }
}

fn difference(a: u64, b: u64) -> i64 {
    (i128::from(a) - i128::from(b)).clamp(i64::MIN.into(), i64::MAX.into()) as i64
}
