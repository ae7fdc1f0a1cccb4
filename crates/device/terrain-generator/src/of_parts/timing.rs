//! When what the control plane has timed acts on the wires.
//!
//! **Stops.** A fold that is found on the ramp is found by the comparator of its stop: late by the ramp's own delay and the
//! comparator's on a ramp of its slope s, and by `o / s` for an offset o.
//! **Words.** Each multiplying D/A takes its own time from strobe to effect, so the nine words of a corner do not settle
//! as one.
//! **Our choices.** A strobe of the words in hold never overtakes the one before it. Words that come after their fold are
//! loaded at their own time, whenever the fold was found. A polarity waits for its own stops alone, one after the other:
//! neither for words nor for the other axis, whose fold may be found later.

use hardware_model::{AnalogParts, FoldDetect};
use parts::{Comparator, NoiseSource, Spread, Tolerance, relative_sigma, time_constant};
use sweep_program::{Fold, RampAxis, Step, Stop, SweepProgram};

use super::ramp::RampParts;
use crate::TerrainGenerator;
use crate::terms::ALL;

/// When what lies before the first range acts, where the accumulators are preset to it (samples): before every part has settled.
const IN_RETRACE: f64 = -1e12;

/// A ramp flatter than this counts as one of this slope (full scales a second): it meets no stop within a sweep.
const FLATTEST: f64 = 1e3;

/// Delays of one array.
#[derive(Debug, Clone)]
pub(super) struct Timing {
    /// Length of a sample (s).
    pub step: f64,
    /// By how much the ramps run ahead of the beam (s).
    pub lead: f64,
    /// Whether retrace presets the accumulators to the first range.
    pub preset: bool,
    /// From a fold in the accumulator to the polarity and to the registers (s), nominal.
    to_polarity: f64,
    to_registers: f64,
    /// From there to the output that tells the fold: of the accumulator, or of the comparator at the stop (s), nominal.
    to_stops: f64,
    /// From the strobe of a register to what its D/As make of it (s), nominal.
    switching: f64,
    /// Where folds are found on the ramps: of the lower and the upper stop of each axis.
    stops: Option<[LimitStop; 4]>,
    /// By how many samples each multiplying D/A switches later than a nominal one; empty if they are alike.
    later: Vec<f64>,
    /// The least of them, at most 0.
    pub earliest: f64,
}

/// The comparator of a limit stop.
#[derive(Debug, Clone, Copy)]
struct LimitStop {
    comparator: Comparator<f64>,
    /// Of its threshold (share of full scale), outwards positive.
    offset: f64,
    /// What its ramp and its comparator have beside nominal delay (s).
    beside: f64,
}

/// From the accumulator through the chain (s), nominal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Delays {
    pub to_ramps: f64,
    pub to_generators: f64,
    pub to_converters: f64,
    pub to_sums: f64,
}

impl Timing {
    /// Of the array called `name` with these `ramps`, for steps of `h` seconds.
    pub fn new<S: signal::Real>(
        h: f64,
        delays: &Delays,
        ramps: &[RampParts<S>; 2],
        parts: &AnalogParts,
        (spread, name): (&Spread, &str),
    ) -> Self {
        let switching = parts.multiplying_dac.switching;
        let on_ramp = parts.sweep.fold_detect == FoldDetect::Comparator;
        let (to_polarity, to_registers) = if on_ramp {
            let found = delays.to_ramps + parts.comparator.delay;
            (found, found + switching)
        } else {
            // Strobes are trimmed for the time that words take to act, as far as they can come earlier.
            (delays.to_generators, delays.to_converters.max(switching))
        };
        let stop = |index: usize| {
            let law = parts.comparator_law(spread, &format!("{name}.stop"), index as u64);
            let beside = ramps[index / 2].delay() - delays.to_ramps - parts.comparator.delay;
            let source = NoiseSource::new(0, name, 0);
            let outwards = if index % 2 == 1 { law.offset } else { -law.offset };
            // In steps of a second.
            LimitStop { comparator: Comparator::new(1.0, &law, source), offset: outwards, beside }
        };
        let later = switching_times(parts, spread, name).map(|time| (time - switching) / h);
        let later: Vec<f64> = if parts.spread && switching > 0.0 { later.collect() } else { Vec::new() };
        Self {
            step: h,
            lead: delays.to_sums,
            preset: parts.sweep.preset,
            to_polarity: to_polarity + parts.sweep.strobe_offset,
            to_registers: to_registers + parts.sweep.strobe_offset,
            to_stops: if on_ramp { delays.to_ramps + parts.comparator.delay } else { 0.0 },
            switching,
            stops: on_ramp.then(|| std::array::from_fn(stop)),
            earliest: later.iter().copied().fold(0.0, f64::min),
            later,
        }
    }

