//! Where the beam is: position through the deflection amplifier and coils or plates.

use fearless_simd::Simd;
use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use parts::{Delay, SecondOrder, SecondOrderState, SecondOrderStep, Spread, Tolerance, relative_sigma};
use signal::{Lanes, Number, Real};

use crate::aim::single;

/// Damping: the natural frequency is then the -3 dB bandwidth.
const DAMPING: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// How far beyond the picture, above and below, the amplifier drives the beam (picture heights).
const MARGIN: f64 = 0.5;

/// The write deflection, seen against an intensity that is delayed as much as the nominal part delays a ramp.
#[derive(Debug, Clone)]
pub(crate) struct Deflection<S> {
    step: SecondOrderStep<S>,
    /// The same over the part of a step by which the delay is longer than whole steps.
    rest: SecondOrderStep<S>,
    delay: Delay,
    stops: [S; 2],
}

impl<S: Real> Deflection<S> {
    /// Of `bandwidth` (Hz), for steps of `h` seconds and `lines` lines; `sigma` is how far the part is off it.
    pub fn new(bandwidth: f64, spread: Option<&Spread>, h: f64, lines: usize) -> Self {
        let nominal = part(bandwidth);
        let tolerance = Tolerance { nominal: bandwidth, sigma: relative_sigma::BANDWIDTH };
        let real = spread.map_or(bandwidth, |spread| spread.figure("sweep-memory.deflection", 0, &tolerance));
        Self::late(&part(real), Delay::new(h, nominal.group_delay()), h, lines)
    }

    fn late(part: &SecondOrder, delay: Delay, h: f64, lines: usize) -> Self {
        let height = lines as f64;
        Self {
            step: part.step(h),
            rest: part.step(h * delay.share),
            delay,
            stops: [-MARGIN * height, (1.0 + MARGIN) * height].map(S::from_f64),
        }
    }

    /// Where the beam is when each sample's intensity comes to it. Retrace is long enough for it to settle; behind
    /// the last sample the position stands.
    #[inline(always)]
    pub fn run_wide<L: Simd>(&self, simd: L, position: &[Lanes<S>], path: &mut [Lanes<f32>]) {
        let Some(last) = position.len().checked_sub(1) else { return };
        let mut from = self.within_stops(simd, &position[0]);
        let mut state = SecondOrderState { y: from, rate: S::Vector::<L>::simd_from(simd, S::ZERO) };
        let share = S::from_f64(self.delay.share);
        // More than a sweep late is as good as never.
        let whole = self.delay.whole.min(position.len());
        for sample in 0..=last + whole {
            let to = self.within_stops(simd, &position[last.min(sample + 1)]);
            if sample >= whole {
                let place = self.rest.step(state, from, from + (to - from) * share).y;
                single::<L, S>(simd, place).store_slice(&mut path[sample - whole].0);
            }
            state = self.step.step(state, from, to);
            from = to;
        }
    }

    /// Ground that is not there is as far down as the beam can go.
    #[inline(always)]
    fn within_stops<L: Simd>(&self, simd: L, place: &Lanes<S>) -> S::Vector<L> {
        let place = S::Vector::<L>::from_slice(simd, &place.0);
        let [top, bottom] =
            [S::Vector::<L>::simd_from(simd, self.stops[0]), S::Vector::<L>::simd_from(simd, self.stops[1])];
        place.simd_lt(bottom).select(place.at_least(top), bottom)
    }
}

fn part(bandwidth: f64) -> SecondOrder {
    SecondOrder { natural: 2.0 * std::f64::consts::PI * bandwidth, damping: DAMPING }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::{DAMPING, Deflection, part};
    use parts::{Delay, Spread};
    use signal::Lanes;

    const H: f64 = 50e-9;

    fn path(deflection: &Deflection<f64>, position: impl Fn(f64) -> f64, samples: usize) -> Vec<f64> {
        let position: Vec<_> = (0..samples).map(|sample| Lanes::splat(position(sample as f64))).collect();
        let mut path = vec![Lanes::default(); samples];
        dispatch!(Level::new(), simd => deflection.run_wide(simd, &position, &mut path));
        path.iter().map(|place| f64::from(place[3])).collect()
    }

    fn ramp(sample: f64) -> f64 {
        400.0 - 0.8 * (sample - 20.0).max(0.0)
    }

    #[test]
    fn it_lags_a_ramp_by_its_delay_and_the_match_takes_it_away() {
        for bandwidth in [3e6, 0.3e6] {
            let delay = part(bandwidth).group_delay() / H;
            let unmatched = Deflection::late(&part(bandwidth), Delay::new(H, 0.0), H, 500);
            let matched = Deflection::new(bandwidth, None, H, 500);
            let (late, right) = (path(&unmatched, ramp, 400), path(&matched, ramp, 400));
            for sample in 250..350 {
                assert!((late[sample] - ramp(sample as f64) - 0.8 * delay).abs() < 1e-3, "{}", late[sample]);
                assert!((right[sample] - ramp(sample as f64)).abs() < 1e-3, "{}", right[sample]);
            }
        }
    }

    #[test]
    fn it_swings_beyond_a_jump_by_what_its_damping_leaves() {
        let deflection = Deflection::late(&part(1e6), Delay::new(H, 0.0), H, 500);
        let jump = |sample: f64| if sample < 3.0 { 300.0 } else { 200.0 };
        let path = path(&deflection, jump, 200);
        let beyond = (200.0 - path.iter().copied().fold(f64::MAX, f64::min)) / 100.0;
        let expected = libm::exp(-std::f64::consts::PI * DAMPING / (1.0 - DAMPING * DAMPING).sqrt());
        assert!((beyond - expected).abs() < 2e-3, "{beyond}, {expected}");
        assert!((path[199] - 200.0).abs() < 1e-6);
    }

    #[test]
    fn a_part_that_is_off_is_off_by_its_share_of_the_delay() {
        let spread = Spread::new(4);
        let off = Deflection::<f64>::new(3e6, Some(&spread), H, 500);
        let figure = libm::exp(libm::log1p(0.04).sqrt() * spread.deviate("sweep-memory.deflection", 0));
        let expected = 0.8 * part(3e6).group_delay() / H * (1.0 / figure - 1.0);
        let path = path(&off, ramp, 400);
        assert!((path[300] - ramp(300.0) - expected).abs() < 3e-5, "{}", path[300] - ramp(300.0));
        assert!(expected.abs() > 0.01);
    }

    #[test]
    fn the_beam_stays_between_its_stops_whatever_it_is_told() {
        let deflection = Deflection::new(3e6, None, H, 100);
        for wild in [f64::NAN, f64::INFINITY, 1e30] {
            assert!(path(&deflection, |_| wild, 20).iter().all(|place| (place - 150.0).abs() < 1e-9));
        }
        assert!(path(&deflection, |_| f64::NEG_INFINITY, 20).iter().all(|place| (place + 50.0).abs() < 1e-9));
        let never = Deflection::new(1e-3, None, H, 100);
        assert!(path(&never, |sample| sample, 20).iter().all(|place| (0.0..1e-3).contains(place)));
    }
}
