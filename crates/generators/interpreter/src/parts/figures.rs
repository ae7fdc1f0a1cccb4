//! Figures of every part of one array (hardware sections 0, 3.1 to 3.6), in seconds and shares of full scale.

use std::f64::consts::PI;

use hardware_model::{AnalogParts, FoldDetect};
use landscape::Level;

use super::drawn::Drawn;

/// Products of one sum.
pub const TERMS: usize = 36;
/// Function generators of an axis: values, then slopes; near end, then far end; three orders.
pub const UNITS: usize = 12;
/// Largest values of the three basis functions, and of their slopes (section 5.2).
pub const PEAKS: [f64; 6] = [1.0, 16.0 / 81.0, 108.0 / 6250.0, 1.875, 1.0, SLOPE_OF_ORDER_TWO];
/// Slope of the basis function of order 2 at `z = (8 - sqrt 24) / 20`: `z - 4.5 z^2 + 6 z^3 - 2.5 z^4`.
const SLOPE_OF_ORDER_TWO: f64 = 0.067_787_753_826_796_28;

/// Relative deviations of parts that differ (section 0).
pub(crate) mod sigma {
    pub const BANDWIDTH: f64 = 0.20;
    pub const SLEW: f64 = 0.15;
    pub const SWITCHING: f64 = 0.25;
    pub const SETTLING: f64 = 0.30;
    pub const CHARGE: f64 = 0.50;
}

/// Leaks are given as shares of a sine wave of this frequency (Hz).
const LEAKS_AT: f64 = 1e6;
/// A converter has settled when this share of the step is left.
pub(super) const SETTLED: f64 = 1e-3;

/// A ramp's converter and smoother.
#[derive(Debug, Clone, Copy)]
pub struct RampFigures {
    /// Bits of the converter; none where there is no converter.
    pub bits: Option<u32>,
    /// Largest deviation of a level from a straight line.
    pub nonlinearity: f64,
    /// Area of the pulse at the major carry (full scale times seconds).
    pub glitch: f64,
    /// Settling time constant (s).
    pub settle: f64,
    /// Inverse natural frequency of the smoother (s); 0 where there is none.
    pub smoother: f64,
}

/// A function generator of one axis.
#[derive(Debug, Clone, Copy, Default)]
pub struct FunctionFigures {
    /// Deviation at the middle of its input.
    pub bow: f64,
    /// Time constant of the lag (s).
    pub tau: f64,
}

/// A multiplier and the multiplying D/A behind it.
#[derive(Debug, Clone, Copy, Default)]
pub struct CellFigures {
    /// Scale error of the multiplier.
    pub gain: f64,
    /// Feedthrough of both inputs.
    pub feed: [f64; 2],
    /// Offset of the multiplier.
    pub offset: f64,
    /// Bend of the first input.
    pub bend: f64,
    /// What leaks of the first input's rate (s).
    pub leak: f64,
    /// Time constant of the multiplier (s).
    pub tau: f64,
    /// What the D/A makes of a word: its gain, and the scale of its sum.
    pub factor: f64,
    /// Time constant of the D/A (s).
    pub converter_tau: f64,
    /// What leaks of the product's rate past the D/A (s).
    pub past: f64,
    /// How much later than a nominal one the D/A switches (s).
    pub later: f64,
}

/// An amplifier of a tree.
#[derive(Debug, Clone, Copy)]
pub struct AmplifierFigures {
    /// Time constant of the lag (s).
    pub tau: f64,
    /// Slew rate (full scales a second).
    pub slew: f64,
    /// Largest output either way (full scales).
    pub saturation: f64,
    /// Recovery from overload (s).
    pub recovery: f64,
}

/// The comparator of a limit stop.
#[derive(Debug, Clone, Copy)]
pub struct StopFigures {
    /// Threshold beyond the stop (share of full scale).
    pub outwards: f64,
    /// Delay (s), and charge of the overdrive (full scales times seconds).
    pub delay: [f64; 2],
    /// Longest delay in all (s).
    pub longest: f64,
    /// Delay of its own ramp (s).
    pub ramp: f64,
}

