//! The array from the ramps to the three sums.

use std::ops::Range;

use hardware_model::{AnalogParts, FEEDTHROUGH_FREQUENCY, FoldDetect};
use landscape::{CornerWords, Level};
use parts::{
    Feedthrough, LagStep, Multiplier, MultiplierLaw, MultiplyingConverter, NoiseSource, Spread, Tolerance,
    impulse, relative_sigma, time_constant,
};
use signal::{LANES, Lanes, Real};
use sweep_program::{RampAxis, Step, StepKind, SweepProgram};

use crate::array::array;
use crate::generator::{OUT_OF_SIGHT, Profile};
use crate::wired::basis::{AxisGenerators, AxisState, UNITS};
use crate::wired::ramp::{RampParts, RampState};
use crate::wired::scale::{PEAKS, SLOPE_PEAKS, Scale};
use crate::wired::summer::{Summer, SummerState};
use crate::{Registers, TerrainGenerator};

/// Terms of one sum.
const TERMS: usize = 36;
/// Terms of all three: height, slope to the north, slope to the east.
const ALL: usize = 3 * TERMS;

/// The array, its parts drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsArray<S> {
    /// Length of a sample (s).
    step: f64,
    scale: Scale,
    ramps: RampParts<S>,
    generators: [AxisGenerators<S>; 2],
    multipliers: Vec<Multiplier<S>>,
    multiplier_lags: Vec<LagStep<S>>,
    /// What leaks of the first input past each multiplier, and of the signal past each D/A; empty without.
    multiplier_leaks: Vec<Feedthrough<S>>,
    converter_leaks: Vec<Feedthrough<S>>,
    words: Option<MultiplyingConverter>,
    /// Gains of the multiplying D/As.
    gains: Vec<f64>,
    converter_lags: Vec<LagStep<S>>,
    /// Time constants of the multiplying D/As (s), for steps that a new word divides; empty without lags.
    converter_taus: Vec<f64>,
    /// Area of the pulse at the major carry of a word (full scale times seconds).
    glitch: f64,
    summers: [Summer<S>; 3],
    noise: [NoiseSource; 3],
    sigma: f64,
    /// By how much the ramps run ahead of the beam (s).
    lead: f64,
    /// From a fold in the accumulator to the polarity and to the registers (s).
    to_polarity: f64,
    to_registers: f64,
}

/// Wires of a group of sweeps; used again from group to group.
#[derive(Debug, Clone)]
pub struct ArrayState<S> {
    ramps: [RampState<S>; 2],
    axes: [AxisState<S>; 2],
    /// Products without their lags, now and a sample ago.
    raw: [Vec<Lanes<S>>; 2],
    /// Products, now and a sample ago.
    products: [Vec<Lanes<S>>; 2],
    /// Factors a sample ago, with their signs: X, Y.
    factors: [[Lanes<S>; UNITS]; 2],
    terms: Vec<Lanes<S>>,
    /// Terms with what leaks past the D/As.
    leaky: Vec<Lanes<S>>,
    summers: [SummerState<S>; 3],
    sums: [Lanes<S>; 3],
    /// What the datum of each sweep is trimmed by (m).
    trim: [f64; LANES],
    /// What each multiplying D/A multiplies by.
    weights: Vec<Lanes<S>>,
    divided: Vec<Divided>,
    lanes: Vec<Lane>,
}

/// The digital side of one sweep of the group.
#[derive(Debug, Clone)]
struct Lane {
    registers: Registers,
    /// Next step of the program for the accumulators, the polarity and the registers.
    folded: usize,
    turned: usize,
    strobed: usize,
    folds: [u32; 2],
    polarity: [f64; 2],
}

/// A multiplying D/A whose word changes within a sample: its output at `share` of it.
#[derive(Debug, Clone, Copy)]
struct Divided {
    lane: usize,
    index: usize,
    share: f64,
    output: f64,
}

impl<S: Real> Default for ArrayState<S> {
    fn default() -> Self {
        Self {
            ramps: Default::default(),
            axes: Default::default(),
            raw: Default::default(),
            products: Default::default(),
            factors: [[Lanes::default(); UNITS]; 2],
            terms: Vec::new(),
            leaky: Vec::new(),
            summers: Default::default(),
            sums: [Lanes::default(); 3],
            trim: [0.0; LANES],
            weights: Vec::new(),
            divided: Vec::new(),
            lanes: Vec::new(),
        }
    }
}

