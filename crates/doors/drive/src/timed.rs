//! How a machine kept its deadlines in a frame.

use generator::Timed;

use crate::{DriveError, Viewpoint};

/// Counts of one frame, as its timing record has them.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameTiming {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Folds of both ramps in all sweeps; nothing where another generator draws than the hybrid machine.
    pub folds: Option<u64>,
    /// Words that came after the stop they were meant for; nothing where another generator draws than the hybrid machine.
    pub late_words: Option<u64>,
    /// Deadlines that were not met, those of the words among them.
    pub missed: u64,
    /// Each kind of deadline that the machine has, in the order of its timing record.
    pub deadlines: Vec<DeadlineCount>,
}

/// Deadlines of one kind in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct DeadlineCount {
    /// Name of the kind, as `lunoid timing` has it.
    pub name: String,
    /// Deadlines of the kind.
    pub count: u64,
    /// Those that were not met.
    pub missed: u64,
    /// Least time left (µs), negative where a deadline was not met; nothing without deadlines.
    pub least_slack_us: Option<f64>,
}

impl Viewpoint<'_> {
    /// Counts deadlines and those that were not met; of the hybrid machine folds and late words too. No event is listed, so it takes a part of what
    /// their listing takes.
    ///
    /// # Errors
    /// If frames of the generator take no time, or the pose cannot be drawn.
    pub fn timing(&self) -> Result<FrameTiming, DriveError> {
        let Self { drive, bench, .. } = self;
        drive.pool.install(|| match drive.opened.is_machine() {
            true => self.timing_of(bench.control()),
            false => self.timing_of_guest(),
        })
    }

    fn timing_of_guest(&self) -> Result<FrameTiming, DriveError> {
        let Self { drive, bench, .. } = self;
        let timed = drive.opened.generator.timed(bench.stage.clone());
        match timed.map_err(|error| DriveError::of(drive.file(), &error))? {
            Some(timed) => self.timing_of(&*timed),
            None => {
                let title = format!("frames of {} take no time", drive.drawn_by());
                Err(DriveError::asked(
                    drive.file(),
                    title,
                    "a hardware model, or a generator with timing records",
                ))
            }
        }
    }

    fn timing_of(&self, timed: &dyn Timed) -> Result<FrameTiming, DriveError> {
        let Self { drive, frame, pose, .. } = self;
        let timing = timed.frame_for_totals(*frame, pose);
        let timing = timing.map_err(|error| DriveError::of(drive.file(), &error))?;
        let (tick_us, is_machine) = (1e6 / timed.master().hertz(), drive.opened.is_machine());
        let deadlines = timing.deadlines.iter().map(|(deadline, slack)| DeadlineCount {
            name: deadline.word().into(),
            count: slack.count,
            missed: slack.missed,
            least_slack_us: slack.least.map(|ticks| ticks as f64 * tick_us),
        });
        Ok(FrameTiming {
            frame: *frame,
            folds: is_machine.then_some(timing.folds),
            late_words: is_machine.then_some(timing.late_words),
            missed: timing.misses.len() as u64,
            deadlines: deadlines.collect(),
        })
    }
}