    /// When a nominal D/A has the words of `step` (samples).
    pub fn of_words(&self, step: &Step, generator: &TerrainGenerator<'_>, program: &SweepProgram) -> f64 {
        self.acts(step, self.to_registers, generator, program)
    }

    /// When a polarity flip-flop has turned (samples).
    pub fn of_polarity(&self, step: &Step, generator: &TerrainGenerator<'_>, program: &SweepProgram) -> f64 {
        self.acts(step, self.to_polarity, generator, program)
    }

    /// When a stop's output tells the fold of `step` (samples).
    pub fn of_stop(&self, step: &Step, generator: &TerrainGenerator<'_>, program: &SweepProgram) -> f64 {
        self.acts(step, self.to_stops, generator, program)
    }

    /// When the registers of `step` are strobed (samples).
    pub fn of_strobe(&self, step: &Step, generator: &TerrainGenerator<'_>, program: &SweepProgram) -> f64 {
        self.acts(step, self.to_registers - self.switching, generator, program)
    }

    /// Ground range that the accumulators have at `time` (samples of the beam) over samples at `ranges`.
    pub fn accumulated(&self, ranges: &[f64], time: f64) -> f64 {
        let time = time + self.lead / self.step;
        range_at(ranges, if self.preset { time.max(0.0) } else { time })
    }

    /// Whether all D/As switch in the same instant.
    pub fn are_together(&self) -> bool {
        self.later.is_empty()
    }

    /// By how many samples D/A `index` is later than a nominal one.
    pub fn later(&self, index: usize) -> f64 {
        self.later.get(index).copied().unwrap_or(0.0)
    }

    /// When something acts on the wires, nominally `delay` seconds down the chain from its step.
    fn acts(&self, step: &Step, delay: f64, generator: &TerrainGenerator<'_>, program: &SweepProgram) -> f64 {
        if self.preset && step.time.0 <= 0.0 {
            return IN_RETRACE;
        }
        let beside = match (&self.stops, step.kind.fold()) {
            (Some(stops), Some(fold)) => {
                let axis = usize::from(fold.axis == RampAxis::Y);
                let slope = program.start.ramps[axis].rate.abs() * pace(generator.ranges, step.time.0)
                    / (generator.region_size * self.step);
                stops[stop_of(fold)].beside(slope)
            }
            _ => 0.0,
        };
        step.time.0 - (self.lead - (delay + beside)) / self.step
    }
}

impl LimitStop {
    /// How much later than by nominal delays a ramp of `slope` (full scales a second) is found at its stop (s).
    fn beside(&self, slope: f64) -> f64 {
        let slope = slope.max(FLATTEST);
        self.beside + self.comparator.on_ramp(slope) + self.offset / slope
    }
}

/// Number of the stop that a ramp meets: lower and upper of X, then of Y.
fn stop_of(fold: &Fold) -> usize {
    2 * usize::from(fold.axis == RampAxis::Y) + usize::from(fold.stop == Stop::One)
}

/// From strobe to effect, of each multiplying D/A (s).
fn switching_times(parts: &AnalogParts, spread: &Spread, name: &str) -> impl Iterator<Item = f64> {
    let tolerance =
        Tolerance { nominal: parts.multiplying_dac.switching, sigma: relative_sigma::SWITCH_DELAY };
    let part = format!("{name}.mdac.switching");
    (0..ALL as u64).map(move |index| spread.figure(&part, index, &tolerance))
}

/// Delay of a part of this bandwidth, if it has one (s).
pub(super) fn lag_of(bandwidth: Option<f64>) -> f64 {
    bandwidth.map_or(0.0, time_constant)
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

/// Ground range of the sample in which `time` lies (m).
fn pace(ranges: &[f64], time: f64) -> f64 {
    if time <= 0.0 {
        return ranges[0];
    }
    let before = (time as usize).min(ranges.len() - 2);
    ranges[before + 1] - ranges[before]
}
