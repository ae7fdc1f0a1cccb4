//! A group of sweeps, from program to profiles.

use std::ops::Range;

use landscape::{CornerWords, GroupLight, SweepLight};
use signal::{LANES, Lanes, Real, Signal, Unit};
use sweep_program::{Load, Step, StepKind, SweepProgram, Target};

use crate::array::array;
use crate::region::RecentRegions;
use crate::{Registers, Segment, Span};

/// Height of a profile beyond its end (m): lower than any real ground, so nothing of it is seen. A power of two, so that
/// it is exact in f32.
pub const OUT_OF_SIGHT: f64 = -1_073_741_824.0;

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("tg.height", Unit::Metre, "terrain height above the lunoid's tangent plane", "fig. 24"),
    Signal::ground("tg.slope.u", Unit::Slope, "terrain slope to the north", "section 7"),
    Signal::ground("tg.slope.v", Unit::Slope, "terrain slope to the east", "section 7"),
    Signal::ground(
        "tg.reflectivity",
        Unit::Reflectivity,
        "reflectivity of the terrain: n.s, factor of the law, albedo",
        "fig. 24",
    ),
];

/// Signals inside the array, computed for a probe alone: what feeds its products and what each colour adds.
pub const INNER_SIGNALS: &[Signal] = &[
    function("tg.fn.x.g0", "g0 of ramp X"),
    function("tg.fn.x.g1", "g1 of ramp X"),
    function("tg.fn.x.g2", "g2 of ramp X"),
    function("tg.fn.cx.g0", "g0 of 1 - X"),
    function("tg.fn.cx.g1", "g1 of 1 - X"),
    function("tg.fn.cx.g2", "g2 of 1 - X"),
    function("tg.fn.y.g0", "g0 of ramp Y"),
    function("tg.fn.y.g1", "g1 of ramp Y"),
    function("tg.fn.y.g2", "g2 of ramp Y"),
    function("tg.fn.cy.g0", "g0 of 1 - Y"),
    function("tg.fn.cy.g1", "g1 of 1 - Y"),
    function("tg.fn.cy.g2", "g2 of 1 - Y"),
    share("tg.yellow.height", "what the yellow words add to the height"),
    share("tg.green.height", "what the green words add to the height"),
    share("tg.black.height", "what the black words add to the height"),
    share("tg.red.height", "what the red words add to the height"),
];

const fn function(name: &'static str, meaning: &'static str) -> Signal {
    Signal::ground(name, Unit::Number, meaning, "fig. 19")
}

const fn share(name: &'static str, meaning: &'static str) -> Signal {
    Signal::ground(name, Unit::Metre, meaning, "fig. 19")
}

/// Profiles of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Profile<S> {
    /// Height above the eye (m).
    pub height: Vec<Lanes<S>>,
    /// Slope along the sweep.
    pub along: Vec<Lanes<S>>,
    /// Slope across the sweep, positive to the right.
    pub across: Vec<Lanes<S>>,
    /// Reflectivity with its sign, -1..=1 under Lambert's law (see [`SweepLight::at`] for others): below 0 the face is
    /// turned from the sun. What is drawn is 0 there; the sign tells where between two samples local shadow begins.
    pub reflectivity: Vec<Lanes<S>>,
}

impl<S: Real> Profile<S> {
    pub(crate) fn resize(&mut self, samples: usize) {
        for signal in [&mut self.height, &mut self.along, &mut self.across, &mut self.reflectivity] {
            signal.resize(samples, Lanes::default());
        }
    }

    /// Height and the slopes along and across at one sample.
    pub(crate) fn ground(&self, sample: usize) -> [Lanes<S>; 3] {
        [self.height[sample], self.along[sample], self.across[sample]]
    }
}

/// What the block is set to for one frame.
#[derive(Debug, Clone, Copy)]
pub struct TerrainGenerator<'a> {
    /// Storage buffer: corner words that the programs' indices mean.
    pub buffer: &'a [CornerWords],
    /// Region size, d (m).
    pub region_size: f64,
    /// Ground range of each sample (m).
    pub ranges: &'a [f64],
    /// Height that the summer subtracts: the eye's (m).
    pub datum: f64,
}

/// Polynomials of a group over its present segments; lane n belongs to sweep n.
struct Segments<S> {
    height: [Lanes<S>; 11],
    along: [Lanes<S>; 10],
    across: [Lanes<S>; 10],
    middle: Lanes<S>,
    inverse_half: Lanes<S>,
}

/// How heights and slopes are worked out.
pub trait Method<S: Real> {
    /// Height and slopes at the samples of `span`; nothing else of `profile` is touched.
    fn trace(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        profile: &mut Profile<S>,
    );
}

/// Ideal parts: the array's polynomial along the sweep, expanded from the words in the hold registers.
#[derive(Debug, Clone, Copy)]
pub struct Polynomials;

impl<S: Real> Method<S> for Polynomials {
    fn trace(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        profile: &mut Profile<S>,
    ) {
        generator.trace(programs, span, profile);
    }
}

