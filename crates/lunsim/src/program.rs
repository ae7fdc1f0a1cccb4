//! The program as a job of its computer: how long a frame takes, as a timing record tells it.

use generator::{FrameError, PrepareError, Stage};
use scenario::Pose;
use std::collections::BTreeMap;
use timing::{EventHash, FrameTiming, Sets, UnitUse, Vertices};

use crate::hardware::Hardware;
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
    pub fn new(stage: Stage, hardware: Hardware) -> Result<Self, PrepareError> {
        Ok(Self { session: Session::new(stage)?, hardware })
    }

    /// What it runs on.
    pub fn hardware(&self) -> &Hardware {
        &self.hardware
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
        let (events, events_blake3) = events.finish();
        Ok(FrameTiming {
            frame,
            ticks: units.iter().map(|unit| unit.busy).sum::<u64>().max(1),
            folds: 0,
            sets: Sets::default(),
            late_words: 0,
            vertices: Vertices::default(),
            deadlines: BTreeMap::new(),
            units: units.into(),
            tasks,
            misses: Vec::new(),
            events,
            events_blake3,
        })
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
