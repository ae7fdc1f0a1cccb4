//! The generator as a job of its machine: how long a frame takes, and what comes too late.

use std::collections::BTreeMap;

use generator::{FrameError, PrepareError, Stage, Timed};
use light_points::BeamPoint;
use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{Cause, Deadline, EventHash, FrameTiming, Missed, Slack, Task};

use crate::Sampled;
use crate::hardware::{Hardware, Memory};
use crate::inputs::inputs_hash;
use crate::lights::Point;
use crate::picture::Picture;
use crate::session::{Gathered, Session};
use crate::tile::SIDE;
use crate::work::{self, BEAM, Course, SAMPLER, Work};

/// A feature has a place in the list of a sub-area that it may cover; its slack is a tick a place.
const LIST: Deadline = Deadline::new("list");
/// A light point has a place in the store; its slack is a tick a place.
const STORE: Deadline = Deadline::new("light-store");
/// A sub-area is read out before its line is due.
const SUB_AREA: Deadline = Deadline::new("sub-area");
/// A calligraphic point is drawn before the field after the frame ends.
const POINT: Deadline = Deadline::new("beam");

/// A stage as a job for [`Hardware`].
pub struct Clocked {
    session: Session,
}

/// Deadlines of a frame as they are met or missed.
#[derive(Debug)]
struct Judged {
    deadlines: BTreeMap<Deadline, Slack>,
    misses: Vec<Missed>,
}

impl Judged {
    /// All deadlines that the machine has, before any is met or missed; those of a memory only where it is limited.
    fn none_of(hardware: &Hardware) -> Self {
        let Memory { list_entries, list_depth, points } = hardware.memory;
        let lists = list_entries.or(list_depth).map(|_| LIST);
        let kinds =
            [Deadline::FRAME_TASKS, SUB_AREA, POINT].into_iter().chain(lists).chain(points.map(|_| STORE));
        Self { deadlines: kinds.map(|kind| (kind, Slack::default())).collect(), misses: Vec::new() }
    }

    /// Counts a deadline that was met or missed by so many ticks; `missed` tells of a miss.
    fn add(&mut self, deadline: Deadline, slack: i64, missed: impl FnOnce() -> Missed) {
        self.deadlines.entry(deadline).or_default().add(slack);
        if slack < 0 {
            self.misses.push(missed());
        }
    }
}

impl Clocked {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If the generator cannot draw it.
    pub fn new(stage: Stage, generator: &Sampled) -> Result<Self, PrepareError> {
        Ok(Self { session: Session::new(stage, generator)? })
    }

    /// Whether geometry and lists took less than the frame before.
    fn judge_frame_tasks(&self, work: &Work, frame: u64, judged: &mut Judged) {
        let late = work.before_frame(&self.session.hardware) as i64 - frame as i64;
        judged.add(Deadline::FRAME_TASKS, -late, || Missed {
            came: Some(late as f64),
            ..Missed::of(Deadline::FRAME_TASKS, 0, Cause::Processor)
        });
    }

    /// Places in the lists, where those are limited.
    fn judge_lists(&self, picture: &Picture, judged: &mut Judged) {
        let memory = &self.session.hardware.memory;
        if let Some(depth) = memory.list_depth {
            for reading in &picture.readings {
                (1..=reading.triangles).for_each(|place| kept_place(LIST, depth, place, judged));
            }
        } else if let Some(most) = memory.list_entries {
            (1..=picture.entries as u32).for_each(|place| kept_place(LIST, most, place, judged));
        }
        let [columns, _] = self.session.screen.counts();
        for lost in &picture.lost {
            judged.add(LIST, -i64::from(lost.short), || Missed {
                part: Some(format!("sub-area.{}.triangle.{}", lost.sub_area, lost.triangle)),
                ..Missed::of(LIST, lost.sub_area / columns, Cause::Occupied)
            });
        }
    }

    /// Places in the light point store, where that is limited.
    fn judge_store(&self, gathered: &Gathered, judged: &mut Judged) {
        let Some(most) = self.session.hardware.memory.points else { return };
        let kept = gathered.scene.lights.points.len() as u32;
        (1..=kept).for_each(|place| kept_place(STORE, most, place, judged));
        for (short, point) in (1..).zip(&gathered.lost_points) {
            judged.add(STORE, -short, || Missed {
                part: Some(part(point)),
                ..Missed::of(STORE, self.row(point.middle[1]), Cause::Occupied)
            });
        }
    }

    /// Whether every sub-area was read out in time.
    fn judge_sub_areas(&self, course: &Course, frame: u64, judged: &mut Judged) {
        let [columns, rows] = self.session.screen.counts();
        for (number, &came) in (0..).zip(&course.read_out) {
            let row = number / columns;
            let due = work::due(row, rows, frame);
            judged.add(SUB_AREA, due as i64 - came as i64, || Missed {
                part: Some(format!("sub-area.{number}")),
                due: due as f64,
                came: Some(came as f64),
                ..Missed::of(SUB_AREA, row, Cause::Queue)
            });
        }
    }

