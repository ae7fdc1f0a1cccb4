//! Late words of a frame of the hybrid machine.

use event_list::{DigitalFrame, told};
use generator::FrameError;
use machine::{ControlPlane, DigitalEvent, EventWord, MachineStage};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::PoseRow;

use crate::clock::nanoseconds;

/// Events of words that were not there in time.
const LATE: [EventWord; 5] = [
    EventWord::Late,
    EventWord::CraterLate,
    EventWord::CraterDropped,
    EventWord::SegmentLate,
    EventWord::SegmentDropped,
];

/// Words that were not there in time, as `lunoid trace` tells them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LateWord {
    /// When they were missed: simulated time since the start of the mission (ns).
    pub time: u64,
    /// Unit that missed them.
    pub unit: String,
    /// Sweep in which they were missed, from 0.
    pub sweep: u32,
    /// The event in a line.
    pub text: String,
}

/// The digital side of a run, which knows the late words of its frames.
pub struct LateWords {
    stage: MachineStage,
    control: ControlPlane,
}

impl LateWords {
    /// The digital side of the hybrid machine on `stage`.
    pub fn new(stage: MachineStage) -> Self {
        Self { control: ControlPlane::new(stage.clone()), stage }
    }

    /// The late words of a frame, sweep by sweep in the order of their ticks, by the threads of the current pool.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn of(&self, row: &PoseRow) -> Result<Vec<LateWord>, FrameError> {
        let frame = DigitalFrame::new(&self.control, &self.stage, (row.frame, &row.pose), true)?;
        let sweeps = frame.sweeps();
        let timebase = &self.stage.settings.timebase;
        let of = |sweep: u32| {
            let mut events = sweeps.events(sweep);
            events.retain(|event| LATE.contains(&event.event));
            events.sort_by_key(|event| event.tick);
            let word = |event: &DigitalEvent| LateWord {
                time: nanoseconds(event.tick.0, timebase.master).unwrap_or(u64::MAX),
                unit: event.unit.to_string(),
                sweep,
                text: told(event),
            };
            events.iter().map(word).collect::<Vec<_>>()
        };
        let found: Vec<_> = (0..timebase.sweeps).into_par_iter().map(of).collect();
        Ok(found.into_iter().flatten().collect())
    }
}
