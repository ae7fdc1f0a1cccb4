//! Words on their way to parts that wait for them, and those of craters (section 10; hardware section 3.7).

use std::collections::BTreeMap;

use features::Crater;
use hardware_model::{LatePolicy, Organisation};

use crate::clock::{Clock, starts};
use crate::drums::Arrivals;
use crate::event::{Event, Happening, Outcome, Part};
use crate::scene::SceneData;

/// Words of a crater.
const CRATER_WORDS: f64 = 8.0;

/// Nearer to a tick than this, rounding decides which tick sees an instant.
const UNDECIDED: f64 = 1e-6;

/// A sweep over the ground, as the loads of its parts see it.
#[derive(Debug, Clone, Copy)]
pub struct Passing<'a> {
    /// Number of the sweep.
    pub sweep: u32,
    /// Cosine and sine of its azimuth.
    pub direction: [f64; 2],
    /// Ground range of each sample (m).
    pub ranges: &'a [f64],
    /// Ground range at which its ground ends (m).
    pub end: f64,
}

impl Passing<'_> {
    /// Ground range that the sweep passes at an instant (m); nothing lies behind the last sample.
    fn range_at(&self, time: f64) -> f64 {
        let ranges = self.ranges;
        if time <= 0.0 {
            return ranges[0] * (1.0 + time).max(0.0);
        }
        let before = time.floor() as usize;
        match (ranges.get(before), ranges.get(before + 1)) {
            (Some(near), Some(far)) => near + (far - near) * (time - before as f64),
            _ => f64::INFINITY,
        }
    }

    /// When the sweep passes a ground range (accumulator steps): between two samples it goes on at one rate.
    fn time_of(&self, range: f64) -> f64 {
        let ranges = self.ranges;
        match (1..ranges.len()).find(|&k| range <= ranges[k]) {
            _ if range <= ranges[0] => range / ranges[0] - 1.0,
            Some(k) => (k - 1) as f64 + (range - ranges[k - 1]) / (ranges[k] - ranges[k - 1]),
            None => f64::INFINITY,
        }
    }
}

/// Loads of one kind in a sweep.
#[derive(Debug, Clone, Default)]
pub struct Loads {
    /// What became of each.
    pub events: Vec<Event>,
    /// Whether rounding says which tick sees one of them.
    pub undecided: bool,
    /// Craters that are drawn, in the order of the list.
    pub drawn: Vec<DrawnCrater>,
}

/// A crater in a sub-generator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnCrater {
    /// Its number in the list.
    pub crater: u32,
    /// The sub-generator of its type that draws it.
    pub sub_generator: u32,
    /// Ground range from which it is drawn, if its words came behind its edge (m); negative infinity if they were in time.
    pub from: f64,
}

/// A load that a sweep asks for, in the order in which it comes to need them.
#[derive(Debug, Clone, Copy)]
pub struct Request {
    /// Part that the words are loaded into.
    pub part: Part,
    /// Which parts can take it: each kind has its own.
    pub pool: usize,
    /// Ground ranges from which a part is taken, and from which it is free again (m).
    pub taken: [f64; 2],
    /// Ground range at which its words are wanted (m).
    pub due: f64,
    /// Ground range from which nobody waits for them any more (m).
    pub end: f64,
    /// Ground range before which they do not set out, though the part is free (m).
    pub not_before: Option<f64>,
}

/// The line over which words come, one load after another, from the retrace before the sweep on.
pub struct Line<'a> {
    passing: &'a Passing<'a>,
    clock: Clock,
    /// Ticks of one load; none if loads take no time.
    ticks: Option<i64>,
    /// Tick from which on the line is free.
    free: i64,
    /// Whether words that come late act from then on.
    strobes_through: bool,
    loads: Loads,
}

impl<'a> Line<'a> {
    /// The line of a sweep, for loads of `words` words at `rate` words a second.
    pub fn new(scene: &SceneData<'_>, passing: &'a Passing<'a>, words: f64, rate: Option<f64>) -> Self {
        let clock = Clock::of(scene, passing.sweep);
        let timebase = &scene.settings.timebase;
        // Times of a model are rounded: a last bit makes no tick.
        let ticks = |rate: f64| (words * timebase.master.hertz() / rate * (1.0 - 1e-9)).ceil() as i64;
        let free = clock.seen(-f64::from(timebase.retrace_samples));
        let strobes_through = scene.settings.loader.late_policy == LatePolicy::StrobeThrough;
        Self { passing, clock, ticks: rate.map(ticks), free, strobes_through, loads: Loads::default() }
    }