/// The factors of term `term` (`6 ap + bq`) of sum `sum`: unit of each axis ([`AxisGenerators`]).
fn factors(sum: usize, term: usize) -> [usize; 2] {
    let (ap, bq) = (term / 6, term % 6);
    [ap + if sum == 1 { 6 } else { 0 }, bq + if sum == 2 { 6 } else { 0 }]
}

/// Colour and word of a term.
fn word_of(term: usize) -> [usize; 2] {
    let (ap, bq) = (term / 6, term % 6);
    [ap / 3 + 2 * (bq / 3), 3 * (ap % 3) + bq % 3]
}

impl<S: Real> PartsArray<S> {
    /// The array called `name` (each level has its own) for steps of `h` seconds over `level`.
    pub fn new(h: f64, level: &Level, parts: &AnalogParts, seed: u64, name: &str) -> Self {
        let spread = Spread::new(seed);
        let draw = |figure: &str, index: usize, nominal: f64, sigma: f64| {
            let sigma = if parts.spread { sigma } else { 0.0 };
            spread.figure(&format!("{name}.{figure}"), index as u64, &Tolerance { nominal, sigma })
        };
        let error = |figure: &str, index: usize, sigma: f64| {
            spread.error(&format!("{name}.{figure}"), index as u64, sigma)
        };
        let tau = |figure: &str, index: usize, bandwidth: f64| {
            time_constant(draw(figure, index, bandwidth, relative_sigma::BANDWIDTH))
        };
        let lags = |figure: &str, bandwidth: Option<f64>| -> Vec<f64> {
            bandwidth.map_or(Vec::new(), |b| (0..ALL).map(|index| tau(figure, index, b)).collect())
        };
        let multiplier = |index: usize| {
            let sigma = parts.multiplier.error;
            Multiplier::new(&MultiplierLaw {
                gain: error("mul.eg", index, parts.multiplier.scale_error),
                feed_a: error("mul.ex", index, 0.5 * sigma),
                feed_b: error("mul.ey", index, 0.5 * sigma),
                offset: error("mul.eo", index, 0.5 * sigma),
                nonlinearity: error("mul.en", index, 0.5 * sigma),
            })
        };
        let leaks = |figure: &str, share: f64| -> Vec<Feedthrough<S>> {
            let leak = |index| Feedthrough::new(h, error(figure, index, share), FEEDTHROUGH_FREQUENCY);
            if share > 0.0 { (0..ALL).map(leak).collect() } else { Vec::new() }
        };
        let converter_taus = lags("mdac.bandwidth", parts.multiplying_dac.bandwidth);
        let steps = |taus: &[f64]| taus.iter().map(|&tau| LagStep::new(h, tau)).collect();
        let ramps = RampParts::new(h, parts.full_scale, &parts.sweep);
        let summers = ["height", "slope-u", "slope-v"]
            .map(|sum| Summer::new(h, TERMS, parts, &spread, &format!("{name}.{sum}")));
        let nominal = |bandwidth: Option<f64>| bandwidth.map_or(0.0, time_constant);
        let to_generators = ramps.delay() + nominal(parts.function_generator.bandwidth);
        let to_converters = to_generators + nominal(parts.multiplier.bandwidth);
        let lead = to_converters + nominal(parts.multiplying_dac.bandwidth) + summers[0].delay();
        let (to_polarity, to_registers) = match parts.sweep.fold_detect {
            // Strobes are trimmed for the time that words take to act, as far as they can come earlier.
            FoldDetect::Digital => (to_generators, to_converters.max(parts.multiplying_dac.switching)),
            FoldDetect::Comparator => {
                let found = ramps.delay() + parts.comparator.delay;
                (found, found + parts.multiplying_dac.switching)
            }
        };
        Self {
            step: h,
            scale: Scale::of(level),
            generators: [0, 1].map(|axis| AxisGenerators::new(h, parts, &spread, name, axis)),
            multipliers: (0..ALL).map(multiplier).collect(),
            multiplier_lags: steps(&lags("mul.bandwidth", parts.multiplier.bandwidth)),
            multiplier_leaks: leaks("mul.feedthrough", parts.multiplier.feedthrough),
            converter_leaks: leaks("mdac.feedthrough", parts.multiplying_dac.feedthrough),
            words: parts.multiplying_dac.bits.map(|bits| MultiplyingConverter::new(h, bits, 1.0, 0.0, 0.0)),
            gains: (0..ALL)
                .map(|index| 1.0 + error("mdac.gain", index, parts.multiplying_dac.gain_error))
                .collect(),
            converter_lags: steps(&converter_taus),
            converter_taus,
            glitch: parts.multiplying_dac.glitch / parts.full_scale,
            summers,
            noise: [0, 1, 2].map(|sum| NoiseSource::new(seed, &format!("{name}.noise"), sum)),
            sigma: parts.amplifier.noise / parts.full_scale,
            lead,
            to_polarity: to_polarity + parts.sweep.strobe_offset,
            to_registers: to_registers + parts.sweep.strobe_offset,
            ramps,
        }
    }

