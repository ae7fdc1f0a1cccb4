//! Sub-generators along a sweep: height, slopes, presence, and where the surface bends.
//!
//! Each chain is a lag of the law of its zone, which is straight between the samples and the circles that the sweep crosses, of any
//! crater.

use features::Crater;

use super::gates::Edge;
use super::series::LagMap;
use super::sub_generator::{Passage, SubGeneratorFigures, Zone};

/// A chain is at rest below this share of its crater's height.
const AT_REST: f64 = 1e-9;

/// A crater in its sub-generator.
#[derive(Debug, Clone, Copy)]
pub struct Loaded {
    /// The crater that the list has.
    pub crater: Crater,
    /// The sub-generator that draws it.
    pub figures: SubGeneratorFigures,
    /// Ground range from which it is drawn (m); negative infinity if its words were in time.
    pub from: f64,
}

/// A sweep over the ground.
#[derive(Debug, Clone, Copy)]
pub struct Line<'a> {
    /// The eye's foot: north, east (m).
    pub foot: [f64; 2],
    /// Cosine and sine of its azimuth.
    pub direction: [f64; 2],
    /// Ground range of each sample within the stored ground (m).
    pub ranges: &'a [f64],
}

/// Where the surface bends between two samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// Number of the sample at which the step ends.
    pub sample: usize,
    /// Part of the step, 0..=1.
    pub share: f64,
    /// Ground range of the place (m).
    pub range: f64,
    /// What craters add to the height there (m).
    pub height: f64,
    /// Slopes along and across just before it, and just behind it.
    pub slopes: [[f64; 2]; 2],
    /// Whether there is a footprint just before and just behind it.
    pub present: [bool; 2],
    /// Whether no circle is crossed, but late words have come.
    pub is_late: bool,
}

/// What all sub-generators add up to.
#[derive(Debug, Clone, Default)]
pub struct Surface {
    /// Height at each sample (m).
    pub height: Vec<f64>,
    /// Slopes along and across at each sample.
    pub slopes: Vec<[f64; 2]>,
    /// Whether the presence line is up, before any delay.
    pub present: Vec<bool>,
    /// Whether any chain is at work.
    pub at_work: Vec<bool>,
    /// Where the surface bends, ascending.
    pub bends: Vec<Bend>,
    /// Changes of the presence line by its comparators, ascending.
    pub edges: Vec<Edge>,
    /// How near each sample is to a circle on which a zone changes (share of a radius).
    pub clear: Vec<f64>,
    /// How near a chain is to rest: how far the largest of its outputs is from what counts as rest, as a share of that.
    pub rest: Vec<f64>,
}

/// A crossing of a circle.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    range: f64,
    load: usize,
    zones: [Zone; 2],
    /// First sample behind it.
    sample: usize,
    /// Whether it is where late words come.
    is_late: bool,
}

/// The sub-generators of `loads` along a sweep; `of_comparators` says whether comparators that mind how a footprint is met make the
/// presence line.
pub fn surface(line: &Line<'_>, loads: &[Loaded], of_comparators: bool) -> Surface {
    let passages: Vec<Passage> = loads
        .iter()
        .map(|load| Passage::of(&load.figures, &load.crater, line.foot, line.direction))
        .collect();
    let crossings = crossings(line.ranges, loads, &passages);
    let mut surface = Surface::at_rest(line.ranges, &crossings, &passages);
    if of_comparators {
        surface.edges = united(loads, &passages);
        surface.follow_edges(line.ranges);
    }
    let of_bends = crossings.iter().filter(|crossing| (1..line.ranges.len()).contains(&crossing.sample));
    let marks: Vec<(usize, Zone)> = of_bends.map(|crossing| (crossing.load, crossing.zones[1])).collect();
    for (load, (loaded, passage)) in loads.iter().zip(&passages).enumerate() {
        let figures = &loaded.figures;
        Chain { line, load, figures, passage, crossings: &crossings, marks: &marks }.run(&mut surface);
    }
    surface
}

/// All crossings of circles, as the sweep comes to them.
fn crossings(ranges: &[f64], loads: &[Loaded], passages: &[Passage]) -> Vec<Crossing> {
    let of_load = |(load, passage): (usize, &Passage)| {
        let all = behind(passage.crossings(), loads[load].from).into_iter();
        all.map(move |(range, zones)| {
            // A circle counts to what is outside of it.
            let inward = zones[1] > zones[0];
            let sample = ranges.partition_point(|place| *place < range || inward && *place == range);
            Crossing { range, load, zones, sample, is_late: range == loads[load].from }
        })
    };
    let mut all: Vec<Crossing> = passages.iter().enumerate().flat_map(of_load).collect();
    let inward = |crossing: &Crossing| crossing.zones[1] > crossing.zones[0];
    all.sort_by(|a, b| a.range.total_cmp(&b.range).then(inward(a).cmp(&inward(b))).then(a.load.cmp(&b.load)));
    all
}

