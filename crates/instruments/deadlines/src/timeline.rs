//! One sweep as a timeline: what its registers wait for, below the ramps.

use std::path::Path;

use ::plots::{
    Axis, EventLane, Panel, Span as Bar, Stops, Stretch, Timeline, Trace, TraceLook, timeline_picture,
};
use machine::FrameSweeps;
use quantities::SweepTime;
use sweep_generator::RangeTable;
use sweep_program::{Colour, NO_CORNER, PreloadRegister, RampAxis, SweepProgram};

use crate::critical_path::{colour_word, register_word};
use crate::levels::{DrawnLevel, drawn_levels};
use crate::sets::{AskedSet, crossings, sets_of};
use crate::{DeadlineError, Rehearsal};

/// A sweep whose timeline is drawn.
#[derive(Debug, Clone, Copy)]
pub struct TimelineOf {
    /// Frame of the sweep, counted at the update rate.
    pub frame: u64,
    /// The sweep, from 0 at the left.
    pub sweep: u32,
    /// Whether it is that of the coarse level, where the scenario has one.
    pub is_coarse: bool,
    /// Ground ranges between which it is drawn (m); all of the sweep if left out.
    pub range: Option<[f64; 2]>,
}

/// Draws the timeline of a sweep: PNG or SVG, as the file is named.
///
/// # Errors
/// If the pose cannot be drawn, the sweep does not go to the nearer range, or the picture cannot be drawn or written.
pub fn write_timeline(rehearsal: &Rehearsal, of: TimelineOf, path: &Path) -> Result<(), DeadlineError> {
    let TimelineOf { frame, sweep, is_coarse, range } = of;
    let poses = rehearsal.poses(&[frame])?;
    let sweeps = rehearsal.control.sweeps(frame, &poses[0].pose)?;
    let levels = drawn_levels(&rehearsal.stage);
    let number = usize::from(is_coarse).min(levels.len() - 1);
    let title = format!("{} on {}", rehearsal.scenario.title, rehearsal.model.name);
    SweepTimeline::new(&sweeps, levels[number], (frame, sweep)).draw(&title, range, path)
}

/// A sweep that has been timed.
struct SweepTimeline<'a> {
    of: DrawnLevel<'a>,
    table: &'a RangeTable,
    /// Frame, sweep, and the sweep whose set-up draws it.
    place: (u64, u32, u32),
    program: SweepProgram,
    sets: Vec<AskedSet>,
}

impl<'a> SweepTimeline<'a> {
    /// Times a sweep over one level of a frame.
    fn new(sweeps: &'a FrameSweeps<'_>, of: DrawnLevel<'a>, (frame, sweep): (u64, u32)) -> Self {
        let program = sweeps.programs(sweep).swap_remove(of.number);
        let mut sets = Vec::new();
        sets_of(&program, sweeps.loader().is_wired_through(), &mut sets);
        Self { of, table: sweeps.table(), place: (frame, sweep, sweeps.set_up_of(sweep)), program, sets }
    }

    /// Draws it over `range` (m), or over all of the sweep, under `title`.
    fn draw(&self, title: &str, range: Option<[f64; 2]>, path: &Path) -> Result<(), DeadlineError> {
        let window = self.window(range)?;
        let (x, ramps) = self.ramps(window);
        let traces = ["sweep.x", "sweep.y"].into_iter().zip(&ramps).map(|(name, y)| Trace { name, x: &x, y });
        let panel = Panel { axis: Axis::new("ramp (regions)").over([-0.05, 1.05]), traces: traces.collect() };
        let timeline = Timeline {
            x: Axis::new("ground range (m)").over(window),
            panels: vec![panel],
            stops: [RampAxis::X, RampAxis::Y].map(|axis| self.stops(axis)).into(),
            lanes: self.lanes(),
        };
        let look = TraceLook { facts: self.facts(), width: 1200, height: 180, ..TraceLook::titled(title) };
        let picture = timeline_picture(&timeline, &look).map_err(DeadlineError::Asked)?;
        picture.write(path).map_err(DeadlineError::Write)
    }

    /// What is asked for of the sweep, or all of it.
    fn window(&self, range: Option<[f64; 2]>) -> Result<[f64; 2], DeadlineError> {
        let (end, (_, sweep, _)) = (self.program.end_range, self.place);
        match range {
            Some([near, far]) if near >= end => Err(DeadlineError::BeyondSweep { near, far, sweep, end }),
            asked => Ok(asked.unwrap_or([0.0, end])),
        }
    }

