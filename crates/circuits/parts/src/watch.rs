//! Comparators of a group: which of them may do anything in a step, found for all of them at once.
//!
//! **Law.** None of its own: [`Comparator::step`] does nothing where both ends of a step keep off the threshold by as much as
//! noise can move it. A watch holds the inputs to a little less than that, in the scalar of the run; whoever it names is
//! to be stepped. It asks first how far noise may move thresholds at most, and where that is too far, how far it does.

use fearless_simd::Simd;
use fearless_simd::prelude::{SimdBase, SimdMask};
use signal::{LANES, Lanes, Real, eight};

use crate::{Comparator, ComparatorState, GroupNoise};

/// What is kept off thresholds beside noise: more than rounding (share of what is compared).
const MARGIN: f64 = 1e-6;

/// What the inputs of a group must keep between.
#[derive(Debug, Clone, Copy)]
pub struct Watch<S> {
    noise: GroupNoise,
    sigma: f64,
    least: Lanes<S>,
    most: Lanes<S>,
    /// Deviates of the two samples that were worked out last, and which two.
    deviates: [[f64; LANES]; 2],
    pair: u64,
}

impl<S: Real> Comparator<S> {
    /// A watch over this part in `sweeps`, none of which is looked at yet.
    pub fn watch(&self, sweeps: &[u64; LANES]) -> Watch<S> {
        let (sigma, noise) = self.noise();
        let [least, most] = [f64::NEG_INFINITY, f64::INFINITY].map(|bound| Lanes::splat(S::from_f64(bound)));
        let (deviates, pair) = ([[0.0; LANES]; 2], u64::MAX);
        Watch { noise: noise.of_sweeps(sweeps), sigma: sigma * (1.0 + MARGIN), least, most, deviates, pair }
    }
}

impl<S: Real> Watch<S> {
    /// From now on `lane` is looked at, its comparator being in `state`.
    pub fn look(&mut self, lane: usize, part: &Comparator<S>, state: &ComparatorState) {
        let [lower, upper] = part.thresholds();
        let off = |threshold: f64| MARGIN * threshold.abs();
        let [least, most] = match (state.passing, state.high) {
            // Between these is nothing.
            (Some(_), _) => [f64::INFINITY, f64::NEG_INFINITY],
            (None, true) => [lower + off(lower), f64::INFINITY],
            (None, false) => [f64::NEG_INFINITY, upper - off(upper)],
        };
        (self.least[lane], self.most[lane]) = (S::from_f64(least), S::from_f64(most));
    }

    /// From now on `lane` is not looked at.
    pub fn look_away(&mut self, lane: usize) {
        (self.least[lane], self.most[lane]) = (S::from_f64(f64::NEG_INFINITY), S::from_f64(f64::INFINITY));
    }

    /// The lanes, as bits, whose comparators may do anything in the step to `sample`, with their inputs at its ends.
    #[inline(always)]
    pub fn stirs<L: Simd>(&mut self, simd: L, sample: usize, u0: S::Vector<L>, u1: S::Vector<L>) -> u64 {
        let (mut below, mut above) = ([0.0; LANES], [0.0; LANES]);
        if self.sigma > 0.0 {
            let bounds = self.noise.bounds(sample as u64);
            for lane in 0..LANES {
                let reach = self.sigma * bounds[lane];
                below[lane] = if reach < 0.0 { reach } else { 0.0 };
                above[lane] = if reach > 0.0 { reach } else { 0.0 };
            }
        }
        let near = self.beyond(simd, [below, above], u0, u1);
        if near == 0 || self.sigma == 0.0 { near } else { near & self.surely(simd, sample, u0, u1) }
    }

    /// The deviate of a comparator's noise in the step to `sample`, which was named there.
    pub fn deviate(&self, lane: usize, sample: usize) -> f64 {
        self.deviates[sample % 2][lane]
    }