/// Crossings of a crater that is drawn from `from` on (m): one into the zone that it is in there, then those behind.
fn behind(crossings: Vec<(f64, [Zone; 2])>, from: f64) -> Vec<(f64, [Zone; 2])> {
    let (mut passed, mut ahead): (Vec<_>, Vec<_>) =
        crossings.into_iter().partition(|(range, _)| *range < from);
    passed.sort_by(|a, b| a.0.total_cmp(&b.0));
    let zone = passed.last().map_or(Zone::Outside, |(_, zones)| zones[1]);
    if from.is_finite() && zone != Zone::Outside {
        ahead.push((from, [Zone::Outside, zone]));
    }
    if from.is_finite() { ahead } else { passed.into_iter().chain(ahead).collect() }
}

/// Changes of the presence line as the comparators of all footprints make it, which see `1 - rho^2 / R^2`.
fn united(loads: &[Loaded], passages: &[Passage]) -> Vec<Edge> {
    let mut rims: Vec<(Edge, i32)> = Vec::new();
    for (load, passage) in loads.iter().zip(passages) {
        let square = passage.crater.outer() * passage.crater.outer();
        let [enters, leaves] = passage.chord(square * (1.0 - load.figures.threshold));
        if leaves > enters.max(load.from) {
            let slope = (leaves - enters) / square;
            // What comes late is there at once.
            let begin = if load.from > enters {
                Edge { range: load.from, slope: f64::INFINITY }
            } else {
                Edge { range: enters, slope }
            };
            rims.extend([(begin, 1), (Edge { range: leaves, slope }, -1)]);
        }
    }
    rims.sort_by(|a, b| a.0.range.total_cmp(&b.0.range).then(b.1.cmp(&a.1)));
    let mut depth = 0;
    let changes = rims.into_iter().filter_map(|(edge, step)| {
        let before = depth;
        depth += step;
        ((before > 0) != (depth > 0)).then_some(edge)
    });
    changes.collect()
}

impl Surface {
    /// No chain has put anything out; the presence line of the footprints.
    fn at_rest(ranges: &[f64], crossings: &[Crossing], passages: &[Passage]) -> Self {
        let samples = ranges.len();
        let mut surface = Self {
            height: vec![0.0; samples],
            slopes: vec![[0.0; 2]; samples],
            present: vec![false; samples],
            at_work: vec![false; samples],
            clear: vec![f64::INFINITY; samples],
            rest: vec![f64::INFINITY; samples],
            ..Self::default()
        };
        let (mut inside, mut from) = (0, 0);
        for crossing in crossings {
            surface.present[from..crossing.sample].fill(inside > 0);
            from = crossing.sample;
            let before = inside > 0;
            inside +=
                i32::from(crossing.zones[0] == Zone::Outside) - i32::from(crossing.zones[1] == Zone::Outside);
            surface.come_near(ranges, crossing.range, passages[crossing.load].crater.outer());
            if (1..samples).contains(&crossing.sample) {
                surface.bends.push(bend(ranges, crossing, [before, inside > 0]));
            }
        }
        surface.present[from..].fill(inside > 0);
        surface
    }

    /// The presence line anew, from its edges.
    fn follow_edges(&mut self, ranges: &[f64]) {
        let edges = self.edges.clone();
        for (sample, range) in ranges.iter().enumerate() {
            self.present[sample] = edges.iter().filter(|edge| edge.range <= *range).count() % 2 == 1;
        }
        edges.iter().for_each(|edge| self.come_near(ranges, edge.range, 1.0));
    }

    /// Samples beside a place know how near it is, as a share of `radius`.
    fn come_near(&mut self, ranges: &[f64], place: f64, radius: f64) {
        let behind = ranges.partition_point(|range| *range < place);
        for sample in behind.saturating_sub(1)..(behind + 1).min(ranges.len()) {
            self.clear[sample] = self.clear[sample].min((ranges[sample] - place).abs() / radius);
        }
    }
}

fn bend(ranges: &[f64], crossing: &Crossing, present: [bool; 2]) -> Bend {
    let [near, far] = [ranges[crossing.sample - 1], ranges[crossing.sample]];
    Bend {
        sample: crossing.sample,
        share: (crossing.range - near) / (far - near),
        range: crossing.range,
        height: 0.0,
        slopes: [[0.0; 2]; 2],
        present,
        is_late: crossing.is_late,
    }
}

