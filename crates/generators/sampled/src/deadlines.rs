//! Deadlines of a frame, as they are met or missed.

use std::collections::BTreeMap;

use light_points::BeamPoint;
use scene_sampler::{Picture, Point, SIDE};
use timing::{Cause, Deadline, Missed, Slack};

use crate::drawn::Drawn;
use crate::hardware::Memory;
use crate::policy::Overload;
use crate::session::Session;
use crate::store::Gathered;
use crate::work::{self, Course, Work};

/// A feature has a place in the list of a sub-area that it may cover; its slack is a tick a place.
const LIST: Deadline = Deadline::new("list");
/// A light point has a place in the store; its slack is a tick a place.
const STORE: Deadline = Deadline::new("light-store");
/// The features of a sub-area have slots at all of its sampling points; its slack is a tick a loss.
const STACK: Deadline = Deadline::new("stack");
/// A sub-area is read out before its line is due.
const SUB_AREA: Deadline = Deadline::new("sub-area");
/// A calligraphic point is drawn before the field after the frame ends.
const POINT: Deadline = Deadline::new("beam");
/// The picture of a frame is complete when its field ends, where a frame may take more fields.
const UPDATE: Deadline = Deadline::new("update");

/// Deadlines of a frame as they are met or missed. Ticks count from when the frame begins.
pub struct Judged<'a> {
    session: &'a Session,
    /// Slack of each kind of deadline that the machine has.
    pub deadlines: BTreeMap<Deadline, Slack>,
    /// Deadlines that were missed, in the order in which they were judged.
    pub misses: Vec<Missed>,
}

impl<'a> Judged<'a> {
    /// All deadlines that the machine has, before any is met or missed; those of a memory only where it is limited.
    pub fn none_of(session: &'a Session) -> Self {
        let Memory { list_entries, list_depth, points } = session.hardware.memory;
        let limited = [
            (list_entries.or(list_depth).is_some(), LIST),
            (points.is_some(), STORE),
            (session.parameters.sampling.has_limited_stacks(), STACK),
            (session.parameters.overload == Overload::Extend, UPDATE),
        ];
        let limited = limited.into_iter().filter_map(|(is_there, kind)| is_there.then_some(kind));
        let kinds = [Deadline::FRAME_TASKS, SUB_AREA, POINT].into_iter().chain(limited);
        let deadlines = kinds.map(|kind| (kind, Slack::default())).collect();
        Self { session, deadlines, misses: Vec::new() }
    }

    /// Whether the machine has a deadline of this kind.
    fn has(&self, deadline: Deadline) -> bool {
        self.deadlines.contains_key(&deadline)
    }

    /// Counts a deadline that was met or missed by so many ticks; `missed` tells of a miss.
    fn add(&mut self, deadline: Deadline, slack: i64, missed: impl FnOnce() -> Missed) {
        self.deadlines.entry(deadline).or_default().add(slack);
        if slack < 0 {
            self.misses.push(missed());
        }
    }

    /// Counts the places of a memory of `places` that `kept` things have.
    fn add_kept(&mut self, deadline: Deadline, places: u32, kept: u32) {
        let slack = self.deadlines.entry(deadline).or_default();
        (1..=kept).for_each(|place| slack.add(i64::from(places) - i64::from(place)));
    }

    /// Whether geometry and lists took less than the frame before.
    pub fn frame_tasks(&mut self, work: &Work, frame: u64) {
        let late = work.before_frame(&self.session.hardware) as i64 - frame as i64;
        self.add(Deadline::FRAME_TASKS, -late, || Missed {
            came: Some(late as f64),
            ..Missed::of(Deadline::FRAME_TASKS, 0, Cause::Processor)
        });
    }

