//! A group of sweeps, from program to profiles.

use landscape::CornerWords;
use signal::{LANES, Lanes, Real, Signal, Unit};
use sweep_program::{Load, Step, StepKind, SweepProgram, Target};

use crate::{Registers, Segment, Span, SweepLight};

/// Height of a profile beyond its end (m): below everything, so nothing of it is seen. A power of two, so that
/// it is exact in f32.
pub const OUT_OF_SIGHT: f64 = -1_073_741_824.0;

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("tg.height", Unit::Metre, "terrain height above the lunoid's tangent plane (fig. 24)"),
    Signal::ground("tg.slope.u", Unit::Slope, "terrain slope to the north (section 7)"),
    Signal::ground("tg.slope.v", Unit::Slope, "terrain slope to the east (section 7)"),
    Signal::ground("tg.reflectivity", Unit::Reflectivity, "Lambert's factor of the terrain (fig. 24)"),
];

/// Profiles of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Profile<S> {
    /// Height above the eye (m).
    pub height: Vec<Lanes<S>>,
    /// Slope along the sweep.
    pub along: Vec<Lanes<S>>,
    /// Slope across the sweep, positive to the right.
    pub across: Vec<Lanes<S>>,
    /// Reflectivity, 0..=1.
    pub reflectivity: Vec<Lanes<S>>,
}

impl<S: Real> Profile<S> {
    fn resize(&mut self, samples: usize) {
        for signal in [&mut self.height, &mut self.along, &mut self.across, &mut self.reflectivity] {
            signal.resize(samples, Lanes::default());
        }
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
struct Polynomials<S> {
    height: [Lanes<S>; 11],
    along: [Lanes<S>; 10],
    across: [Lanes<S>; 10],
    middle: Lanes<S>,
    inverse_half: Lanes<S>,
}

/// One sweep on its way.
struct Lane<'p> {
    program: &'p SweepProgram,
    registers: Registers,
    next_step: usize,
    /// First sample that the present segment does not cover.
    until: usize,
}

impl TerrainGenerator<'_> {
    /// Runs the programs of a group side by side into `profile`.
    pub fn run<S: Real>(
        &self,
        programs: &[SweepProgram; LANES],
        light: &[SweepLight; LANES],
        profile: &mut Profile<S>,
    ) {
        let samples = self.ranges.len();
        profile.resize(samples);
        let mut polynomials = Polynomials::default();
        let mut lanes = programs.each_ref().map(|program| Lane {
            program,
            registers: Registers::at_start(program, self.buffer),
            next_step: 0,
            until: 0,
        });
        let mut sample = 0;
        while sample < samples {
            for (number, lane) in lanes.iter_mut().enumerate() {
                if lane.until <= sample {
                    self.next_segment(lane, number, sample, &mut polynomials);
                }
            }
            let until = lanes.iter().map(|lane| lane.until).min().unwrap_or(samples).min(samples);
            polynomials.evaluate(&self.ranges[sample..until], sample, profile);
            sample = until;
        }
        reflect(light, profile);
    }

    /// Applies the steps due at `sample` and expands the stretch that begins there.
    fn next_segment<S: Real>(
        &self,
        lane: &mut Lane<'_>,
        number: usize,
        sample: usize,
        out: &mut Polynomials<S>,
    ) {
        let program = lane.program;
        let begin = self.apply_due(lane, sample);
        if self.ranges[sample] > program.end_range {
            lane.until = self.ranges.len();
            return out.drop_out_of_sight(number);
        }
        let (until, end) = self.end_of_stretch(lane, sample);
        lane.until = until;
        let middle = 0.5 * (begin + end);
        let half_length = (0.5 * (end - begin)).max(1e-9);
        let span = self.span(&lane.registers, program, middle, half_length);
        let mut segment = Segment::expand(lane.registers.hold(), lane.registers.polarity(), &span);
        segment.height[0] -= self.datum;
        out.set(number, &segment, middle, half_length);
    }

