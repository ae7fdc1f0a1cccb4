//! The program as a job of its computer: how long a frame takes, as a timing record tells it.

use generator::{FrameError, PrepareError, ReportedTime, Stage, Timed};
use panel_program::Picture;
use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{EventHash, FrameTiming, Task, UnitUse};

use super::inputs::inputs_hash;
use super::tasks::{COMPUTER, record_time};
use super::{Hardware, REPORTED, tasks};
use crate::Parameters;
use crate::program::ProgramSession;

/// Ticks of its records in a second: whole nanoseconds.
const MASTER_HZ: u64 = 1_000_000_000;

/// Codes of grey, from 0 to the brightest.
const BRIGHTEST: f32 = 255.0;

/// A stage as a job for [`Hardware`].
pub struct Job {
    session: ProgramSession,
    parameters: Parameters,
    hardware: Hardware,
}

impl Job {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If the program cannot draw it.
    pub fn new(stage: Stage, parameters: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        Ok(Self { session: ProgramSession::new(stage, &parameters)?, parameters, hardware })
    }

    /// Records of the picture in their order: a row of the screen each, with the codes of its pixels. `end` is when the last is written.
    fn events(&self, picture: &Picture, columns: usize, end: u64) -> EventHash {
        let mut events = EventHash::new();
        let rows = picture.light.chunks(columns);
        let record = record_time(&self.hardware);
        for (before_last, row) in (0..rows.len() as u64).rev().zip(rows) {
            let codes: Vec<u64> = row.iter().map(|light| (light * BRIGHTEST).round() as u64).collect();
            events.push(end - before_last * record, COMPUTER, "record", &codes);
        }
        events
    }
}

impl Timed for Job {
    fn master(&self) -> Rate {
        Rate::new(MASTER_HZ, 1).expect("a whole number above 0")
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        inputs_hash(scenario, self.session.stage(), &self.parameters, &self.hardware)
    }

    /// A batch program is loaded with its job: there is nothing before it.
    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        Ok(Vec::new())
    }

    /// The whole program runs for every frame, from the grid to the picture's records. It has no deadlines.
    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let picture = self.session.picture(frame, pose)?;
        let tasks = tasks(&picture.listing, &self.hardware);
        let busy = tasks.iter().map(|task| task.ticks).sum();
        let units = vec![UnitUse { unit: COMPUTER.into(), busy, longest_queue: 0 }];
        let events = self.events(&picture, self.session.stage().view.columns as usize, busy);
        Ok(FrameTiming::of_work(frame, units, tasks, &events))
    }

    fn reported(&self) -> &'static [ReportedTime] {
        &REPORTED
    }
}