/// Full scales of a level.
#[derive(Debug, Clone, Copy)]
pub struct Scales {
    /// Height at which the wire of the height is at 0 (m).
    pub datum: f64,
    /// Height at full scale (m).
    pub height: f64,
    /// Slope words at full scale (m a region).
    pub slope: f64,
}

/// All of an array.
#[derive(Debug, Clone)]
pub struct Figures {
    /// Length of a step (s).
    pub step: f64,
    /// Full scales of the level.
    pub scales: Scales,
    /// Figures of both ramps.
    pub ramps: [RampFigures; 2],
    /// Function generators by axis.
    pub functions: [[FunctionFigures; UNITS]; 2],
    /// Cells of height, slope to the north and slope to the east: `6 p + q`.
    pub cells: [Vec<CellFigures>; 3],
    /// Bits of the multiplying D/As, the sign counted; none where they take any word.
    pub word_bits: Option<u32>,
    /// Area of the pulse at the major carry of a word, for a product of full scale (full scale times seconds).
    pub word_glitch: f64,
    /// Inputs that meet at one amplifier of the first stage.
    pub inputs: usize,
    /// Amplifiers stage by stage, of each tree; no stage where sums are ideal.
    pub trees: [Vec<Vec<AmplifierFigures>>; 3],
    /// Deviation of the noise of a sum.
    pub noise: f64,
    /// By how much the ramps run ahead of the beam (s).
    pub lead: f64,
    /// From a fold in the accumulator to the polarity (s).
    pub to_polarity: f64,
    /// From a fold in the accumulator to the words in a nominal D/A (s).
    pub to_words: f64,
    /// From a fold in the accumulator to where a nominal comparator finds it on a nominal ramp (s).
    pub found: f64,
    /// Comparators of the stops of X at 0 and 1, then of Y; none where the accumulator finds the folds.
    pub stops: Option<[StopFigures; 4]>,
    /// Whether retrace presets the accumulators to the first range.
    pub preset: bool,
}

/// Time constant of a bandwidth (Hz), in seconds.
pub(super) fn time_constant(bandwidth: f64) -> f64 {
    1.0 / (2.0 * PI * bandwidth)
}

/// The figures of the array called `name` over `level`, for steps of `step` seconds.
pub fn figures(step: f64, level: &Level, parts: &AnalogParts, drawn: &Drawn<'_>, name: &str) -> Figures {
    let draw = Draw { drawn, name, differ: parts.spread };
    let volt = 1.0 / parts.full_scale;
    let scales = scales(level);
    let settle = parts.sweep.settle / -libm::log(SETTLED);
    let ramps = [0, 1].map(|axis| RampFigures {
        bits: parts.sweep.dac_bits,
        nonlinearity: parts.sweep.nonlinearity,
        glitch: parts.sweep.glitch * volt,
        settle: draw.figure("ramp.settle", axis, settle, sigma::SETTLING),
        smoother: parts.sweep.smoother,
    });
    let nominal = RampFigures { settle, ..ramps[0] };
    let tau = |bandwidth: Option<f64>| bandwidth.map_or(0.0, time_constant);
    let (inputs, counts, tree_tau) = stages(parts);
    let to_functions = nominal.delay(step) + tau(parts.function_generator.bandwidth);
    let to_converters = to_functions + tau(parts.multiplier.bandwidth);
    let to_sums = to_converters + tau(parts.multiplying_dac.bandwidth) + tree_tau * counts.len() as f64;
    let switching = parts.multiplying_dac.switching;
    let on_ramp = parts.sweep.fold_detect == FoldDetect::Comparator;
    let found = nominal.delay(step) + parts.comparator.delay;
    let (to_polarity, to_words) =
        if on_ramp { (found, found + switching) } else { (to_functions, to_converters.max(switching)) };
    let stop = |number: usize| {
        let (deviates, late) = ("stop", parts.comparator);
        let delay = draw.figure(deviates, number, late.delay, sigma::SWITCHING);
        let offset = draw.error("stop.offset", number, late.offset * volt);
        StopFigures {
            outwards: if number % 2 == 1 { offset } else { -offset },
            delay: [delay, draw.figure(deviates, number, late.overdrive * volt, sigma::SWITCHING)],
            longest: (12.5 * delay).min(delay.max(500e-9)),
            ramp: ramps[number / 2].delay(step),
        }
    };
    Figures {
        step,
        scales,
        ramps,
        functions: [0, 1].map(|axis| std::array::from_fn(|unit| draw.function(parts, UNITS * axis + unit))),
        cells: [0, 1, 2].map(|sum| (0..TERMS).map(|term| draw.cell(parts, &scales, sum, term)).collect()),
        word_bits: parts.multiplying_dac.bits,
        word_glitch: parts.multiplying_dac.glitch * volt,
        inputs: if counts.is_empty() { TERMS } else { inputs },
        trees: ["height", "slope-u", "slope-v"].map(|sum| draw.tree(parts, sum, &counts, tree_tau)),
        noise: parts.amplifier.noise * volt,
        lead: to_sums,
        to_polarity: to_polarity + parts.sweep.strobe_offset,
        to_words: to_words + parts.sweep.strobe_offset,
        found,
        stops: on_ramp.then(|| std::array::from_fn(stop)),
        preset: parts.sweep.preset,
    }
}