    /// Range at which the present stretch begins, after all steps up to `sample` are done.
    fn apply_due(&self, lane: &mut Lane<'_>, sample: usize) -> f64 {
        let mut begin = if sample == 0 { self.ranges[0] } else { self.ranges[sample - 1] };
        while let Some(step) = lane.program.steps.get(lane.next_step) {
            if step.time.sample_at_or_after() > sample {
                break;
            }
            match &step.kind {
                StepKind::Fold(fold) => lane.registers.fold(*fold),
                StepKind::Load(load) => lane.registers.load(load, self.buffer),
            }
            if changes_hold(step) {
                begin = begin.max(step.range);
            }
            lane.next_step += 1;
        }
        begin
    }

    /// First sample that the stretch does not cover, and the range at which it ends.
    fn end_of_stretch(&self, lane: &Lane<'_>, sample: usize) -> (usize, f64) {
        let ahead = &lane.program.steps[lane.next_step..];
        let last = self.ranges.partition_point(|&range| range <= lane.program.end_range);
        match ahead.iter().find(|step| changes_hold(step)) {
            Some(step) => (step.time.sample_at_or_after().min(last).max(sample + 1), step.range),
            None => (last.max(sample + 1), lane.program.end_range.min(self.ranges[self.ranges.len() - 1])),
        }
    }

    fn span(&self, registers: &Registers, program: &SweepProgram, middle: f64, half_length: f64) -> Span {
        let polarity = registers.polarity();
        let [cos, sin] = program.start.direction;
        let ramps = std::array::from_fn(|axis| {
            program.start.ramps[axis].at(registers.folds()[axis], middle / self.region_size)
        });
        let [(x, x_rate), (y, y_rate)] = ramps;
        Span {
            middle: [x, y],
            half: [x_rate, y_rate].map(|rate| rate * half_length / self.region_size),
            half_length,
            across: [-sin * polarity[0] / self.region_size, cos * polarity[1] / self.region_size],
        }
    }
}

/// Whether the words that feed the D/As are others after this step.
fn changes_hold(step: &Step) -> bool {
    match step.kind {
        StepKind::Fold(_) => true,
        StepKind::Load(Load { target, .. }) => target == Target::Hold,
    }
}

impl<S: Real> Polynomials<S> {
    fn set(&mut self, lane: usize, segment: &Segment, middle: f64, half_length: f64) {
        set_lane(&mut self.height, &segment.height, lane);
        set_lane(&mut self.along, &segment.along, lane);
        set_lane(&mut self.across, &segment.across, lane);
        self.middle[lane] = S::from_f64(middle);
        self.inverse_half[lane] = S::from_f64(1.0 / half_length);
    }

    fn drop_out_of_sight(&mut self, lane: usize) {
        let mut nothing = Segment { height: [0.0; 11], along: [0.0; 10], across: [0.0; 10] };
        nothing.height[0] = OUT_OF_SIGHT;
        self.set(lane, &nothing, 0.0, f64::INFINITY);
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

impl<S: Real> Default for Polynomials<S> {
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

/// `max(n.s, 0)` from the slopes along and across (section 7).
fn reflect<S: Real>(light: &[SweepLight; LANES], profile: &mut Profile<S>) {
    let lanes = |part: fn(&SweepLight) -> f64| Lanes::from_fn(|lane| S::from_f64(part(&light[lane])));
    let (sun_along, sun_across, sun_up) = (lanes(|l| l.along), lanes(|l| l.across), lanes(|l| l.up));
    let (one, zero) = (Lanes::splat(S::ONE), Lanes::splat(S::ZERO));
    let slopes = profile.along.iter().zip(&profile.across);
    for (reflectivity, (&along, &across)) in profile.reflectivity.iter_mut().zip(slopes) {
        let towards = sun_up - along * sun_along - across * sun_across;
        let normal = (one + along * along + across * across).sqrt();
        *reflectivity = (towards / normal).at_least(zero);
    }
}