    /// Runs a group of sweeps; the samples of `span` go into `profile`. `address` numbers the first sweep over all
    /// frames, for the noise.
    pub(crate) fn trace(
        &self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        address: u64,
        state: &mut ArrayState<S>,
        profile: &mut Profile<S>,
        tap: &mut impl Tap<S>,
    ) {
        let run = Run { array: self, generator, programs };
        // The accumulators leave the eye's foot a sample before the first, and the beam is behind them.
        let first = -(1.0 + self.lead / self.step).ceil() as i64;
        run.settle(first, state);
        for sample in first..span.end as i64 {
            if sample > first {
                run.advance(sample, state);
            }
            if sample >= span.start as i64 {
                run.put(sample as usize, address, state, profile);
                tap.see(self, state);
            }
        }
        run.end_profiles(span, profile);
    }

    /// Output of a function generator of values: ramp or complement of an axis (`2 axis + end`), order `p`.
    pub(crate) fn function(&self, state: &ArrayState<S>, lane: usize, fed: usize, p: usize) -> f64 {
        state.axes[fed / 2].out[3 * (fed % 2) + p][lane].to_f64() * PEAKS[p]
    }

    /// What the multiplying D/As of a colour send to the sum of the height (m).
    pub(crate) fn share(&self, state: &ArrayState<S>, lane: usize, colour: usize) -> f64 {
        let terms = (0..TERMS).filter(|&term| word_of(term)[0] == colour);
        terms.map(|term| state.terms[term][lane].to_f64()).sum::<f64>() * self.scale.height
    }

    /// How much later than its program time, in samples, something acts on the wires, `delay` seconds down the chain.
    fn shift(&self, delay: f64) -> f64 {
        (self.lead - delay) / self.step
    }

    /// What D/A `index` multiplies by for these words.
    fn weight(&self, words: &CornerWords, index: usize) -> f64 {
        let (sum, [_, word]) = (index / TERMS, word_of(index % TERMS));
        let share = self.scale.share(words, word);
        let share = self.words.as_ref().map_or(share, |converter| converter.quantised(share));
        let (p, q) = (word / 3, word % 3);
        let to_slope = self.scale.height / self.scale.slope;
        self.gains[index]
            * match sum {
                0 => share,
                1 => share * to_slope * SLOPE_PEAKS[p] / PEAKS[p],
                _ => share * to_slope * SLOPE_PEAKS[q] / PEAKS[q],
            }
    }
}

/// Whoever looks inside the array, sample by sample; `()` is nobody.
pub(crate) trait Tap<S> {
    /// The wires at the next sample.
    fn see(&mut self, array: &PartsArray<S>, state: &ArrayState<S>);
}

impl<S> Tap<S> for () {
    fn see(&mut self, _: &PartsArray<S>, _: &ArrayState<S>) {}
}

/// One group on its way through the array.
#[derive(Clone, Copy)]
struct Run<'a, S> {
    array: &'a PartsArray<S>,
    generator: &'a TerrainGenerator<'a>,
    programs: &'a [SweepProgram; LANES],
}