impl Figures {
    /// Steps for which parts remember a change, down to e^-20 of it.
    pub fn memory(&self) -> usize {
        let ramps = self.ramps.iter().flat_map(|ramp| [ramp.settle, ramp.smoother]);
        let functions = self.functions.iter().flatten().map(|function| function.tau);
        let cells = self.cells.iter().flatten().flat_map(|cell| [cell.tau, cell.converter_tau]);
        let amplifiers = self.trees.iter().flatten().flatten().map(|amplifier| amplifier.tau);
        let slowest = ramps.chain(functions).chain(cells).chain(amplifiers).fold(0.0, f64::max);
        ((20.0 * slowest + self.lead) / self.step).ceil() as usize + 1
    }
}

impl RampFigures {
    /// How late the ramp is behind its accumulator (s): a staircase by half a step more.
    pub fn delay(&self, step: f64) -> f64 {
        let half = if self.smoother > 0.0 { 0.5 * step } else { 0.0 };
        let stairs = self.bits.map_or(0.0, |_| self.settle + half);
        // Two poles of damping 0.8.
        stairs + 1.6 * self.smoother
    }
}

/// Inputs of an amplifier, amplifiers of each stage, and their time constant (s).
fn stages(parts: &AnalogParts) -> (usize, Vec<usize>, f64) {
    let figures = &parts.amplifier;
    let inputs = parts.summer_inputs.map_or(TERMS, |inputs| (inputs as usize).max(2));
    let noise_gain = 1.0 + parts.summer_inputs.map_or(1.0, |_| inputs as f64);
    let tau = figures.gain_bandwidth.map_or(0.0, |band| noise_gain * time_constant(band));
    let is_real = figures.gain_bandwidth.is_some() || figures.slew.is_some() || figures.saturation.is_some();
    let (mut counts, mut left) = (Vec::new(), TERMS);
    while is_real && left > 1 {
        left = left.div_ceil(inputs);
        counts.push(left);
    }
    (inputs, counts, tau)
}

/// The smallest powers of two that hold every word of a level.
fn scales(level: &Level) -> Scales {
    let heights = level.words().iter().map(|words| words[0]);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(h), b.max(h)));
    let datum = 0.5 * (low + high);
    let [mut height, mut slope] = [0.0_f64; 2];
    for words in level.words() {
        for p in 0..3 {
            for q in 0..3 {
                let above = if p + q == 0 { datum } else { 0.0 };
                let word = (words[3 * p + q] - above).abs();
                height = height.max(word * PEAKS[p] * PEAKS[q]);
                slope = slope.max(word * PEAKS[3 + p] * PEAKS[q]).max(word * PEAKS[p] * PEAKS[3 + q]);
            }
        }
    }
    let up = |value: f64| if value > 0.0 { libm::exp2(libm::log2(value).ceil()) } else { 1.0 };
    Scales { datum, height: up(height), slope: up(slope) }
}

