//! The generator as a job of its machine: how long a frame takes, and what comes too late.

use generator::{FrameError, PrepareError, SizedFigure, Stage, Timed};
use light_points::BeamPoint;
use quantities::Rate;
use scenario::{Pose, Scenario};
use scene_sampler::Picture;
use timing::{EventHash, FrameTiming, Task, UnitUse};

use crate::deadlines::Judged;
use crate::hardware::Hardware;
use crate::inputs::inputs_hash;
use crate::parameters::Parameters;
use crate::policy::Overload;
use crate::session::Session;
use crate::sizing;
use crate::work::{self, BEAM, Course, SAMPLER, Work};

/// A stage as a job for [`Hardware`](crate::Hardware).
pub struct Clocked {
    session: Session,
}

impl Clocked {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If the generator cannot draw it.
    pub fn new(stage: Stage, parameters: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        Ok(Self { session: Session::new(stage, parameters, hardware)? })
    }

    fn is_extending(&self) -> bool {
        self.session.parameters.overload == Overload::Extend
    }

    /// Ticks between which the beam draws: the field after the frame. It begins no earlier than the last sub-area is read out.
    fn beam_field(&self, course: &Course, field: u64) -> [u64; 2] {
        match self.is_extending() {
            true => [0, 1].map(|more| (work::fields(course.end(), field) + more) * field),
            false => [course.end().max(field), 2 * field],
        }
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

    /// The timing of a frame that is never begun, since the one before takes its field: the units are at work on that one.
    fn never_begun(&self, frame: u64, field: u64) -> FrameTiming {
        let mut judged = Judged::none_of(&self.session);
        judged.update(None, field);
        let units = Work::default().units(&[], &Course::default());
        timing_of(frame, field, judged, (units, Vec::new()), &EventHash::new())
    }
}

/// The timing of a frame whose deadlines are judged, with its units and tasks.
fn timing_of(
    frame: u64,
    ticks: u64,
    judged: Judged<'_>,
    (units, tasks): (Vec<UnitUse>, Vec<Task>),
    events: &EventHash,
) -> FrameTiming {
    let Judged { deadlines, mut misses, .. } = judged;
    misses.sort_by(|one, other| one.sweep.cmp(&other.sweep).then(one.due.total_cmp(&other.due)));
    FrameTiming { ticks, deadlines, misses, ..FrameTiming::of_work(frame, units, tasks, events) }
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
        let Session { hardware, screen, .. } = &self.session;
        let ticks = self.session.field_ticks();
        if self.is_extending() && self.session.field(frame)?.frame != frame {
            return Ok(self.never_begun(frame, ticks));
        }
        let gathered = self.session.gather(frame, pose)?;
        let drawn = self.session.drawn(&gathered.scene, frame, true)?;
        let picture = &drawn.picture;
        let course = Course::of(&picture.readings, hardware);
        let work = Work::of(&gathered.scene, &drawn, screen);
        let mut judged = Judged::none_of(&self.session);
        judged.frame_tasks(&work, ticks);
        judged.lists(&drawn);
        judged.store(&gathered);
        judged.stacks(picture);
        judged.sub_areas(&course, ticks);
        judged.update(Some(course.end()), ticks);
        let beam_field = self.beam_field(&course, ticks);
        judged.beam(&gathered, picture, beam_field);
        let tasks = work.tasks(&picture.readings, hardware);
        let units = work.units(&tasks, &course);
        let events = self.events(picture, &course, beam_field[0]);
        Ok(timing_of(frame, ticks, judged, (units, tasks), &events))
    }

