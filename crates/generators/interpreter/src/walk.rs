//! One terrain generator along a sweep: ramps, stops, registers, sums.

use hardware_model::Loader;
use landscape::Level;

use crate::clock::Clock;
use crate::drums::Arrivals;
use crate::event::Event;
use crate::parts::{Array, Drawn, Figures, Sweep};
use crate::ramp::Ramp;
use crate::registers::{Registers, Start};
use crate::scene::SceneData;
use crate::server::Interrupts;
use crate::terrain::{Sums, sums};

/// Nearer to a tick than this, rounding decides which tick sees a stop.
const UNDECIDED: f64 = 1e-6;

/// Nearer to one another than this share of their range, rounding decides which of two stops comes first.
const SAME_PLACE: f64 = 1e-12;

/// Names of the arrays of both levels, by which their parts are drawn.
pub const ARRAYS: [&str; 2] = ["tg", "mtg"];

/// Signals of a terrain generator at one sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Triangles in the accumulators (regions, 0..=1).
    pub accumulators: [f64; 2],
    /// Folded ramps X and Y (regions, 0..=1), behind converter and smoother where there are any.
    pub ramps: [f64; 2],
    /// What the array gives.
    pub sums: Sums,
    /// Height of the terrain (m).
    pub height: f64,
    /// Slopes to the north and to the east.
    pub slopes: [f64; 2],
    /// Distance of the accumulators from another word of their converters (full scales): the least within the memory of the parts.
    /// It is infinite without converters.
    pub stairs: f64,
}

/// A walk up to the end of the ground asked for, or of the stored area.
#[derive(Debug, Clone, Default)]
pub struct Walk {
    /// Samples on the way.
    pub samples: Vec<Sample>,
    /// Events of the registers on the way.
    pub events: Vec<Event>,
    /// Instants of the stops, in accumulator steps from the first sample, with axis (0 is X).
    pub stops: Vec<(f64, usize)>,
    /// Ground range at which the stored area ended, if it did (m).
    pub edge: Option<f64>,
    /// Ticks in which it is rounding that says when a stop is seen.
    pub undecided: Vec<i64>,
    /// The last tick of the walk.
    pub last_tick: i64,
    /// The array of real parts as the sweep drives it, where there is one.
    pub array: Option<Array>,
}

/// Which generator, and how far.
#[derive(Debug, Clone, Copy)]
pub struct Course<'a> {
    /// Level of terrain that the generator walks over.
    pub level: &'a Level,
    /// Corners that its storage buffer has not when the frame begins.
    pub missing: &'a Arrivals,
    /// 0 fine, 1 coarse.
    pub number: usize,
    /// Loader that brings the words.
    pub loader: &'a Loader,
    /// Cosine and sine of the azimuth.
    pub direction: [f64; 2],
    /// Sweep whose time it is.
    pub sweep: u32,
    /// Where the processor serves the crossings, what stands before the sets of each.
    pub interrupts: Interrupts<'a>,
    /// Ground range beyond which nobody looks (m).
    pub until: f64,
    /// Steps of the clock in a sample of the machine ([`Given::between`](crate::Given)).
    pub between: usize,
    /// What the array is made of and what its seed drew, where it has real parts.
    pub parts: Option<(&'a Figures, &'a Drawn<'a>)>,
}

