//! The parts of an array, drawn once from the seed of the model.

use std::ops::Range;

use hardware_model::{AnalogParts, FEEDTHROUGH_FREQUENCY, SweepParts};
use landscape::{CornerWords, Level};
use parts::{
    Feedthrough, LagStep, Multiplier, MultiplierLaw, MultiplyingConverter, NoiseSource, Spread, Tolerance,
    relative_sigma, time_constant,
};
use signal::{LANES, Real};
use sweep_program::SweepProgram;

use super::basis::AxisGenerators;
use super::ramp::RampParts;
use super::run::Run;
use super::scale::{PEAKS, SLOPE_PEAKS, Scale};
use super::state::ArrayState;
use super::summer::Summer;
use super::terms::{ALL, TERMS, word_of};
use super::timing::{Delays, Timing, lag_of};
use crate::TerrainGenerator;
use crate::generator::Profile;

/// The array, its parts drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsArray<S> {
    pub(super) scale: Scale,
    pub(super) ramps: [RampParts<S>; 2],
    pub(super) generators: [AxisGenerators<S>; 2],
    pub(super) multipliers: Vec<Multiplier<S>>,
    pub(super) multiplier_lags: Vec<LagStep<S>>,
    /// What leaks of the first input past each multiplier, and of the signal past each D/A; empty without.
    pub(super) multiplier_leaks: Vec<Feedthrough<S>>,
    pub(super) converter_leaks: Vec<Feedthrough<S>>,
    pub(super) words: Option<MultiplyingConverter>,
    /// Gains of the multiplying D/As.
    pub(super) gains: Vec<f64>,
    pub(super) converter_lags: Vec<LagStep<S>>,
    /// Time constants of the multiplying D/As (s), for steps that a new word divides; empty without lags.
    pub(super) converter_taus: Vec<f64>,
    /// Area of the pulse at the major carry of a word (full scale times seconds).
    pub(super) glitch: f64,
    pub(super) summers: [Summer<S>; 3],
    pub(super) noise: [NoiseSource; 3],
    pub(super) sigma: f64,
    pub(super) timing: Timing,
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
        let nominal = RampParts::<S>::new(h, parts.full_scale, &parts.sweep);
        let ramps = [0, 1].map(|axis| {
            let settle = draw("ramp.settle", axis, parts.sweep.settle, relative_sigma::SETTLING);
            RampParts::new(h, parts.full_scale, &SweepParts { settle, ..parts.sweep })
        });
        let summers = ["height", "slope-u", "slope-v"]
            .map(|sum| Summer::new(h, TERMS, parts, &spread, &format!("{name}.{sum}")));
        let to_generators = nominal.delay() + lag_of(parts.function_generator.bandwidth);
        let to_converters = to_generators + lag_of(parts.multiplier.bandwidth);
        let to_sums = to_converters + lag_of(parts.multiplying_dac.bandwidth) + summers[0].delay();
        let delays = Delays { to_ramps: nominal.delay(), to_generators, to_converters, to_sums };
        let timing = Timing::new(h, &delays, &ramps, parts, (&spread, name));
        Self {
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
            timing,
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
        let first = -(1.0 + self.timing.lead / self.timing.step).ceil() as i64;
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

    /// What D/A `index` multiplies by for these words.
    pub(super) fn weight(&self, words: &CornerWords, index: usize) -> f64 {
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