/// The deviates of one array.
struct Draw<'a> {
    drawn: &'a Drawn<'a>,
    name: &'a str,
    /// Whether parts differ from one another; static errors are drawn in any case.
    differ: bool,
}

impl Draw<'_> {
    fn figure(&self, figure: &str, number: usize, nominal: f64, sigma: f64) -> f64 {
        let sigma = if self.differ { sigma } else { 0.0 };
        self.drawn.figure(&format!("{}.{figure}", self.name), number, nominal, sigma)
    }

    fn error(&self, figure: &str, number: usize, sigma: f64) -> f64 {
        self.drawn.error(&format!("{}.{figure}", self.name), number, sigma)
    }

    fn tau(&self, figure: &str, number: usize, bandwidth: Option<f64>) -> f64 {
        bandwidth.map_or(0.0, |band| time_constant(self.figure(figure, number, band, sigma::BANDWIDTH)))
    }

    fn function(&self, parts: &AnalogParts, number: usize) -> FunctionFigures {
        let figures = &parts.function_generator;
        FunctionFigures {
            bow: self.error("fn", number, figures.error),
            tau: self.tau("fn.bandwidth", number, figures.bandwidth),
        }
    }

    fn cell(&self, parts: &AnalogParts, scales: &Scales, sum: usize, term: usize) -> CellFigures {
        let (number, [multiplier, converter]) =
            (TERMS * sum + term, [parts.multiplier.error, parts.multiplying_dac.gain_error]);
        let half = |figure: &str| self.error(figure, number, 0.5 * multiplier);
        let leak = |figure: &str, share: f64| self.error(figure, number, share) / (2.0 * PI * LEAKS_AT);
        let [p, q] = [term / 6 % 3, term % 3];
        let scale_of_sum = |order: usize| scales.height / scales.slope * PEAKS[3 + order] / PEAKS[order];
        let sum_scale = [1.0, scale_of_sum(p), scale_of_sum(q)][sum];
        let switching = parts.multiplying_dac.switching;
        let switches = self.figure("mdac.switching", number, switching, sigma::SWITCHING);
        CellFigures {
            gain: self.error("mul.eg", number, parts.multiplier.scale_error),
            feed: [half("mul.ex"), half("mul.ey")],
            offset: half("mul.eo"),
            bend: half("mul.en"),
            leak: leak("mul.feedthrough", parts.multiplier.feedthrough),
            tau: self.tau("mul.bandwidth", number, parts.multiplier.bandwidth),
            factor: sum_scale * (1.0 + self.error("mdac.gain", number, converter)),
            converter_tau: self.tau("mdac.bandwidth", number, parts.multiplying_dac.bandwidth),
            past: leak("mdac.feedthrough", parts.multiplying_dac.feedthrough),
            later: switches - switching,
        }
    }

    fn tree(&self, parts: &AnalogParts, sum: &str, counts: &[usize], tau: f64) -> Vec<Vec<AmplifierFigures>> {
        let figures = &parts.amplifier;
        let volts = |volts: Option<f64>| volts.map_or(f64::INFINITY, |volts| volts / parts.full_scale);
        let mut number = 0;
        let mut amplifier = || {
            number += 1;
            AmplifierFigures {
                tau: self.figure(&format!("{sum}.tau"), number, tau, sigma::BANDWIDTH),
                slew: self.figure(&format!("{sum}.slew"), number, volts(figures.slew), sigma::SLEW),
                saturation: volts(figures.saturation),
                recovery: figures.recovery,
            }
        };
        counts.iter().map(|&count| (0..count).map(|_| amplifier()).collect()).collect()
    }
}
