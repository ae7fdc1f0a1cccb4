//! The viewer as a job of its computer: how long a frame takes, and which tiles take another level.

use generator::{FrameError, PrepareError, SizedFigure, Stage, Timed};
use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{EventHash, FrameTiming, LevelChange, Task};

use super::deadlines::Judged;
use super::inputs::inputs_hash;
use super::sizing;
use super::store::Stored;
use super::work::{self, CPU, SECOND, picture_bytes};
use super::{Hardware, Work};
use crate::parameters::{Clock, Parameters, Slots};
use crate::session::{Looked, Session};

/// Bytes of a height in the file that the viewer reads. Chosen.
const HEIGHT: u64 = 4;

/// A stage as a job for [`Hardware`].
pub struct Job {
    session: Session,
}

impl Job {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If the generator cannot draw it.
    pub fn new(stage: Stage, parameters: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        Ok(Self { session: Session::new(stage, parameters, hardware)? })
    }

    fn judged(&self, frame: u64, work: &Work, tasks: &[Task], ticks: u64) -> Judged {
        let (prepared, hardware) = (self.session.prepared(), self.session.hardware());
        let mut judged = Judged::default();
        judged.frame_tasks(tasks, ticks);
        if let (Some(slots), Slots::Unlimited) = (hardware.board.uniform_slots, prepared.run.slots) {
            judged.slots(work.words(), slots);
        }
        if hardware.capture.is_held {
            let places = hardware.capture.memory_bytes / picture_bytes(&prepared.stage.view, hardware).max(1);
            judged.capture(frame, places);
        }
        judged
    }

    /// Tiles that take another level, when their levels are known; then the frame, when it is drawn.
    fn events(&self, looked: &Looked, work: &Work, tasks: &[Task]) -> EventHash {
        let mut events = EventHash::new();
        let known = tasks.iter().filter(|task| task.unit == CPU).map(|task| task.ticks).sum();
        for (number, from, to) in looked.changes() {
            events.push(known, CPU, "level", &[number as u64, from as u64, to as u64]);
        }
        events.push(work::frame_time(tasks), "gpu", "drawn", &work.drawn());
        events
    }

    /// Tiles that take another level in a frame, each with its distance and how far it is on its way.
    fn level_changes(&self, looked: &Looked) -> Vec<LevelChange> {
        let told = |(number, from, to): (usize, usize, usize)| LevelChange {
            tile: self.session.tile_name(number),
            from: from as u32,
            to: to as u32,
            distance_m: self.session.tile_distance(number, looked.eye),
            fraction: looked.state.tile(number).fraction,
            borders_m: self.session.tile_borders(number),
        };
        looked.changes().map(told).collect()
    }
}

impl Timed for Job {
    fn master(&self) -> Rate {
        Rate::new(SECOND, 1).expect("a whole number above 0")
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        inputs_hash(scenario, self.session.prepared(), self.session.hardware())
    }

    /// The posts are read, faces and versions of all levels built, with what their vertices lose to the next one, and a light map made by a
    /// ray a post.
    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        let prepared = self.session.prepared();
        let viewer = &self.session.hardware().viewer;
        let stored = Stored::of(&prepared.posts.terrain, prepared.table.levels.count());
        let bytes = stored.posts * HEIGHT;
        let tasks = [
            ("read", bytes, work::at_rate(bytes, viewer.read_bytes_s)),
            ("build", stored.vertices, stored.vertices * viewer.build_ns),
            ("deltas", stored.posts, stored.posts * viewer.build_ns),
            ("light-map", stored.posts, stored.posts * viewer.ray_ns),
        ];
        let timed = tasks.into_iter().filter(|(_, _, ticks)| *ticks > 0);
        Ok(timed
            .map(|(task, pieces, ticks)| Task { unit: CPU.into(), task: task.into(), pieces, ticks })
            .collect())
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let prepared = self.session.prepared();
        let ticks = prepared.stage.view.update.period_ticks(SECOND);
        if prepared.run.clock == Clock::RealTime && self.session.field(frame)?.frame != frame {
            let mut judged = Judged::default();
            judged.never_begun(ticks);
            return Ok(timing_of(frame, ticks, judged, &[], &EventHash::new()));
        }
        let looked = self.session.look(frame, pose)?;
        let work = self.session.work(&looked);
        let tasks = work.tasks(self.session.hardware());
        let judged = self.judged(frame, &work, &tasks, ticks);
        let events = self.events(&looked, &work, &tasks);
        let timing = timing_of(frame, ticks, judged, &tasks, &events);
        Ok(FrameTiming { level_changes: self.level_changes(&looked), ..timing })
    }

    fn in_all(&self, frame: &FrameTiming) -> Option<u64> {
        Some(work::frame_time(&frame.tasks))
    }

    fn sizing(&self, frames: &[FrameTiming]) -> Vec<SizedFigure> {
        sizing::figures(self.session.prepared(), self.session.hardware(), frames)
    }
}

fn timing_of(frame: u64, ticks: u64, judged: Judged, tasks: &[Task], events: &EventHash) -> FrameTiming {
    let Judged { deadlines, misses } = judged;
    FrameTiming {
        ticks,
        deadlines,
        misses,
        ..FrameTiming::of_work(frame, work::units(tasks), tasks.to_vec(), events)
    }
}