    /// Whether the beam drew every point in the field after the frame. It begins when the last sub-area is read out, no earlier
    /// than that field.
    fn judge_beam(&self, gathered: &Gathered, picture: &Picture, start: u64, due: u64, judged: &mut Judged) {
        let points = &gathered.scene.lights.points;
        let drawn = picture.beam.drawn.iter().map(|point| (point, true));
        let dropped = picture.beam.dropped.iter().map(|point| (point, false));
        for (place, (point, is_drawn)) in (1..).zip(drawn.chain(dropped)) {
            let came = start + work::beam_ticks(&self.session.hardware, place);
            // A point without time is late, be it by less than a tick.
            let slack = (due as i64 - came as i64).min(if is_drawn { i64::MAX } else { -1 });
            judged.add(POINT, slack, || Missed {
                part: points.iter().find(|known| known.id == point.id).map(part),
                due: due as f64,
                came: is_drawn.then_some(came as f64),
                ..Missed::of(POINT, self.row(point.place[1]), Cause::Queue)
            });
        }
    }

    /// Row of sub-areas at a height of the screen (pixels); that at the border for what lies beyond.
    fn row(&self, y: f64) -> u32 {
        let [_, rows] = self.session.screen.counts();
        ((y.max(0.0) / SIDE as f64) as u32).min(rows - 1)
    }

    /// Sub-areas as they are read out, each with its number and entries, then the points of the beam.
    fn events(&self, picture: &Picture, course: &Course, start: u64) -> EventHash {
        let mut events = EventHash::new();
        for (number, (reading, tick)) in (0..).zip(picture.readings.iter().zip(&course.read_out)) {
            events.push(*tick, SAMPLER, "sub-area", &[number, reading.entries()]);
        }
        for (place, BeamPoint { id, .. }) in (1..).zip(&picture.beam.drawn) {
            let tick = start + work::beam_ticks(&self.session.hardware, place);
            events.push(tick, BEAM, "point", &[u64::from(*id)]);
        }
        events
    }
}

/// Counts a place of a memory of `places` that something has.
fn kept_place(deadline: Deadline, places: u32, place: u32, judged: &mut Judged) {
    judged.deadlines.entry(deadline).or_default().add(i64::from(places) - i64::from(place));
}

/// A light point by its number among those of the mission.
fn part(point: &Point) -> String {
    format!("light.{}", point.light)
}

impl Timed for Clocked {
    fn master(&self) -> Rate {
        Rate::new(self.session.hardware.sampler_hz, 1).expect("a whole number above 0")
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        inputs_hash(scenario, &self.session)
    }

    /// The data base is in memory before the mission: there is nothing to do.
    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        Ok(Vec::new())
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let Session { hardware, screen, stage, .. } = &self.session;
        let gathered = self.session.gather(frame, pose)?;
        let picture = self.session.picture(&gathered.scene, frame, true)?;
        let ticks = work::frame_ticks(hardware, stage.view.update);
        let course = Course::of(&picture.readings, hardware);
        let work = Work::of(&gathered.scene, &picture, screen);
        let mut judged = Judged::none_of(hardware);
        self.judge_frame_tasks(&work, ticks, &mut judged);
        self.judge_lists(&picture, &mut judged);
        self.judge_store(&gathered, &mut judged);
        self.judge_sub_areas(&course, ticks, &mut judged);
        let start = course.end().max(ticks);
        self.judge_beam(&gathered, &picture, start, 2 * ticks, &mut judged);
        judged.misses.sort_by(|one, other| one.sweep.cmp(&other.sweep).then(one.due.total_cmp(&other.due)));
        let tasks = work.tasks(&picture.readings, hardware);
        let units = work.units(&tasks, &course);
        let events = self.events(&picture, &course, start);
        Ok(FrameTiming {
            ticks,
            deadlines: judged.deadlines,
            misses: judged.misses,
            ..FrameTiming::of_work(frame, units, tasks, &events)
        })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use generator::Timed;
    use light_points::BeamBudget;
    use timing::{Cause, FORMAT, FrameTiming, TimingRecord};

    use super::Clocked;
    use crate::hardware::Hardware;
    use crate::scenes;

    /// Frame 0 of the pane and two stars at `update` frames a second, on hardware that `change` makes of the slow one.
    fn timed(update: u64, change: impl Fn(Hardware) -> Hardware) -> FrameTiming {
        let (generator, rate) = scenes::slow(update);
        let generator = crate::Sampled { hardware: change(generator.hardware), ..generator };
        let clocked = Clocked::new(scenes::stage(scenes::pane_and_stars(), rate), &generator).unwrap();
        Timed::frame(&clocked, 0, &scenes::pose()).unwrap()
    }

    fn slack(timing: &FrameTiming, name: &str) -> Option<(u64, u64, Option<i64>)> {
        let found = timing.deadlines.iter().find(|(deadline, _)| deadline.word() == name);
        found.map(|(_, slack)| (slack.count, slack.missed, slack.least))
    }

