//! When elevation falls: differentiator and comparator (sheet of the projection processor).

use std::f64::consts::PI;

use super::comparator::{Comparator, ComparatorFigures, Trip};
use super::kit::Kit;
use super::series::TwoPoleMap;

/// Gain of the differentiator (s).
const GAIN: f64 = 250e-9;

/// Band in which the noise of an amplifier is told (Hz).
const NOISE_BAND: f64 = 10e6;

/// Time constants after which a parabola has settled.
const SETTLED: f64 = 45.0;

/// Differentiator and comparator of the beam.
#[derive(Debug, Clone, Copy)]
pub struct Falls {
    /// Poles of the differentiator over a sample; none where it has no lag.
    poles: Option<TwoPoleMap>,
    /// What a change of full scale in a step comes out as.
    gain: f64,
    /// How late the nominal differentiator is (steps).
    pub late: f64,
    comparator: ComparatorFigures,
}

/// Deviation of the noise of the elevation (share of full scale), in the band of the processor.
pub fn noise(kit: &Kit<'_>) -> f64 {
    kit.share(kit.analog.amplifier.noise) * (band(kit) / NOISE_BAND).sqrt()
}

fn band(kit: &Kit<'_>) -> f64 {
    kit.analog.projection.bandwidth.unwrap_or(NOISE_BAND)
}

/// What of a bandwidth a pole is (s): two of it pass as much noise as an end of the band, `1 / (8 tau^3) = 4 pi^2 B^3 / 3`.
fn pole(bandwidth: f64) -> f64 {
    libm::cbrt(3.0 / (32.0 * PI * PI)) / bandwidth
}

impl Falls {
    /// As the seed drew them.
    pub fn of(kit: &Kit<'_>) -> Self {
        let bandwidth = kit.analog.projection.bandwidth;
        let steps = |bandwidth: f64| pole(bandwidth) / kit.step;
        // A lag of 1 / (2 pi B) and the pole are in a fixed ratio, so one draw serves both.
        let drawn = |nominal: f64| {
            steps(nominal) * kit.lag("dpp.derivative.bandwidth", 0, bandwidth) / kit.nominal_lag(bandwidth)
        };
        let own = ComparatorFigures::of(kit, "dpp.derivative.comparator", 0);
        // White noise in a band B comes out of the differentiator as 2 pi B / sqrt 3 times as much.
        let noise = 2.0 * PI * band(kit) * noise(kit) / 3.0_f64.sqrt() * GAIN;
        let map = |tau: f64| TwoPoleMap::of(1.0, tau, 1.0);
        Self {
            poles: bandwidth.map(drawn).map(map),
            gain: GAIN / kit.step,
            late: lateness(bandwidth.map(steps)),
            // It needs the whole hysteresis to find a fall.
            comparator: ComparatorFigures { offset: own.offset + 0.5 * own.hysteresis, noise, ..own },
        }
    }

    /// What comes out of the differentiator at the samples (full scales of the comparator).
    fn differentiated(&self, elevation: &[f64]) -> Vec<f64> {
        changes(self.poles.as_ref(), elevation).into_iter().map(|change| self.gain * change).collect()
    }

    /// The rate of the elevation in units of the wire a step, earlier by what everything else waits for the differentiator.
    pub fn rates(&self, elevation: &[f64]) -> Vec<f64> {
        let rates = changes(self.poles.as_ref(), elevation);
        let Some(last) = rates.len().checked_sub(1) else { return rates };
        let at = |sample: usize| {
            let time = (sample as f64 + self.late).min(last as f64);
            let before = time.floor() as usize;
            let share = time - before as f64;
            (1.0 - share) * rates[before] + share * rates[(before + 1).min(last)]
        };
        (0..=last).map(at).collect()
    }

    /// Trips of the comparator over the first `end` samples, by the time at which they count; and by sample how near it has come to
    /// another decision so far. `deviate` is that of the noise of a sample.
    pub fn trips(
        &self,
        elevation: &[f64],
        end: usize,
        deviate: impl Fn(usize) -> f64,
    ) -> (Vec<Trip>, Vec<f64>) {
        let rates = self.differentiated(elevation);
        let mut comparator = Comparator::new(self.comparator, false);
        let (mut trips, mut near) = (Vec::new(), vec![f64::INFINITY; end]);
        for sample in 1..end {
            comparator.step(sample, deviate(sample), [-rates[sample - 1], -rates[sample]], &mut trips);
            near[sample] = comparator.nearest;
        }
        trips.iter_mut().for_each(|trip| trip.at -= self.late);
        (trips, near)
    }
}

/// Rate of change at the samples behind the poles, by the step; 0 at the first.
fn changes(poles: Option<&TwoPoleMap>, wire: &[f64]) -> Vec<f64> {
    let first = wire.first().copied().unwrap_or(0.0);
    let mut state = [first, 0.0];
    let rest = wire.windows(2).map(|ends| {
        let ends = [ends[0], ends[1]];
        state = poles.map_or([ends[1], ends[1] - ends[0]], |poles| poles.step(state, ends));
        state[1]
    });
    wire.first().map(|_| 0.0).into_iter().chain(rest).collect()
}

/// How late the differentiator is behind the slope of a parabola that it sees in chords: a parabola is passed through (steps).
fn lateness(tau: Option<f64>) -> f64 {
    let poles = tau.map(|tau| TwoPoleMap::of(1.0, tau, 1.0));
    let steps = (SETTLED * tau.unwrap_or(0.0)).ceil() as usize + 2;
    // From the top on: what it was before is forgotten.
    let parabola: Vec<f64> = (0..=steps).map(|step| 0.5 * (step * step) as f64).collect();
    let rates = changes(poles.as_ref(), &parabola);
    steps as f64 - rates[steps]
}