    /// Gives a part to each request; there are `limit` of each kind, any number if there is none.
    pub fn serve(mut self, requests: &[Request], limit: Option<u32>) -> Loads {
        // Ground range from which on each part that was used is free again, by kind.
        let mut pools: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
        for request in requests {
            let pool = pools.entry(request.pool).or_default();
            let Some(number) = self.choose(pool, request.taken[0], limit) else {
                self.at_once(request.part, Outcome::Dropped, request.due);
                continue;
            };
            let free = pool.get(number).copied();
            pool.resize(pool.len().max(number + 1), f64::NEG_INFINITY);
            pool[number] = request.taken[1];
            self.load(Request { part: self.numbered(request.part, number as u32), ..*request }, free);
        }
        self.loads
    }

    /// The part that a request takes: the first that is free, or where words take time one that has been free for longest.
    fn choose(&self, pool: &[f64], taken: f64, limit: Option<u32>) -> Option<usize> {
        let unused = limit.is_none_or(|limit| pool.len() < limit as usize).then_some(pool.len());
        let mut free = (0..pool.len()).filter(|&number| pool[number] <= taken);
        match self.ticks {
            None => free.next().or(unused),
            Some(_) => unused.or_else(|| free.min_by(|&a, &b| pool[a].total_cmp(&pool[b]))),
        }
    }

    /// A part with its number; of line generators whose words take no time nobody tells which one has them.
    fn numbered(&self, part: Part, number: u32) -> Part {
        match part {
            Part::Crater { crater, .. } => Part::Crater { crater, sub_generator: Some(number) },
            Part::Segment { .. } => Part::Segment { line_generator: self.ticks.map(|_| number) },
        }
    }

    /// Brings words to a part that is free from ground range `free` on, or always was (m).
    fn load(&mut self, Request { part, due, end, not_before, .. }: Request, free: Option<f64>) {
        let Some(ticks) = self.ticks else {
            self.draw(part, f64::NEG_INFINITY);
            return self.at_once(part, Outcome::InTime, due);
        };
        let sets_out = not_before.map_or(free, |range| Some(free.map_or(range, |free| free.max(range))));
        let begins = sets_out.map_or(self.free, |range| self.free.max(self.seen(range)));
        if self.clock.time_of(begins) >= self.passing.time_of(end) {
            return self.dropped_on_the_way(part, due);
        }
        self.free = begins + ticks;
        let last_in_time = self.clock.last_before(self.passing.time_of(due)).max(0);
        let slack = last_in_time - self.free;
        let outcome = if slack < 0 { Outcome::Late } else { Outcome::InTime };
        self.note(self.free, part, outcome, Some(slack));
        let comes = self.passing.range_at(self.clock.time_of(self.free));
        match outcome {
            Outcome::InTime => self.draw(part, f64::NEG_INFINITY),
            _ if self.strobes_through && comes < end => self.draw(part, comes),
            _ => {}
        }
    }

    fn draw(&mut self, part: Part, from: f64) {
        if let Part::Crater { crater, sub_generator: Some(sub_generator) } = part {
            self.loads.drawn.push(DrawnCrater { crater, sub_generator, from });
        }
    }

    /// Words that could not set out before the sweep had left what they are for.
    fn dropped_on_the_way(&mut self, part: Part, due: f64) {
        let tick = self.seen(due);
        self.note(tick, part, Outcome::Dropped, None);
    }

    /// What is there, or finds no part, as the sweep passes `range` (m); before its first sample, at that.
    fn at_once(&mut self, part: Part, outcome: Outcome, range: f64) {
        let tick = self.seen(range.max(self.passing.ranges[0]));
        self.note(tick, part, outcome, None);
    }

    /// The tick that sees the sweep pass a ground range (m).
    fn seen(&mut self, range: f64) -> i64 {
        let time = self.passing.time_of(range);
        self.loads.undecided |= time.is_finite() && self.clock.distance_to_tick(time) < UNDECIDED;
        self.clock.seen(time)
    }