impl<S: Real> Run<'_, S> {
    /// Everything at rest under ramps that stand as they do at sample `first`.
    fn settle(&self, first: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        state.lanes.clear();
        let lanes = self.programs.iter().map(|program| Lane::at_start(program, self.generator.buffer));
        state.lanes.extend(lanes);
        state.weights.clear();
        let weight = |lane: &Lane, index: usize| {
            array.weight(&lane.registers.hold()[word_of(index % TERMS)[0]], index)
        };
        let weights =
            (0..ALL).map(|index| Lanes::from_fn(|lane| S::from_f64(weight(&state.lanes[lane], index))));
        state.weights.extend(weights);
        let ramps = self.accumulators(first, state);
        for axis in 0..2 {
            state.ramps[axis] = array.ramps.at_rest(ramps[axis]);
            state.axes[axis] = array.generators[axis].at_rest(state.ramps[axis].output());
        }
        state.factors = self.factors(state);
        self.multiply(state);
        let [raw, before] = &mut state.raw;
        before.clone_from(raw);
        state.products.clone_from(&state.raw);
        state.terms.clear();
        state.terms.extend((0..ALL).map(|index| state.products[0][index] * state.weights[index]));
        for (sum, summer) in array.summers.iter().enumerate() {
            state.sums[sum] = summer.at_rest(&state.terms[sum * TERMS..][..TERMS], &mut state.summers[sum]);
        }
        self.trim(state);
    }

    /// The datum is set in retrace so that the height at the eye's foot is right: offsets are common to all of a sweep.
    fn trim(&self, state: &mut ArrayState<S>) {
        let Scale { datum, height, .. } = self.array.scale;
        for (lane, program) in self.programs.iter().enumerate() {
            let digital = &state.lanes[lane].registers;
            let foot = program.start.ramps.map(|ramp| ramp.start);
            let [right, ..] = array(digital.hold(), digital.polarity(), foot);
            state.trim[lane] = right - (state.sums[0][lane].to_f64() * height + datum);
        }
    }

    /// From the sample before to `sample`.
    fn advance(&self, sample: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        let ramps = self.accumulators(sample - i64::from(array.ramps.has_steps()), state);
        for axis in 0..2 {
            let ramp = array.ramps.step(&mut state.ramps[axis], ramps[axis]);
            array.generators[axis].step(&mut state.axes[axis], ramp);
        }
        let turned = sample as f64 + array.shift(array.to_polarity);
        for (lane, program) in state.lanes.iter_mut().zip(self.programs) {
            lane.turn_until(program, turned);
        }
        state.raw.swap(0, 1);
        self.multiply(state);
        state.products.swap(0, 1);
        let [now, before] = &mut state.products;
        if array.multiplier_lags.is_empty() {
            now.clone_from(&state.raw[0]);
        }
        for (index, lag) in array.multiplier_lags.iter().enumerate() {
            now[index] = lag.step(before[index], state.raw[1][index], state.raw[0][index]);
        }
        self.convert(sample, state);
        self.leak(state);
        let terms = if array.converter_leaks.is_empty() { &state.terms } else { &state.leaky };
        for (sum, summer) in array.summers.iter().enumerate() {
            state.sums[sum] = summer.step(&terms[sum * TERMS..][..TERMS], &mut state.summers[sum]);
        }
    }

    /// Ramps in the accumulators as the beam is at `sample`.
    fn accumulators(&self, sample: i64, state: &mut ArrayState<S>) -> [Lanes<S>; 2] {
        let range = range_at(self.generator.ranges, sample as f64 + self.array.lead / self.array.step);
        let mut out = [Lanes::default(); 2];
        for (number, (lane, program)) in state.lanes.iter_mut().zip(self.programs).enumerate() {
            lane.fold_until(program, range);
            for axis in 0..2 {
                let ramp = &program.start.ramps[axis];
                let (value, _) = ramp.at(lane.folds[axis], range / self.generator.region_size);
                out[axis][number] = S::from_f64(value);
            }
        }
        out
    }

    /// What the function generators put out, with their signs.
    fn factors(&self, state: &ArrayState<S>) -> [[Lanes<S>; UNITS]; 2] {
        std::array::from_fn(|axis| {
            let sign = Lanes::from_fn(|lane| S::from_f64(state.lanes[lane].polarity[axis]));
            signed(&state.axes[axis].out, sign)
        })
    }

    /// All products, without their lags, into `state.raw[0]`.
    fn multiply(&self, state: &mut ArrayState<S>) {
        let [x, y] = self.factors(state);
        let before = std::mem::replace(&mut state.factors, [x, y]);
        let raw = &mut state.raw[0];
        raw.clear();
        raw.extend((0..ALL).map(|index| {
            let [a, b] = factors(index / TERMS, index % TERMS);
            self.array.multipliers[index].product(x[a], y[b])
        }));
        for (index, leak) in self.array.multiplier_leaks.iter().enumerate() {
            let [a, _] = factors(index / TERMS, index % TERMS);
            raw[index] = raw[index] + leak.leak(before[0][a], x[a]);
        }
    }

    /// Past the multiplying D/As, whatever their words.
    fn leak(&self, state: &mut ArrayState<S>) {
        let [now, before] = &state.products;
        let leaks = self.array.converter_leaks.iter().zip(before.iter().zip(now));
        let leaky = state.terms.iter().zip(leaks);
        state.leaky.clear();
        state.leaky.extend(leaky.map(|(&term, (leak, (&before, &now)))| term + leak.leak(before, now)));
    }

    /// Registers up to `sample`, and the outputs of the multiplying D/As then.
    fn convert(&self, sample: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        state.divided.clear();
        for lane in 0..LANES {
            self.strobe(sample, lane, state);
        }
        let [now, before] = &state.products;
        if array.converter_lags.is_empty() {
            for (index, term) in state.terms.iter_mut().enumerate() {
                *term = now[index] * state.weights[index];
            }
            return;
        }
        for (index, lag) in array.converter_lags.iter().enumerate() {
            let weight = state.weights[index];
            state.terms[index] = lag.step(state.terms[index], before[index] * weight, now[index] * weight);
        }
        for &Divided { lane, index, share, output } in &state.divided {
            let weight = state.weights[index][lane].to_f64();
            let [start, end] = [share, 1.0].map(|share| self.product_at(state, lane, index, share) * weight);
            let lag = LagStep::<f64>::new(array.step * (1.0 - share), array.converter_taus[index]);
            state.terms[index][lane] = S::from_f64(lag.step(output, start, end));
        }
    }

    fn product_at(&self, state: &ArrayState<S>, lane: usize, index: usize, share: f64) -> f64 {
        let [now, before] = state.products.each_ref().map(|products| products[index][lane].to_f64());
        before + share * (now - before)
    }

    /// Folds and words of a lane up to `sample`.
    fn strobe(&self, sample: i64, lane: usize, state: &mut ArrayState<S>) {
        let shift = self.array.shift(self.array.to_registers);
        while let Some(step) = self.programs[lane].steps.get(state.lanes[lane].strobed) {
            let at = step.time.0 - shift;
            if at > sample as f64 {
                break;
            }
            let old = *state.lanes[lane].registers.hold();
            state.lanes[lane].strobe(step, self.generator.buffer);
            let share = (at - (sample - 1) as f64).clamp(0.0, 1.0);
            for index in 0..ALL {
                let [colour, word] = word_of(index % TERMS);
                let new = &state.lanes[lane].registers.hold()[colour];
                if new[word] != old[colour][word] {
                    let (new, old) = (*new, old[colour]);
                    self.change_word(lane, index, share, [&old, &new], state);
                }
            }
        }
    }

    fn change_word(
        &self,
        lane: usize,
        index: usize,
        share: f64,
        [old, new]: [&CornerWords; 2],
        state: &mut ArrayState<S>,
    ) {
        let array = self.array;
        if let Some(&tau) = array.converter_taus.get(index) {
            let known =
                state.divided.iter().position(|divided| (divided.lane, divided.index) == (lane, index));
            let (from, output) = known.map_or((0.0, state.terms[index][lane].to_f64()), |known| {
                let divided = state.divided[known];
                (divided.share, divided.output)
            });
            let weight = state.weights[index][lane].to_f64();
            let [start, end] = [from, share].map(|share| self.product_at(state, lane, index, share));
            let lag = LagStep::<f64>::new(array.step * (share - from), tau);
            let pulse = self.pulse(index, tau, end, [old, new]);
            let output = lag.step(output, start * weight, end * weight) + pulse;
            let divided = Divided { lane, index, share, output };
            match known {
                Some(known) => state.divided[known] = divided,
                None => state.divided.push(divided),
            }
        }
        state.weights[index][lane] = S::from_f64(array.weight(new, index));
    }

    /// What the bits that switch apart add to the output of a D/A.
    fn pulse(&self, index: usize, tau: f64, product: f64, [old, new]: [&CornerWords; 2]) -> f64 {
        let Some(converter) = self.array.words.as_ref().filter(|_| self.array.glitch > 0.0) else {
            return 0.0;
        };
        let [_, word] = word_of(index % TERMS);
        let [old, new] = [old, new].map(|words| converter.word(self.array.scale.share(words, word)));
        self.array.glitch * converter.carry(old, new) * product * impulse(self.array.step, tau, 1.0)
    }

    /// Height and slopes at one sample.
    fn put(&self, sample: usize, address: u64, state: &ArrayState<S>, profile: &mut Profile<S>) {
        let Scale { datum, height, slope } = self.array.scale;
        let noise = |sum: usize, lane: usize| match self.array.sigma {
            0.0 => 0.0,
            sigma => sigma * self.array.noise[sum].normal(address + lane as u64, sample as u64),
        };
        for (lane, program) in self.programs.iter().enumerate() {
            let value = |sum: usize| state.sums[sum][lane].to_f64() + noise(sum, lane);
            let [hu, hv] = [1, 2].map(|sum| value(sum) * slope / self.generator.region_size);
            let [cos, sin] = program.start.direction;
            profile.height[sample][lane] =
                S::from_f64(value(0) * height + datum + state.trim[lane] - self.generator.datum);
            profile.along[sample][lane] = S::from_f64(hu * cos + hv * sin);
            profile.across[sample][lane] = S::from_f64(hv * cos - hu * sin);
        }
    }

    fn end_profiles(&self, span: Range<usize>, profile: &mut Profile<S>) {
        for (lane, program) in self.programs.iter().enumerate() {
            let last = self.generator.ranges.partition_point(|&range| range <= program.end_range);
            for sample in last.clamp(span.start, span.end)..span.end {
                profile.height[sample][lane] = S::from_f64(OUT_OF_SIGHT);
                profile.along[sample][lane] = S::ZERO;
                profile.across[sample][lane] = S::ZERO;
            }
        }
    }
}