/// One sweep on its way.
struct Lane<'p> {
    program: &'p SweepProgram,
    registers: Registers,
    next_step: usize,
    /// First sample that the present segment does not cover.
    until: usize,
    /// First sample beyond the end of the profile.
    last: usize,
}

impl TerrainGenerator<'_> {
    /// Runs the programs of a group side by side into `profile`.
    pub fn run<S: Real>(
        &self,
        programs: &[SweepProgram; LANES],
        light: &[SweepLight; LANES],
        profile: &mut Profile<S>,
    ) {
        self.trace_by(&mut Polynomials, programs, profile);
        self.reflect(&GroupLight::new(light), profile);
    }

    /// Height and slopes alone, by a method.
    pub fn trace_by<S: Real>(
        &self,
        method: &mut impl Method<S>,
        programs: &[SweepProgram; LANES],
        profile: &mut Profile<S>,
    ) {
        let samples = self.ranges.len();
        profile.resize(samples);
        method.trace(self, programs, 0..samples, profile);
    }

    /// Height and slopes at the samples of `span`; nothing else of `profile` is touched.
    pub(crate) fn trace<S: Real>(
        &self,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        profile: &mut Profile<S>,
    ) {
        let (mut segments, mut regions) = (Segments::default(), RecentRegions::default());
        let mut lanes = programs.each_ref().map(|program| Lane {
            program,
            registers: Registers::at_start(program),
            next_step: 0,
            until: span.start,
            last: self.ranges.partition_point(|&range| range <= program.end_range),
        });
        let mut sample = span.start;
        while sample < span.end {
            for (number, lane) in lanes.iter_mut().enumerate() {
                if lane.until <= sample {
                    self.next_segment(lane, number, sample, &mut regions, &mut segments);
                }
            }
            let until = lanes.iter().map(|lane| lane.until).min().unwrap_or(span.end).min(span.end);
            segments.evaluate(&self.ranges[sample..until], sample, profile);
            sample = until;
        }
    }

    /// Reflectivity from the slopes along and across (section 7), and from the line of sight if the law asks for it.
    pub fn reflect<S: Real>(&self, light: &GroupLight<S>, profile: &mut Profile<S>) {
        let slopes = profile.along.iter().zip(&profile.across);
        let signals = profile.reflectivity.iter_mut().zip(slopes);
        if !light.needs_sight() {
            for (reflectivity, (&along, &across)) in signals {
                *reflectivity = light.lambert(along, across);
            }
            return;
        }
        for ((reflectivity, (&along, &across)), (&height, &range)) in
            signals.zip(profile.height.iter().zip(self.ranges))
        {
            let sight = height * Lanes::splat(S::from_f64(1.0 / range));
            *reflectivity = light.reflectivity(along, across, sight);
        }
    }

    /// Applies the steps due at `sample` and sets the lane to the stretch that begins there.
    fn next_segment<S: Real>(
        &self,
        lane: &mut Lane<'_>,
        number: usize,
        sample: usize,
        regions: &mut RecentRegions,
        out: &mut Segments<S>,
    ) {
        let begin = self.apply_due(lane, sample);
        if sample >= lane.last {
            lane.until = self.ranges.len();
            return out.drop_out_of_sight(number);
        }
        let end = self.end_of_stretch(lane, sample);
        let mut stretch = match &self.ranges[sample..lane.until] {
            [only] => Stretch::of_one(self.at(lane, *only), *only),
            [first, last] => Stretch::of_two([first, last].map(|range| (*range, self.at(lane, *range)))),
            _ => self.expand(lane, begin, end, regions),
        };
        stretch.segment.height[0] -= self.datum;
        out.set(number, &stretch);
    }

    /// Range at which the present stretch begins, after all steps up to `sample` are done.
    fn apply_due(&self, lane: &mut Lane<'_>, sample: usize) -> f64 {
        let mut begin = self.ranges[sample.saturating_sub(1)];
        while let Some(step) = lane.program.steps.get(lane.next_step) {
            if step.sample > sample {
                break;
            }
            lane.registers.apply(step, self.buffer);
            if changes_hold(step) {
                begin = begin.max(step.range);
            }
            lane.next_step += 1;
        }
        begin
    }

    /// Sets the first sample that the stretch does not cover; the range at which it ends.
    fn end_of_stretch(&self, lane: &mut Lane<'_>, sample: usize) -> f64 {
        let ahead = &lane.program.steps[lane.next_step..];
        let next = ahead.iter().find(|step| changes_hold(step));
        lane.until = next.map_or(lane.last, |step| step.sample.min(lane.last)).max(sample + 1);
        next.map_or(lane.program.end_range, |step| step.range).min(self.ranges[self.ranges.len() - 1])
    }

    fn expand(&self, lane: &Lane<'_>, begin: f64, end: f64, regions: &mut RecentRegions) -> Stretch {
        let (middle, half_length) = (0.5 * (begin + end), 0.5 * (end - begin));
        let (registers, [cos, sin]) = (&lane.registers, lane.program.start.direction);
        let polarity = registers.polarity();
        let [(x, x_rate), (y, y_rate)] = self.ramps(lane, middle);
        let span = Span {
            middle: [x, y],
            half: [x_rate, y_rate].map(|rate| rate * half_length / self.region_size),
            half_length,
            across: [-sin * polarity[0] / self.region_size, cos * polarity[1] / self.region_size],
        };
        let region = regions.of(registers, self.buffer);
        Stretch { segment: Segment::expand(region, &span), middle, half_length }
    }

    /// Height and the slopes along and across at one range, straight through the array.
    fn at(&self, lane: &Lane<'_>, range: f64) -> [f64; 3] {
        let (registers, [cos, sin]) = (&lane.registers, lane.program.start.direction);
        let [(x, _), (y, _)] = self.ramps(lane, range);
        let [height, hu, hv] = array(registers.hold(self.buffer), registers.polarity(), [x, y]);
        [height, (hu * cos + hv * sin) / self.region_size, (hv * cos - hu * sin) / self.region_size]
    }

    /// Values and rates of both ramps.
    fn ramps(&self, lane: &Lane<'_>, range: f64) -> [(f64, f64); 2] {
        let (start, folds) = (&lane.program.start, lane.registers.folds());
        std::array::from_fn(|axis| start.ramps[axis].at(folds[axis], range / self.region_size))
    }
}

