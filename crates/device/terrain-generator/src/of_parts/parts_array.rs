//! The parts of an array, drawn once from the seed of the model.

use std::ops::Range;

use fearless_simd::dispatch;
use hardware_model::{AnalogParts, FEEDTHROUGH_FREQUENCY, SweepParts};
use landscape::{CornerWords, Level};
use parts::{
    Feedthrough, LagStep, Multiplier, MultiplierLaw, MultiplyingConverter, NoiseSource, Spread, Tolerance,
    relative_sigma, time_constant,
};
use signal::{LANES, Lanes, Real};
use sweep_program::SweepProgram;

use super::basis::AxisGenerators;
use super::block::BLOCK;
use super::cell::{Cell, CellParts};
use super::grid::Grid;
use super::ramp::RampParts;
use super::run::Run;
use super::scale::{PEAKS, SLOPE_PEAKS, Scale};
use super::state::ArrayState;
use super::summer::Summer;
use super::timing::{Delays, Timing, lag_of};
use super::words::Converters;
use crate::TerrainGenerator;
use crate::generator::Profile;
use crate::inner::InnerWire;
use crate::terms::{ALL, TERMS, word_of};

/// The array, its parts drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsArray<S> {
    pub(super) scale: Scale,
    pub(super) ramps: [RampParts<S>; 2],
    pub(super) generators: [AxisGenerators<S>; 2],
    pub(super) grid: Grid<S>,
    pub(super) words: Option<MultiplyingConverter>,
    /// What each multiplying D/A makes of a share of full scale: its gain, and the scale of its sum.
    pub(super) factors: Vec<f64>,
    /// The same with what else it makes of a word, colour by colour.
    pub(super) converters: Vec<Converters>,
    /// Area of the pulse at the major carry of a word (full scale times seconds).
    pub(super) glitch: f64,
    pub(super) summers: [Summer<S>; 3],
    pub(super) noise: [NoiseSource; 3],
    pub(super) sigma: f64,
    pub(super) timing: Timing,
    /// Samples after which no part remembers that it was at rest.
    pub(super) warm_up: i64,
    /// Vectors that the processor has.
    pub(super) vectors: fearless_simd::Level,
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
        let taus = |figure: &str, bandwidth: Option<f64>| -> Vec<f64> {
            (0..ALL).map(|index| bandwidth.map_or(0.0, |b| tau(figure, index, b))).collect()
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
        let leak = |figure: &str, index: usize, share: f64| {
            Feedthrough::new(h, error(figure, index, share), FEEDTHROUGH_FREQUENCY)
        };
        let multiplier_taus = taus("mul.bandwidth", parts.multiplier.bandwidth);
        let converter_taus = taus("mdac.bandwidth", parts.multiplying_dac.bandwidth);
        let cell = |index: usize| Cell {
            parts: CellParts {
                multiplier: multiplier(index),
                leak: leak("mul.feedthrough", index, parts.multiplier.feedthrough),
                lag: LagStep::new(h, multiplier_taus[index]),
                converter: LagStep::new(h, converter_taus[index]),
                past: leak("mdac.feedthrough", index, parts.multiplying_dac.feedthrough),
            },
            tau: converter_taus[index],
        };
        let nominal = RampParts::<S>::new(h, parts.full_scale, &parts.sweep);
        let ramps = [0, 1].map(|axis| {
            let settle = draw("ramp.settle", axis, parts.sweep.settle, relative_sigma::SETTLING);
            RampParts::new(h, parts.full_scale, &SweepParts { settle, ..parts.sweep })
        });
        let summers = ["height", "slope-u", "slope-v"]
            .map(|sum| Summer::new(h, parts, &spread, &format!("{name}.{sum}")));
        let to_generators = nominal.delay() + lag_of(parts.function_generator.bandwidth);
        let to_converters = to_generators + lag_of(parts.multiplier.bandwidth);
        let to_sums = to_converters + lag_of(parts.multiplying_dac.bandwidth) + summers[0].delay();
        let delays = Delays { to_ramps: nominal.delay(), to_generators, to_converters, to_sums };
        let timing = Timing::new(h, &delays, &ramps, parts, (&spread, name));
        let generators = AxisGenerators::of_both(h, parts, &spread, name);
        let scale = Scale::of(level);
        let factor = |index: usize| {
            let gain = 1.0 + error("mdac.gain", index, parts.multiplying_dac.gain_error);
            let (sum, [_, word]) = (index / TERMS, word_of(index % TERMS));
            let slope_of = |order: usize| scale.height / scale.slope * SLOPE_PEAKS[order] / PEAKS[order];
            gain * match sum {
                0 => 1.0,
                1 => slope_of(word / 3),
                _ => slope_of(word % 3),
            }
        };
        let act_together = timing.are_together() && parts.multiplying_dac.glitch == 0.0;
        let factors: Vec<f64> = (0..ALL).map(factor).collect();
        let largest = |taus: &[f64]| taus.iter().copied().fold(0.0, f64::max);
        let mut chain = vec![largest(&multiplier_taus), largest(&converter_taus)];
        for axis in 0..2 {
            chain.push(generators[axis].slowest());
            chain.extend(ramps[axis].slowest());
        }
        summers.iter().for_each(|summer| chain.extend(summer.slowest()));
        Self {
            scale,
            generators,
            grid: Grid::new((0..ALL).map(cell).collect(), summers[0].inputs(), act_together),
            words: parts.multiplying_dac.bits.map(|bits| MultiplyingConverter::new(h, bits, 1.0, 0.0, 0.0)),
            converters: Converters::of_all(|index| {
                [factors[index], timing.later(index), converter_taus[index]]
            }),
            factors,
            glitch: parts.multiplying_dac.glitch / parts.full_scale,
            summers,
            noise: [0, 1, 2].map(|sum| NoiseSource::new(seed, &format!("{name}.noise"), sum)),
            sigma: parts.amplifier.noise / parts.full_scale,
            warm_up: warm_up(h, &chain, parts),
            timing,
            ramps,
            vectors: fearless_simd::Level::new(),
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
        run.begin(state);
        dispatch!(self.vectors, simd => run.trace(simd, span.clone(), address, state, profile, tap));
        run.end_profiles(span, profile);
    }

    /// Ground range that the accumulators have as the beam is at `sample`, over samples at `ranges` (m).
    pub(crate) fn accumulated(&self, ranges: &[f64], sample: usize) -> f64 {
        self.timing.accumulated(ranges, sample as f64)
    }

    /// What a wire of a lane carries at a block's only sample, of an array over regions of side `region_size` (m); nothing of wires that are not parts of
    /// the array.
    pub(crate) fn wire(
        &self,
        wire: InnerWire,
        state: &ArrayState<S>,
        lane: usize,
        region_size: f64,
    ) -> Option<f64> {
        let full_scale = wire.full_scale(&self.scale, region_size)[1];
        let of = |lanes: Lanes<S>| lanes[lane].to_f64() * full_scale;
        let function = |fed: usize, curve: usize| {
            of(state.axes[fed / 2].output(6 * (curve / 3) + 3 * (fed % 2) + curve % 3))
        };
        Some(match wire {
            InnerWire::Accumulator(_) | InnerWire::Sum(_) => return None,
            InnerWire::Ramp(axis) => of(state.block.fed[axis][0].ramp()),
            InnerWire::Function { fed, order } => function(fed, order),
            InnerWire::Derivative { fed, order } => function(fed, 3 + order),
            InnerWire::Product { sum, term } => of(state.wires.product(TERMS * sum + term)),
            InnerWire::Converter { sum, term } => of(state.wires.term(TERMS * sum + term)),
            InnerWire::Colour(colour) => {
                let terms = (0..TERMS).filter(|&term| word_of(term)[0] == colour);
                terms.map(|term| of(state.wires.term(term))).sum()
            }
        })
    }

    /// Words as registers of this array hold them: whole numbers of the least bit of its D/As, if these have a length.
    pub fn as_held(&self, words: &CornerWords) -> CornerWords {
        std::array::from_fn(|word| match &self.words {
            None => words[word],
            Some(_) => self.scale.word(self.number(words, word).1, word),
        })
    }
}