    fn note(&mut self, tick: i64, part: Part, outcome: Outcome, slack: Option<i64>) {
        self.loads.events.push(Event { tick, level: None, what: Happening::Words { part, outcome, slack } });
    }
}

/// Loads of the craters that the sweep meets. `absent`: squares whose craters the storage buffer has not as the frame begins.
pub fn craters(scene: &SceneData<'_>, passing: &Passing<'_>, absent: &Arrivals) -> Loads {
    let parts = scene.settings.feature_generator;
    let begins = starts(scene, scene.frame)[passing.sweep as usize];
    let records = records(scene);
    let is_there = |number: u32| {
        let comes = absent.get(&[records[number as usize], 0]);
        comes.is_none_or(|comes| comes.is_some_and(|tick| tick <= begins))
    };
    let all = (0..).zip(scene.landscape.features().craters().iter());
    let all = all.filter(|(number, _)| is_there(*number));
    let mut requests: Vec<Request> =
        all.filter_map(|(number, crater)| request(scene, passing, number, &crater)).collect();
    requests.sort_by(|a, b| a.taken[0].total_cmp(&b.taken[0]).then(a.due.total_cmp(&b.due)));
    let mut loads = Line::new(scene, passing, CRATER_WORDS, scene.settings.feature_words)
        .serve(&requests, parts.sub_generators);
    loads.drawn.sort_by_key(|drawn| drawn.crater);
    loads
}

/// The record that holds each crater: records of a square one after another, as many craters in each as it has room for.
fn records(scene: &SceneData<'_>) -> Vec<i64> {
    let level = scene.fine();
    let bank = &scene.settings.kind_banks.features;
    let regions = bank.record_regions as usize;
    let squares = level.corners().map(|corners| (corners - 1).div_ceil(regions) as i64);
    let room = i64::from(bank.record_words) / CRATER_WORDS as i64;
    let mut filled: BTreeMap<i64, i64> = BTreeMap::new();
    let record = |crater: Crater| {
        let [north, east] = [0, 1].map(|axis| {
            let side = level.region_size() * regions as f64;
            let along = ((crater.centre()[axis] - level.origin()[axis]) / side).floor() as i64;
            along.clamp(0, squares[axis] - 1)
        });
        let square = north * squares[1] + east;
        let before = filled.entry(square).or_insert(0);
        *before += 1;
        square + (*before - 1) / room * squares[0] * squares[1]
    };
    scene.landscape.features().craters().iter().map(record).collect()
}

/// What a crater asks for; none if the sweep does not meet it.
fn request(scene: &SceneData<'_>, passing: &Passing<'_>, number: u32, crater: &Crater) -> Option<Request> {
    let ([cos, sin], centre) = (passing.direction, crater.centre());
    let [north, east] = [centre[0] - scene.eye[0], centre[1] - scene.eye[1]];
    let (middle, beside) = (north * cos + east * sin, east * cos - north * sin);
    let half = (crater.outer() * crater.outer() - beside * beside).max(0.0).sqrt();
    let (enters, leaves) = ((middle - half).max(passing.ranges[0]), (middle + half).min(passing.end));
    let is_met = half > 0.0 && enters < leaves;
    let by_region = scene.settings.feature_generator.organisation == Organisation::ByRegion;
    let region = |range: f64| region(scene, passing.direction, range);
    let taken = if by_region { [region(enters)[0], region(leaves)[1]] } else { [enters, leaves] };
    is_met.then_some(Request {
        part: Part::Crater { crater: number, sub_generator: None },
        pool: crater.type_number() as usize,
        taken,
        due: enters,
        end: leaves,
        not_before: by_region.then_some(taken[0]),
    })
}

/// Ground ranges at which a sweep enters and leaves the region of the fine level that it is in at `range` (m).
fn region(scene: &SceneData<'_>, direction: [f64; 2], range: f64) -> [f64; 2] {
    let level = scene.fine();
    let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
    for axis in (0..2).filter(|&axis| direction[axis] != 0.0) {
        let foot = scene.eye[axis] - level.origin()[axis];
        let line = ((foot + range * direction[axis]) / level.region_size()).floor();
        let meets = [line, line + 1.0].map(|line| (line * level.region_size() - foot) / direction[axis]);
        ends = [ends[0].max(meets[0].min(meets[1])), ends[1].min(meets[0].max(meets[1]))];
    }
    ends
}