/// Polynomials in `s = (range - middle) / half_length`.
struct Stretch {
    segment: Segment,
    middle: f64,
    half_length: f64,
}

impl Stretch {
    /// Constants through one sample. Far ground has a region a sample: its 36 terms are cheaper once than
    /// expanded (fixed rule: the same for any run).
    fn of_one([height, along, across]: [f64; 3], range: f64) -> Self {
        let mut segment = Segment::ZERO;
        (segment.height[0], segment.along[0], segment.across[0]) = (height, along, across);
        Self { segment, middle: range, half_length: 1.0 }
    }

    /// Straight lines through two samples, at s = -1 and 1.
    fn of_two([(near, first), (far, last)]: [(f64, [f64; 3]); 2]) -> Self {
        let line =
            |signal: usize| [0.5 * (first[signal] + last[signal]), 0.5 * (last[signal] - first[signal])];
        let mut segment = Segment::ZERO;
        segment.height[..2].copy_from_slice(&line(0));
        segment.along[..2].copy_from_slice(&line(1));
        segment.across[..2].copy_from_slice(&line(2));
        Self { segment, middle: 0.5 * (near + far), half_length: 0.5 * (far - near) }
    }
}

/// Whether the words that feed the D/As are others after this step.
fn changes_hold(step: &Step) -> bool {
    match step.kind {
        StepKind::Fold(_) | StepKind::BareFold(_) => true,
        StepKind::Load(Load { target, .. }) => target == Target::Hold,
    }
}

impl<S: Real> Segments<S> {
    fn set(&mut self, lane: usize, stretch: &Stretch) {
        set_lane(&mut self.height, &stretch.segment.height, lane);
        set_lane(&mut self.along, &stretch.segment.along, lane);
        set_lane(&mut self.across, &stretch.segment.across, lane);
        self.middle[lane] = S::from_f64(stretch.middle);
        self.inverse_half[lane] = S::from_f64(1.0 / stretch.half_length);
    }

    fn drop_out_of_sight(&mut self, lane: usize) {
        self.set(lane, &Stretch::of_one([OUT_OF_SIGHT, 0.0, 0.0], 0.0));
    }

    fn evaluate(&self, ranges: &[f64], first: usize, profile: &mut Profile<S>) {
        let outputs = profile.height[first..]
            .iter_mut()
            .zip(&mut profile.along[first..])
            .zip(&mut profile.across[first..]);
        for (&range, ((height, along), across)) in ranges.iter().zip(outputs) {
            let s = (Lanes::splat(S::from_f64(range)) - self.middle) * self.inverse_half;
            *height = horner(&self.height, s);
            *along = horner(&self.along, s);
            *across = horner(&self.across, s);
        }
    }
}

impl<S: Real> Default for Segments<S> {
    fn default() -> Self {
        let zero = Lanes::default();
        Self { height: [zero; 11], along: [zero; 10], across: [zero; 10], middle: zero, inverse_half: zero }
    }
}

fn set_lane<S: Real, const N: usize>(lanes: &mut [Lanes<S>; N], coefficients: &[f64; N], lane: usize) {
    for (lanes, &coefficient) in lanes.iter_mut().zip(coefficients) {
        lanes[lane] = S::from_f64(coefficient);
    }
}

#[inline(always)]
fn horner<S: Real, const N: usize>(coefficients: &[Lanes<S>; N], s: Lanes<S>) -> Lanes<S> {
    let mut sum = coefficients[N - 1];
    for k in (0..N - 1).rev() {
        sum = sum * s + coefficients[k];
    }
    sum
}
