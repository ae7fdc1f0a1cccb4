//! When elevation falls: the differentiator and the comparator behind it, which do not depend on the hold.

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use parts::{Comparator, ComparatorState, Differentiator, SecondOrderState};
use signal::{LANES, Lanes, Real};

use crate::of_parts::figures::{DERIVATIVE, Figures};
use crate::of_parts::lane::{Group, Output, bits, comparable};

/// The circuit, for one step length.
#[derive(Debug, Clone)]
pub(crate) struct Falls<S> {
    differentiator: Differentiator<S>,
    /// Steps by which the nominal differentiator is late; everything else is delayed by as much.
    late: f64,
    comparator: Comparator<S>,
}

impl<S: Real> Falls<S> {
    pub fn new(h: f64, figures: &Figures<'_>) -> Self {
        let [lag, nominal] = figures.derivative_lags("dpp.derivative.bandwidth");
        let comparator = "dpp.derivative.comparator";
        Self {
            differentiator: Differentiator::new(h, DERIVATIVE, lag),
            late: lateness(h, nominal),
            comparator: Comparator::new(h, &figures.falling(comparator), figures.source(comparator)),
        }
    }

    /// What comes out of the differentiator in a lane (units of the wire a second), earlier by what
    /// everything else is delayed.
    pub fn rates(&self, elevation: &[Lanes<S>], lane: usize) -> Vec<f64> {
        let Some(last) = elevation.len().checked_sub(1) else { return Vec::new() };
        let mut rates = Vec::new();
        self.differentiate(elevation, &mut rates);
        let out: Vec<f64> = rates.iter().map(|rate| rate[lane].to_f64() / DERIVATIVE).collect();
        let late = |sample: usize| {
            let at = (sample as f64 + self.late).min(last as f64);
            let (before, share) = (at as usize, at.fract());
            out[before] + share * (out[last.min(before + 1)] - out[before])
        };
        (0..=last).map(late).collect()
    }

    /// Trips of the comparator, all of a sweep at once; `rates` is room for what the differentiator has.
    pub fn list(&self, group: &Group<'_, S>, rates: &mut Vec<Lanes<S>>, falling: &mut [Output; LANES]) {
        falling.iter_mut().for_each(|falling| falling.reset(false));
        self.differentiate(group.elevation, rates);
        dispatch!(Level::new(), simd => self.compare_wide(simd, group, rates, falling));
        for trip in falling.iter_mut().flat_map(|falling| &mut falling.trips) {
            trip.at.0 -= self.late;
        }
    }

    /// What the differentiator has at the samples of a group.
    fn differentiate(&self, elevation: &[Lanes<S>], rates: &mut Vec<Lanes<S>>) {
        rates.resize(elevation.len(), Lanes::default());
        dispatch!(Level::new(), simd => self.differentiate_wide(simd, elevation, rates));
    }

    #[inline(always)]
    fn differentiate_wide<L: Simd>(&self, simd: L, elevation: &[Lanes<S>], rates: &mut [Lanes<S>]) {
        let Some(first) = elevation.first() else { return };
        let mut before = S::Vector::<L>::from_slice(simd, &first.0);
        let mut poles = SecondOrderState { y: before, rate: S::Vector::<L>::simd_from(simd, S::ZERO) };
        rates[0] = Lanes::default();
        for (now, rate) in elevation.iter().zip(rates).skip(1) {
            let now = S::Vector::<L>::from_slice(simd, &now.0);
            self.differentiator.step(&mut poles, before, now).store_slice(&mut rate.0);
            before = now;
        }
    }

    #[inline(always)]
    fn compare_wide<L: Simd>(
        &self,
        simd: L,
        group: &Group<'_, S>,
        rates: &[Lanes<S>],
        falling: &mut [Output; LANES],
    ) {
        let mut watch = self.comparator.watch(&group.sweeps);
        let mut states = [ComparatorState::default(); LANES];
        for lane in 0..LANES {
            watch.look(lane, &self.comparator, &states[lane]);
        }
        let mut start = -S::Vector::<L>::simd_from(simd, S::ZERO);
        for (sample, rate) in rates.iter().enumerate().skip(1) {
            let end = -S::Vector::<L>::from_slice(simd, &rate.0);
            for lane in bits(watch.stirs(simd, sample, start, end)) {
                if sample < group.ends[lane] {
                    let ends = comparable(-rates[sample - 1][lane], -rate[lane]);
                    let deviate = watch.deviate(lane, sample);
                    self.comparator.walk(&mut states[lane], sample, deviate, ends, &mut falling[lane].trips);
                    watch.look(lane, &self.comparator, &states[lane]);
                } else {
                    watch.look_away(lane);
                }
            }
            start = end;
        }
    }
}

/// Steps by which the differentiator's output at the samples is behind the slope of a parabola, of which it sees the
/// chords: `1/2 + q / (1 - q) + r q / (1 - q)^2`, `r = h / tau_f`, `q = e^-r`, which is `2 tau_f / h` for long lags.
pub(crate) fn lateness(h: f64, lag: f64) -> f64 {
    if lag == 0.0 {
        return 0.5;
    }
    let ratio = h / lag;
    let left = -libm::expm1(-ratio);
    let kept = libm::exp(-ratio) / left;
    0.5 + kept + ratio * kept / left
}
