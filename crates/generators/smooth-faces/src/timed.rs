//! The generator as a job of its machine: how long a frame takes, and what comes too late.

use generator::{FrameError, PrepareError, SizedFigure, Stage, Timed};
use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{EventHash, FrameTiming, Task};

use crate::deadlines::Judged;
use crate::hardware::Hardware;
use crate::inputs::inputs_hash;
use crate::parameters::Parameters;
use crate::planes;
use crate::prepared::Prepared;
use crate::scan_line::TimedLine;
use crate::scene::Scene;
use crate::sizing;
use crate::work::{EDGES, RT, SECOND, Work};

/// A stage as a job for [`Hardware`](crate::Hardware). Ticks are nanoseconds.
pub struct Clocked {
    prepared: Prepared,
}

impl Clocked {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If the generator cannot draw it.
    pub fn new(stage: Stage, parameters: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        Ok(Self { prepared: Prepared::new(stage, parameters, hardware)? })
    }

    /// What is new in a frame, in the order of the computer; then the scan lines, each with its crossings, those without a slot, its ramps.
    fn events(&self, frame: u64, lines: &[TimedLine]) -> EventHash {
        let mut events = EventHash::new();
        for (number, item) in (0..).zip(self.prepared.schedule.items()) {
            if item.when.shown(frame) == frame {
                events.push(item.ready_ns, RT, item.kind.word(), &[number, item.pieces]);
            }
        }
        let line_ns = self.prepared.hardware.sample_ns * self.prepared.samples() as u64;
        for (number, line) in (0..).zip(lines) {
            let words = [number, line.crossed.crossings, line.crossed.missed.len() as u64, line.ramps];
            events.push(number * line_ns, EDGES, "line", &words);
        }
        events
    }
}

impl Timed for Clocked {
    fn master(&self) -> Rate {
        Rate::new(SECOND, 1).expect("a whole number above 0")
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        inputs_hash(scenario, &self.prepared)
    }

    /// Frame 0 is in the image processor before the mission: there is nothing to do.
    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        Ok(Vec::new())
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let prepared = &self.prepared;
        let scene = Scene::new(prepared, frame, pose)?;
        let (seen, _) = prepared.seen(frame, pose)?;
        let lines = planes::timed_lines(&scene, &prepared.run, prepared.size());
        let ticks = prepared.stage.view.update.period_ticks(SECOND);
        let mut judged = Judged::none_of(prepared);
        judged.frame_tasks();
        judged.updates(seen, ticks);
        judged.frame_edges(&scene);
        judged.lines(&scene, &lines);
        let work = Work::of(prepared, seen, scene.work, &lines);
        let tasks = work.tasks(prepared);
        let (units, events) = (work.units(&tasks), self.events(seen, &lines));
        let Judged { deadlines, mut misses, .. } = judged;
        misses.sort_by(|one, other| one.sweep.cmp(&other.sweep).then(one.due.total_cmp(&other.due)));
        Ok(FrameTiming { ticks, deadlines, misses, ..FrameTiming::of_work(frame, units, tasks, &events) })
    }

    fn sizing(&self, frames: &[FrameTiming]) -> Vec<SizedFigure> {
        sizing::figures(&self.prepared, frames)
    }
}