    /// Sub-areas with 2, 1 and 2 entries, and one with a calligraphic point and no entry, which takes a tick all the same. The
    /// pixels of each take another.
    #[test]
    fn a_tiny_frame_by_hand() {
        let timing = timed(10, |hardware| hardware);
        assert_eq!((timing.frame, timing.ticks), (0, 100));
        let pieces =
            |task: &str| timing.tasks.iter().find(|found| found.task == task).map(|found| found.pieces);
        let counted = ["corners", "pairs", "entries", "short-lists", "pixels", "discs", "points"].map(pieces);
        // At 1 kHz a point takes less than a tick.
        assert_eq!(counted, [Some(6), Some(6), Some(5), Some(1), Some(256), Some(1), None]);
        // Read out at 3, 4, 6 and 8; the rows are due at 50 and 100.
        assert_eq!(slack(&timing, "sub-area"), Some((4, 0, Some(46))));
        assert_eq!(timing.events, 5);
        assert_eq!((slack(&timing, "list"), slack(&timing, "light-store")), (None, None));
    }

    /// With 4 ticks a frame the rows are due at 2 and 4.
    #[test]
    fn a_slow_sampler_misses_lines_and_keeps_the_beam_waiting() {
        let beam = BeamBudget { jump_ns: 2_000_000, dwell_ns: 0 };
        let timing = timed(250, |hardware| Hardware { beam, ..hardware });
        assert_eq!(timing.ticks, 4);
        assert_eq!(slack(&timing, "sub-area"), Some((4, 4, Some(-4))));
        assert_eq!(slack(&timing, "frame-tasks").map(|(count, missed, _)| (count, missed)), Some((1, 1)));
        let told: Vec<_> = timing
            .misses
            .iter()
            .filter(|missed| missed.deadline.word() != "frame-tasks")
            .map(|missed| (missed.sweep, missed.part.as_deref().unwrap(), missed.due, missed.came.unwrap()))
            .collect();
        let expected = [
            (0, "sub-area.0", 2.0, 3.0),
            (0, "sub-area.1", 2.0, 4.0),
            (1, "sub-area.2", 4.0, 6.0),
            (1, "sub-area.3", 4.0, 8.0),
            // The field after the frame begins at 4, the last sub-area is read out at 8, the jump takes 2.
            (1, "light.1", 8.0, 10.0),
        ];
        assert_eq!(told, expected);
        assert!(timing.misses.iter().skip(1).all(|missed| missed.cause == Cause::Queue));
    }

    #[test]
    fn full_memories_are_misses_with_their_places() {
        let timing = timed(10, |hardware| {
            let memory = crate::Memory { list_depth: Some(1), points: Some(1), ..hardware.memory };
            Hardware { memory, ..hardware }
        });
        assert_eq!(slack(&timing, "list"), Some((4, 2, Some(-1))));
        assert_eq!(slack(&timing, "light-store"), Some((2, 1, Some(-1))));
        let occupied = timing.misses.iter().filter(|missed| missed.cause == Cause::Occupied);
        let told: Vec<_> = occupied.map(|missed| (missed.sweep, missed.part.as_deref().unwrap())).collect();
        assert_eq!(told, [(0, "sub-area.0.triangle.1"), (1, "sub-area.2.triangle.1"), (1, "light.1")]);
    }

    #[test]
    fn a_beam_without_time_drops_points_that_never_come() {
        let beam = BeamBudget { jump_ns: 200_000_000, dwell_ns: 0 };
        let timing = timed(10, |hardware| Hardware { beam, ..hardware });
        assert_eq!(slack(&timing, "beam"), Some((1, 1, Some(-100))));
        let missed = timing.misses.iter().find(|missed| missed.deadline.word() == "beam").unwrap();
        assert_eq!((missed.part.as_deref(), missed.came, missed.due), (Some("light.1"), None, 200.0));
    }

    /// A bound on a kind of deadline that a frame has no cause to count is met all the same.
    #[test]
    fn a_frame_without_lights_has_the_deadline_of_the_beam() {
        let (generator, rate) = scenes::slow(10);
        let clocked = Clocked::new(scenes::stage(scenario::Effects::default(), rate), &generator).unwrap();
        let timing = Timed::frame(&clocked, 0, &scenes::pose()).unwrap();
        assert_eq!(slack(&timing, "beam"), Some((0, 0, None)));
    }

    #[test]
    fn a_record_with_these_deadlines_holds_together_and_reads_back() {
        let record = TimingRecord {
            format: FORMAT,
            scenario: "pane and stars".into(),
            machine: crate::ROW.name.into(),
            inputs: "0".into(),
            keys: BTreeMap::new(),
            master: "1000 Hz".into(),
            before_mission: Vec::new(),
            frames: vec![timed(250, |hardware| hardware)],
        };
        assert_eq!(record.check(), Ok(()));
        let text = serde_json::to_string(&record).unwrap();
        assert_eq!(serde_json::from_str::<TimingRecord>(&text).unwrap(), record);
        assert!(record.text().contains("sub-area"), "{}", record.text());
    }
}