    fn sizing(&self, frames: &[FrameTiming]) -> Vec<SizedFigure> {
        sizing::figures(&self.session, frames)
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
    use crate::policy::Overload;
    use crate::{Parameters, scenes};

    /// Frame 0 of the pane and two stars at `update` frames a second, on hardware that `change` makes of the slow one.
    fn timed(update: u64, change: impl Fn(Hardware) -> Hardware) -> FrameTiming {
        let (generator, rate) = scenes::slow(update);
        let generator = crate::Sampled { hardware: change(generator.hardware), ..generator };
        let clocked = Clocked::new(
            scenes::stage(scenes::pane_and_stars(), rate),
            generator.parameters,
            generator.hardware,
        )
        .unwrap();
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

    /// The pane covers sub-areas 0 and 2, and there is no slot for it: each of 64 pixels loses it at 4 sampling points.
    #[test]
    fn full_stacks_are_misses_of_their_sub_areas() {
        let (mut generator, rate) = scenes::slow(10);
        generator.parameters.sampling.translucent = Some(0);
        let clocked = Clocked::new(
            scenes::stage(scenes::pane_and_stars(), rate),
            generator.parameters,
            generator.hardware,
        )
        .unwrap();
        let timing = Timed::frame(&clocked, 0, &scenes::pose()).unwrap();
        assert_eq!(slack(&timing, "stack"), Some((4, 2, Some(-256))));
        let ours = timing.misses.iter().filter(|missed| missed.cause == Cause::Occupied);
        let told: Vec<_> = ours.map(|missed| (missed.sweep, missed.part.as_deref())).collect();
        assert_eq!(told, [(0, Some("sub-area.0")), (1, Some("sub-area.2"))]);
        // Without limits there is no such deadline.
        generator.parameters.sampling.translucent = None;
        generator.parameters.sampling.lights = None;
        let clocked = Clocked::new(
            scenes::stage(scenes::pane_and_stars(), rate),
            generator.parameters,
            generator.hardware,
        )
        .unwrap();
        assert_eq!(slack(&Timed::frame(&clocked, 0, &scenes::pose()).unwrap(), "stack"), None);
    }

    /// Six ticks a field; the last sub-area is read out at 8, so the frame takes two fields and the next is never begun. The beam of
    /// the frame waits for the third field.
    #[test]
    fn a_frame_that_is_extended_misses_its_update() {
        let (generator, rate) = scenes::slow(166);
        let parameters = Parameters { overload: Overload::Extend, ..generator.parameters };
        let beam = BeamBudget { jump_ns: 2_000_000, dwell_ns: 0 };
        let hardware = Hardware { beam, ..generator.hardware };
        let stage = scenes::moving(scenes::pane_and_stars(), rate, 2);
        let poses = stage.scenery.course().to_vec();
        let clocked = Clocked::new(stage, parameters, hardware).unwrap();
        let [long, never] =
            [0, 1].map(|frame| Timed::frame(&clocked, frame, &poses[frame as usize]).unwrap());
        assert_eq!(slack(&long, "update"), Some((1, 1, Some(-2))));
        let missed = |timing: &FrameTiming| {
            let missed = timing.misses.iter().find(|missed| missed.deadline.word() == "update").unwrap();
            (missed.due, missed.came, missed.cause)
        };
        assert_eq!(missed(&long), (6.0, Some(8.0), Cause::Queue));
        assert_eq!(slack(&long, "beam"), Some((1, 0, Some(18 - 12 - 2))));
        assert_eq!((long.ticks, never.ticks), (6, 6));
        assert_eq!(slack(&never, "update"), Some((1, 1, Some(-6))));
        assert_eq!(missed(&never), (6.0, None, Cause::Queue));
        assert!(never.tasks.is_empty() && never.units.iter().all(|unit| unit.busy == 0) && never.events == 0);
        assert_eq!(slack(&never, "sub-area"), Some((0, 0, None)));
        // A session of its own says the same of the later frame.
        let parameters = Parameters { overload: Overload::Extend, ..Parameters::default() };
        let stage = scenes::moving(scenes::pane_and_stars(), rate, 2);
        let alone = Clocked::new(stage, parameters, hardware).unwrap();
        assert_eq!(Timed::frame(&alone, 1, &poses[1]).unwrap(), never);
    }

    /// A bound on a kind of deadline that a frame has no cause to count is met all the same.
    #[test]
    fn a_frame_without_lights_has_the_deadline_of_the_beam() {
        let (generator, rate) = scenes::slow(10);
        let clocked = Clocked::new(
            scenes::stage(scenario::Effects::default(), rate),
            generator.parameters,
            generator.hardware,
        )
        .unwrap();
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