/// One chain along the sweep.
struct Chain<'a> {
    line: &'a Line<'a>,
    load: usize,
    figures: &'a SubGeneratorFigures,
    passage: &'a Passage,
    crossings: &'a [Crossing],
    /// Of each bend: the crater whose circle it is, and the zone behind it.
    marks: &'a [(usize, Zone)],
}

/// Input and output of a chain at an instant (steps): height, slope along, slope across.
#[derive(Debug, Clone, Copy)]
struct State {
    at: f64,
    input: [f64; 3],
    output: [f64; 3],
}

impl Chain<'_> {
    fn run(&self, surface: &mut Surface) {
        let samples = self.line.ranges.len();
        let own = |crossing: &&Crossing| crossing.load == self.load && crossing.sample < samples;
        let Some(first) = self.crossings.iter().find(own).map(|crossing| crossing.sample) else { return };
        let last = self.crossings.iter().rfind(|crossing| crossing.load == self.load);
        let last = last.map_or(f64::INFINITY, |crossing| crossing.range);
        let mut zone = self.zone_at_first();
        let mut state = self.begins(zone, first);
        let mut next = surface.bends.partition_point(|bend| bend.sample < first.max(1));
        for sample in first.max(usize::from(first > 0))..samples {
            while let Some(bend) =
                surface.bends.get_mut(next).filter(|bend| bend.sample == sample && sample > 0)
            {
                zone = self.cross(&mut state, zone, next, bend);
                next += 1;
            }
            if sample > 0 {
                let law = self.passage.law(zone, self.line.ranges[sample]);
                self.advance(&mut state, sample as f64, law);
            }
            self.add(&state, sample, surface);
            if zone == Zone::Outside && self.line.ranges[sample] > last && self.rests(&state, sample, surface)
            {
                break;
            }
        }
    }

    /// What zone the first sample lies in.
    fn zone_at_first(&self) -> Zone {
        let own = |crossing: &&Crossing| crossing.load == self.load && crossing.sample == 0;
        self.crossings.iter().rfind(own).map_or(Zone::Outside, |crossing| crossing.zones[1])
    }

    /// At rest in the zone of the first sample, or outside a sample before the first crossing.
    fn begins(&self, zone: Zone, first: usize) -> State {
        if first > 0 {
            return State { at: first as f64 - 1.0, input: [0.0; 3], output: [0.0; 3] };
        }
        let law = self.passage.law(zone, self.line.ranges[0]);
        State { at: 0.0, input: law, output: law }
    }

    /// Over a bend of any crater; its own changes the zone.
    fn cross(&self, state: &mut State, zone: Zone, number: usize, bend: &mut Bend) -> Zone {
        let at = bend.sample as f64 - 1.0 + bend.share;
        self.advance(state, at, self.passage.law(zone, bend.range));
        let before = state.output;
        let (load, behind) = self.marks[number];
        let behind = if load == self.load { behind } else { zone };
        if behind != zone {
            state.input = self.passage.law(behind, bend.range);
        }
        let after = if self.figures.tau == 0.0 { state.input } else { before };
        bend.height += self.figures.gain * before[0];
        for (sum, side) in bend.slopes.iter_mut().zip([before, after]) {
            sum[0] += self.figures.gain * side[1];
            sum[1] += self.figures.gain * side[2];
        }
        behind
    }

    fn advance(&self, state: &mut State, at: f64, input: [f64; 3]) {
        let lag = LagMap::of((at - state.at).max(0.0), self.figures.tau);
        let step = |k: usize| lag.step(state.output[k], [state.input[k], input[k]]);
        *state = State { at, input, output: [0, 1, 2].map(step) };
    }

    fn add(&self, state: &State, sample: usize, surface: &mut Surface) {
        let [height, along, across] = state.output.map(|value| self.figures.gain * value);
        surface.height[sample] += height;
        surface.slopes[sample][0] += along;
        surface.slopes[sample][1] += across;
        surface.at_work[sample] = true;
    }

    fn rests(&self, state: &State, sample: usize, surface: &mut Surface) -> bool {
        let crater = &self.passage.crater;
        let height = AT_REST * (crater.depth() + crater.rim());
        let slope = height / crater.foot();
        let limits = [height, slope, slope];
        let rests = state.output.iter().zip(limits).all(|(value, limit)| value.abs() <= limit);
        let largest =
            state.output.iter().zip(limits).map(|(value, limit)| value.abs() / limit).fold(0.0, f64::max);
        surface.rest[sample] = surface.rest[sample].min((largest - 1.0).abs());
        rests
    }
}