impl Lane {
    fn at_start(program: &SweepProgram, buffer: &[CornerWords]) -> Self {
        let registers = Registers::at_start(program, buffer);
        let polarity = registers.polarity();
        Self { registers, folded: 0, turned: 0, strobed: 0, folds: [0; 2], polarity }
    }

    /// Folds of the accumulators up to `range` (m).
    fn fold_until(&mut self, program: &SweepProgram, range: f64) {
        for step in program.steps[self.folded..].iter().take_while(|step| step.range <= range) {
            self.folded += 1;
            if let StepKind::Fold(fold) | StepKind::BareFold(fold) = step.kind {
                self.folds[usize::from(fold.axis == RampAxis::Y)] += 1;
            }
        }
    }

    /// Polarity up to program time `time`.
    fn turn_until(&mut self, program: &SweepProgram, time: f64) {
        for step in program.steps[self.turned..].iter().take_while(|step| step.time.0 <= time) {
            self.turned += 1;
            if let StepKind::Fold(fold) | StepKind::BareFold(fold) = step.kind {
                let axis = usize::from(fold.axis == RampAxis::Y);
                self.polarity[axis] = -self.polarity[axis];
            }
        }
    }

    fn strobe(&mut self, step: &Step, buffer: &[CornerWords]) {
        self.strobed += 1;
        self.registers.apply(step, buffer);
    }
}

/// Function generators with their signs (section 6.4): odd orders of value and even ones of slope carry the polarity
/// at the near end, and its opposite at the far one.
fn signed<S: Real>(out: &[Lanes<S>; UNITS], sign: Lanes<S>) -> [Lanes<S>; UNITS] {
    std::array::from_fn(|unit| {
        let (is_slope, is_far, order) = (unit / 6 == 1, unit / 3 % 2 == 1, unit % 3);
        if (order == 1) == is_slope {
            return out[unit];
        }
        let signed = out[unit] * sign;
        if is_far { Lanes::default() - signed } else { signed }
    })
}

/// Range at `time` (samples): from the eye's foot to the first sample, straight between samples, on at the last rate
/// beyond them.
fn range_at(ranges: &[f64], time: f64) -> f64 {
    if time <= 0.0 {
        return ranges[0] * (1.0 + time).max(0.0);
    }
    let before = (time as usize).min(ranges.len() - 2);
    ranges[before] + (ranges[before + 1] - ranges[before]) * (time - before as f64)
}