    fn facts(&self) -> Vec<String> {
        let late = self.sets.iter().filter(|set| set.late).count();
        let used = self.sets.iter().filter(|set| set.used.is_some()).count();
        let (crossings, level) = (crossings(&self.program).count(), self.of.name);
        let (frame, sweep, drawn) = self.place;
        let counts = format!(
            "frame {frame}, sweep {sweep}, {level} level: {crossings} crossings, {used} sets used, {late} of them late"
        );
        let late_set_up =
            (drawn != sweep).then(|| format!("its own set-up is late: drawn with that of sweep {drawn}"));
        let missing = self.missing();
        let missing = (missing > 0).then(|| {
            format!("{missing} sets of corners that are not in the storage buffer, home registers with them")
        });
        [counts].into_iter().chain(late_set_up).chain(missing).collect()
    }

    /// Sets whose corner the data bank has not brought, those of the home registers too.
    fn missing(&self) -> usize {
        let home = self.program.registers.iter().flat_map(|set| [set.hold, set.x_first, set.y_first]);
        let sets = self.sets.iter().filter(|set| set.is_missing);
        home.filter(|&corner| corner == NO_CORNER).count() + sets.count()
    }

    /// Ground ranges of the folds of one ramp (m).
    fn folds(&self, axis: RampAxis) -> Vec<f64> {
        crossings(&self.program).filter(|(_, fold)| fold.axis == axis).map(|(range, _)| range).collect()
    }

    fn stops(&self, axis: RampAxis) -> Stops {
        let name = if axis == RampAxis::X { "X stop" } else { "Y stop" };
        Stops { name: name.into(), at: self.folds(axis) }
    }

    /// Places within `window`, all folds among them, and both ramps there.
    fn ramps(&self, [low, high]: [f64; 2]) -> (Vec<f64>, [Vec<f64>; 2]) {
        let samples = self.table.ranges().iter().copied();
        let folds = crossings(&self.program).map(|(range, _)| range);
        let end = self.program.end_range.min(high);
        let mut x: Vec<f64> =
            samples.chain(folds).chain([low, end]).filter(|&range| range >= low && range <= end).collect();
        x.sort_by(f64::total_cmp);
        let ramps = [RampAxis::X, RampAxis::Y].map(|axis| {
            let ramp = self.program.start.ramps[usize::from(axis == RampAxis::Y)];
            let folds = self.folds(axis);
            let value = |&range: &f64| {
                let passed = folds.partition_point(|&fold| fold <= range) as u32;
                ramp.at(passed, range / self.of.level.region_size()).0
            };
            x.iter().map(value).collect()
        });
        (x, ramps)
    }

    /// Two lanes a colour.
    fn lanes(&self) -> Vec<EventLane> {
        let registers = [PreloadRegister::XFirst, PreloadRegister::YFirst];
        let all = Colour::ALL.into_iter().flat_map(|colour| registers.map(|register| (colour, register)));
        all.map(|(colour, register)| {
            let ours = self.sets.iter().filter(|set| set.colour == colour && set.register == register);
            let name = format!("{} {}", colour_word(colour), register_word(register));
            EventLane { name, spans: ours.flat_map(|set| self.bars(set)).collect() }
        })
        .collect()
    }

    /// On its way from the fold that asks, late from the fold that needs it, ready until it is used; words of a corner that
    /// is not there are as wrong as late ones.
    fn bars(&self, set: &AskedSet) -> Vec<Bar> {
        let asked = set.asked.range;
        let used = set.used.map_or(self.program.end_range, |used| used.range);
        let came = set.came.map(|came| self.range_at(came));
        let bar = |from, to, stretch| Bar { from, to, stretch };
        match (set.late, came) {
            (true, came) => {
                let to = came.unwrap_or_else(|| self.next_use(set));
                vec![bar(asked, used, Stretch::OnItsWay), bar(used, to, Stretch::Late)]
            }
            (false, Some(came)) => {
                let waits = if set.is_missing { Stretch::Late } else { Stretch::Ready };
                vec![bar(asked, came, Stretch::OnItsWay), bar(came, used, waits)]
            }
            // Dropped, since its colour has moved on.
            (false, None) => Vec::new(),
        }
    }

    /// A set that never comes is missed until the next of its register is used.
    fn next_use(&self, set: &AskedSet) -> f64 {
        let after = |other: &&AskedSet| {
            (other.colour, other.register) == (set.colour, set.register)
                && other.asked.number > set.asked.number
        };
        let next = self.sets.iter().filter(after).find_map(|other| other.used);
        next.map_or(self.program.end_range, |used| used.range)
    }

    fn range_at(&self, time: SweepTime) -> f64 {
        self.table.range_at(time).min(self.program.end_range)
    }
}