    /// The same by what noise does at the sample.
    #[inline(always)]
    fn surely<L: Simd>(&mut self, simd: L, sample: usize, u0: S::Vector<L>, u1: S::Vector<L>) -> u64 {
        if self.pair != sample as u64 / 2 {
            self.pair = sample as u64 / 2;
            self.deviates = self.noise.pair(self.pair);
        }
        let (mut below, mut above) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            // As much more where it moves towards the input as less where it moves away.
            let shift = self.sigma * self.deviates[sample % 2][lane];
            let away = shift * (1.0 - 2.0 * MARGIN);
            below[lane] = if shift < 0.0 { shift } else { away };
            above[lane] = if shift > 0.0 { shift } else { away };
        }
        self.beyond(simd, [below, above], u0, u1)
    }

    /// The lanes whose input does not keep off its threshold, which moves by `below` at the lowest and `above` at the highest.
    #[inline(always)]
    fn beyond<L: Simd>(
        &self,
        simd: L,
        [below, above]: [[f64; LANES]; 2],
        u0: S::Vector<L>,
        u1: S::Vector<L>,
    ) -> u64 {
        let [below, above] = [S::narrow(eight(simd, &below)), S::narrow(eight(simd, &above))];
        let least = S::Vector::<L>::from_slice(simd, &self.least.0) + above;
        let most = S::Vector::<L>::from_slice(simd, &self.most.0) + below;
        let quiet = u0.simd_gt(least) & u1.simd_gt(least) & u0.simd_lt(most) & u1.simd_lt(most);
        (!quiet).to_bitmask()
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::prelude::SimdBase;
    use fearless_simd::{Level, Simd, dispatch};
    use quantities::unit_interval;
    use signal::{LANES, Lanes, Real};

    use crate::{Comparator, ComparatorLaw, ComparatorState, NoiseSource, Watch};

    #[inline(always)]
    fn stirs<L: Simd, S: Real>(simd: L, watch: &mut Watch<S>, sample: usize, [u0, u1]: [Lanes<S>; 2]) -> u64 {
        let [u0, u1] = [u0, u1].map(|u| S::Vector::<L>::from_slice(simd, &u.0));
        watch.stirs(simd, sample, u0, u1)
    }

    /// Whoever is not named does nothing, of inputs that are mostly near a threshold, and few others are named.
    fn who_does_something_is_named<S: Real>(noise: f64) {
        let law = ComparatorLaw {
            offset: 2e-4,
            hysteresis: 1e-3,
            delay: 40e-9,
            overdrive: 1e-11,
            longest: 500e-9,
            noise,
        };
        let source = NoiseSource::new(5, "comparator", 0);
        let part = Comparator::<S>::new(50e-9, &law, source);
        let sweeps = std::array::from_fn(|lane| 70 + 3 * lane as u64);
        let mut watch = part.watch(&sweeps);
        let mut states = [ComparatorState::default(); LANES];
        let input = |sample: usize| {
            let drawn = |lane: usize, what: u64| unit_interval(9, &[sample as u64, lane as u64, what]);
            Lanes::from_fn(|lane| S::from_f64(3e-3 * (drawn(lane, 0) - 0.5) * drawn(lane, 1)))
        };
        let (mut named, mut needless, mut trips) = (0, 0, Vec::new());
        for sample in 1..4000 {
            let ends = [input(sample - 1), input(sample)];
            (0..LANES).for_each(|lane| watch.look(lane, &part, &states[lane]));
            watch.look_away(3);
            let who = dispatch!(Level::new(), simd => stirs(simd, &mut watch, sample, ends));
            assert_eq!(who >> 3 & 1, 0);
            named += who.count_ones();
            for lane in 0..LANES {
                let (before, count) = (states[lane], trips.len());
                let address = (sweeps[lane], sample);
                part.step(&mut states[lane], address, ends[0][lane], ends[1][lane], &mut trips);
                let did = states[lane] != before || trips.len() > count;
                let is_named = who >> lane & 1 == 1;
                assert!(!did || is_named || lane == 3, "{sample}, {lane}");
                let deviate = source.normal(sweeps[lane], sample as u64);
                let shift = noise * deviate;
                assert!(!is_named || noise == 0.0 || watch.deviate(lane, sample) == deviate);
                let ends = ends.map(|end| end[lane].to_f64() - shift);
                let [lower, upper] = part.thresholds();
                let keeps_off = match (before.passing, before.high) {
                    (Some(_), _) => false,
                    (None, true) => ends[0].min(ends[1]) > lower,
                    (None, false) => ends[0].max(ends[1]) < upper,
                };
                needless += u32::from(is_named && keeps_off);
            }
        }
        assert!((3000..20_000).contains(&named) && needless < 20, "{named}, {needless} needlessly");
    }

    #[test]
    fn who_does_something_is_named_with_and_without_noise() {
        for noise in [0.0, 3e-4] {
            who_does_something_is_named::<f32>(noise);
            who_does_something_is_named::<f64>(noise);
        }
    }
}