/// Samples (at most those of 2^32) after which an array that was at rest is where it would be if it had run for ever: what
/// one pole remembers of its start is then below the last bit of any scalar, e^-37, whatever stands before and behind it
/// (four more of each time constant of the `chain`), amplifiers have slewed from end to end, and of an overload in
/// that time e^-7 is left.
fn warm_up(h: f64, chain: &[f64], parts: &AnalogParts) -> i64 {
    let slowest = chain.iter().copied().fold(0.0, f64::max);
    let amplifier = &parts.amplifier;
    let swing = amplifier.slew.map_or(0.0, |slew| 2.0 * parts.full_scale / slew);
    let overload = amplifier.saturation.map_or(0.0, |_| 7.0 * amplifier.recovery);
    let settled = 37.0 * slowest + 4.0 * chain.iter().sum::<f64>() + swing;
    (settled.max(overload) / h).ceil().min(4_294_967_296.0) as i64 + HELD
}

/// Samples that an array at rest has not seen yet, whatever its time constants: a staircase takes the word of the sample before, and
/// leaks of multipliers, and then of D/As, are the change since the sample before.
const HELD: i64 = 3;

/// Whoever looks inside the array, sample by sample; `()` is nobody.
pub(crate) trait Tap<S> {
    /// Samples that go through the array together, at most [`BLOCK`]; the wires are shown at the last of them.
    const PACE: usize = 1;
    /// Whether it asks for the wires of single D/As.
    const WIRES: bool = true;
    /// The wires at the next sample.
    fn see(&mut self, array: &PartsArray<S>, state: &ArrayState<S>);
}

impl<S> Tap<S> for () {
    const PACE: usize = BLOCK;
    const WIRES: bool = false;
    fn see(&mut self, _: &PartsArray<S>, _: &ArrayState<S>) {}
}