    /// Places in the lists, where those are limited.
    pub fn lists(&mut self, Drawn { picture, lost }: &Drawn) {
        let Memory { list_entries, list_depth, .. } = self.session.hardware.memory;
        if let Some(depth) = list_depth {
            picture.readings.iter().for_each(|reading| self.add_kept(LIST, depth, reading.triangles));
        } else if let Some(most) = list_entries {
            self.add_kept(LIST, most, picture.entries as u32);
        }
        let [columns, _] = self.session.screen.counts();
        for lost in lost {
            self.add(LIST, -i64::from(lost.short), || Missed {
                part: Some(format!("sub-area.{}.triangle.{}", lost.sub_area, lost.triangle)),
                ..Missed::of(LIST, lost.sub_area / columns, Cause::Occupied)
            });
        }
    }

    /// Places in the light point store, where that is limited.
    pub fn store(&mut self, gathered: &Gathered) {
        let Some(most) = self.session.hardware.memory.points else { return };
        self.add_kept(STORE, most, gathered.scene.lights.points.len() as u32);
        for (short, point) in (1..).zip(&gathered.lost_points) {
            let row = self.row(point.middle[1]);
            self.add(STORE, -short, || Missed {
                part: Some(part(point)),
                ..Missed::of(STORE, row, Cause::Occupied)
            });
        }
    }

    /// Slots of the stacks, where those are limited.
    pub fn stacks(&mut self, picture: &Picture) {
        if !self.has(STACK) {
            return;
        }
        let [columns, _] = self.session.screen.counts();
        for (number, reading) in (0..).zip(&picture.readings) {
            self.add(STACK, -i64::from(reading.lost), || Missed {
                part: Some(format!("sub-area.{number}")),
                ..Missed::of(STACK, number / columns, Cause::Occupied)
            });
        }
    }

    /// Whether every sub-area was read out in time.
    pub fn sub_areas(&mut self, course: &Course, frame: u64) {
        let dues = work::dues(&self.session.screen, frame);
        for ((number, &came), (row, due)) in (0_u32..).zip(&course.read_out).zip(dues) {
            self.add(SUB_AREA, due as i64 - came as i64, || Missed {
                part: Some(format!("sub-area.{number}")),
                due: due as f64,
                came: Some(came as f64),
                ..Missed::of(SUB_AREA, row, Cause::Queue)
            });
        }
    }

    /// Whether the picture is complete at tick `end`, when its field of `field` ticks ends, where frames may take more fields.
    /// One that is never begun has no end.
    pub fn update(&mut self, end: Option<u64>, field: u64) {
        if !self.has(UPDATE) {
            return;
        }
        let slack = end.map_or(-(field as i64), |end| field as i64 - end as i64);
        self.add(UPDATE, slack, || Missed {
            due: field as f64,
            came: end.map(|end| end as f64),
            ..Missed::of(UPDATE, 0, Cause::Queue)
        });
    }

    /// Whether the beam drew every point from tick `start` to tick `due`.
    pub fn beam(&mut self, gathered: &Gathered, picture: &Picture, [start, due]: [u64; 2]) {
        let points = &gathered.scene.lights.points;
        let drawn = picture.beam.drawn.iter().map(|point| (point, true));
        let dropped = picture.beam.dropped.iter().map(|point| (point, false));
        for (place, (point, is_drawn)) in (1..).zip(drawn.chain(dropped)) {
            let came = start + work::beam_ticks(&self.session.hardware, place);
            // A point without time is late, be it by less than a tick.
            let slack = (due as i64 - came as i64).min(if is_drawn { i64::MAX } else { -1 });
            let BeamPoint { id, place: at, .. } = *point;
            let row = self.row(at[1]);
            self.add(POINT, slack, || Missed {
                part: points.iter().find(|known| known.id == id).map(part),
                due: due as f64,
                came: is_drawn.then_some(came as f64),
                ..Missed::of(POINT, row, Cause::Queue)
            });
        }
    }

    /// Row of sub-areas at a height of the screen (pixels); that at the border for what lies beyond.
    fn row(&self, y: f64) -> u32 {
        let [_, rows] = self.session.screen.counts();
        ((y.max(0.0) / SIDE as f64) as u32).min(rows - 1)
    }
}

/// A light point by its number among those of the mission.
fn part(point: &Point) -> String {
    format!("light.{}", point.light)
}
