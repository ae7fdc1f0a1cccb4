//! The program as a job of its computer: how long a frame takes, as a timing record tells it.

use generator::{FrameError, PrepareError, Stage, Timed};
use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{EventHash, FrameTiming, Task, UnitUse};

use crate::Lunsim;
use crate::hardware::Hardware;
use crate::inputs::inputs_hash;
use crate::session::{Picture, Session};
use crate::work::{COMPUTER, RECORDER, Work};

/// A stage as a job for [`Hardware`].
pub struct Program {
    session: Session,
    hardware: Hardware,
}

impl Program {
    /// Ticks of its records in a second: whole nanoseconds.
    pub const MASTER_HZ: u64 = 1_000_000_000;

    /// Reads `stage`, as [`Generator::prepare`](generator::Generator::prepare) does.
    ///
    /// # Errors
    /// If the program could not draw it.
    pub fn new(stage: Stage, program: &Lunsim) -> Result<Self, PrepareError> {
        Ok(Self { session: Session::new(stage, program.parameters)?, hardware: program.hardware })
    }

    /// What frame `frame` from `pose` takes. Its length is the time of the computer and, after it, that of the recorder;
    /// a batch program has no deadlines. Events are the output blocks, each with the instant at which the recorder has
    /// plotted it (from when it begins) and its plotting instructions: column, line and code.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let (work, events) = match self.session.picture(frame, pose)? {
            Some(picture) => self.work(&picture),
            None => (Work::of_nothing(&self.session.stage().landscape), EventHash::new()),
        };
        let tasks = work.tasks(&self.hardware);
        let busy = |unit: &str| {
            let ours = tasks.iter().filter(|task| task.unit == unit);
            ours.map(|task| task.ticks).sum::<u64>()
        };
        let units = [COMPUTER, RECORDER].map(|unit| UnitUse {
            unit: unit.into(),
            busy: busy(unit),
            longest_queue: 0,
        });
        Ok(FrameTiming::of_work(frame, units.into(), tasks, &events))
    }

    fn work(&self, picture: &Picture) -> (Work, EventHash) {
        let film = picture.film();
        let columns: Vec<_> = film.columns().collect();
        let work = Work::of(&film, &self.session.stage().landscape, picture.march, &columns);
        let (mut events, mut plotted) = (EventHash::new(), 0);
        for (column, points) in columns {
            plotted += points.len() as u64;
            let word =
                |(line, code): (usize, u32)| (column as u64) << 32 | (line as u64) << 16 | u64::from(code);
            let words: Vec<u64> = points.into_iter().map(word).collect();
            events.push(plotted * self.hardware.point, RECORDER, "block", &words);
        }
        (work, events)
    }
}

/// A batch program is loaded with its job: there is nothing before it.
impl Timed for Program {
    fn master(&self) -> Rate {
        Rate::new(Self::MASTER_HZ, 1).expect("a whole number above 0")
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        inputs_hash(scenario, self.session.stage(), self.session.parameters(), &self.hardware)
    }

    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        Ok(Vec::new())
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        Self::frame(self, frame, pose)
    }
}