/// Walks along `ranges` (m).
pub fn walk(scene: &SceneData<'_>, course: &Course<'_>, ranges: &[f64]) -> Walk {
    let level = course.level;
    let ramps: [Ramp; 2] = std::array::from_fn(|axis| {
        let place = (scene.eye[axis] - level.origin()[axis]) / level.region_size();
        Ramp::at_start(place, course.direction[axis], level.region_size())
    });
    let clock = Clock::of(scene, course.sweep);
    let start = Start {
        region: ramps.each_ref().map(|ramp| ramp.region),
        heading: ramps.each_ref().map(|ramp| ramp.heading),
        rising: ramps.each_ref().map(|ramp| ramp.moves().then_some(ramp.rising)),
        interrupts: course.interrupts,
        level: course.number,
    };
    let registers = Registers::at_start((level, course.missing), course.loader, clock, start);
    let (begun, hold) = (ramps.clone(), registers.hold);
    let mut walker = Walker { course, clock, ramps, registers, found: Walk::default() };
    // The sweep leaves the eye's foot a sample before the first.
    let foot = -(course.between as f64);
    let (mut begins, mut before) = (foot, 0.0);
    walker.found.last_tick = clock.seen(foot);
    if walker.is_outside() {
        walker.found.edge = Some(0.0);
    }
    for (k, &range) in ranges.iter().enumerate() {
        if walker.found.edge.is_some() || !walker.step([begins, k as f64], before, range) {
            break;
        }
        walker.found.last_tick = clock.last_before(k as f64);
        walker.sample(range);
        (begins, before) = (k as f64, range);
    }
    let Walker { registers: Registers { events, mut changes, .. }, mut found, .. } = walker;
    found.events = events;
    if let Some((figures, drawn)) = course.parts {
        changes.iter_mut().for_each(|change| change.time /= course.between as f64);
        let sweeps = u64::from(scene.settings.raster.sweeps);
        let sweep = Sweep {
            level,
            name: ARRAYS[course.number],
            drawn,
            direction: course.direction,
            ranges: &ranges.iter().copied().step_by(course.between).collect::<Vec<_>>(),
            ramps: &begun,
            hold,
            changes: &changes,
            number: scene.frame * sweeps + u64::from(course.sweep),
        };
        let array = Array::of(&sweep, figures, found.samples.len().div_ceil(course.between));
        array.pass(&sweep, course.between, &mut found.samples);
        found.array = Some(array);
    }
    found
}

struct Walker<'a> {
    course: &'a Course<'a>,
    clock: Clock,
    ramps: [Ramp; 2],
    registers: Registers<'a>,
    found: Walk,
}

impl Walker<'_> {
    /// From ground range `from` at time `start` to `to` at time `end`, with every stop and every arrival on the way. False if the
    /// sample is not reached.
    fn step(&mut self, [start, end]: [f64; 2], from: f64, to: f64) -> bool {
        loop {
            let [x, y] = [self.ramps[0].stop(), self.ramps[1].stop()];
            let (axis, range) = if x <= y { (0, x) } else { (1, y) };
            if range > to.min(self.course.until) {
                break;
            }
            let time = start + (end - start) * (range - from) / (to - from);
            self.registers.receive(time);
            let at_one = self.ramps[axis].fold();
            if self.is_outside() {
                self.found.edge = Some(range);
                self.registers.transfer(axis, at_one, time);
                // The stop at the edge, and all that the same tick sees, is nobody's.
                self.found.last_tick = self.found.last_tick.min(self.clock.seen(time) - 1);
                return false;
            }
            let is_a_corner = (x - y).abs() <= SAME_PLACE * range;
            if is_a_corner || self.clock.distance_to_tick(time) < UNDECIDED {
                self.found.undecided.push(self.clock.seen(time));
            }
            self.registers.event(axis, at_one, time);
            self.found.stops.push((time, axis));
        }
        if to > self.course.until {
            // Parts run ahead of the beam: they see what still comes before the end of the ground asked for.
            self.registers.receive(start + (end - start) * (self.course.until - from) / (to - from));
            return false;
        }
        self.registers.receive(end);
        true
    }

    /// Whether a moving ramp is in a region that is not stored.
    fn is_outside(&self) -> bool {
        (0..2).any(|axis| {
            let last = self.course.level.corners()[axis] as i64 - 2;
            self.ramps[axis].moves() && !(0..=last).contains(&self.ramps[axis].region)
        })
    }

    fn sample(&mut self, range: f64) {
        let ramps = self.ramps.each_ref().map(|ramp| ramp.value(range));
        let polarity = self.ramps.each_ref().map(|ramp| ramp.polarity);
        let sums = sums(&self.registers.hold, ramps, polarity);
        let [height, h_u, h_v] = sums.ground;
        let d = self.course.level.region_size();
        let sample = Sample {
            accumulators: ramps,
            ramps,
            sums,
            height,
            slopes: [h_u / d, h_v / d],
            stairs: f64::INFINITY,
        };
        self.found.samples.push(sample);
    }
}
