//! Comparators of a group: which of them may do anything in a step, found for all of them at once.
//!
//! **Law.** None of its own: [`Comparator::step`] does nothing where both ends of a step keep off the threshold by as much as
//! noise can move it. A watch holds the inputs to a little less than that, in the scalar of the run; whoever it names is
//! to be stepped.

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
}

impl<S: Real> Comparator<S> {
    /// A watch over this part in `sweeps`, none of which is looked at yet.
    pub fn watch(&self, sweeps: &[u64; LANES]) -> Watch<S> {
        let (sigma, noise) = self.noise();
        let [least, most] = [f64::NEG_INFINITY, f64::INFINITY].map(|bound| Lanes::splat(S::from_f64(bound)));
        Watch { noise: noise.of_sweeps(sweeps), sigma: sigma * (1.0 + MARGIN), least, most }
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
    pub fn stirs<L: Simd>(&self, simd: L, sample: usize, u0: S::Vector<L>, u1: S::Vector<L>) -> u64 {
        let (mut below, mut above) = ([0.0; LANES], [0.0; LANES]);
        if self.sigma > 0.0 {
            let bounds = self.noise.bounds(sample as u64);
            for lane in 0..LANES {
                let reach = self.sigma * bounds[lane];
                below[lane] = if reach < 0.0 { reach } else { 0.0 };
                above[lane] = if reach > 0.0 { reach } else { 0.0 };
            }
        }
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
    fn stirs<L: Simd, S: Real>(simd: L, watch: &Watch<S>, sample: usize, [u0, u1]: [Lanes<S>; 2]) -> u64 {
        let [u0, u1] = [u0, u1].map(|u| S::Vector::<L>::from_slice(simd, &u.0));
        watch.stirs(simd, sample, u0, u1)
    }

    /// Whoever is not named does nothing, of inputs that are mostly near a threshold.
    fn who_is_not_named_does_nothing<S: Real>(noise: f64) {
        let law = ComparatorLaw {
            offset: 2e-4,
            hysteresis: 1e-3,
            delay: 40e-9,
            overdrive: 1e-11,
            longest: 500e-9,
            noise,
        };
        let part = Comparator::<S>::new(50e-9, &law, NoiseSource::new(5, "comparator", 0));
        let sweeps = std::array::from_fn(|lane| 70 + 3 * lane as u64);
        let mut watch = part.watch(&sweeps);
        let mut states = [ComparatorState::default(); LANES];
        let input = |sample: usize| {
            let drawn = |lane: usize, what: u64| unit_interval(9, &[sample as u64, lane as u64, what]);
            Lanes::from_fn(|lane| S::from_f64(3e-3 * (drawn(lane, 0) - 0.5) * drawn(lane, 1)))
        };
        let (mut named, mut trips) = (0, Vec::new());
        for sample in 1..4000 {
            let ends = [input(sample - 1), input(sample)];
            (0..LANES).for_each(|lane| watch.look(lane, &part, &states[lane]));
            watch.look_away(3);
            let who = dispatch!(Level::new(), simd => stirs(simd, &watch, sample, ends));
            assert_eq!(who >> 3 & 1, 0);
            named += who.count_ones();
            for lane in 0..LANES {
                let (before, count) = (states[lane], trips.len());
                let address = (sweeps[lane], sample);
                part.step(&mut states[lane], address, ends[0][lane], ends[1][lane], &mut trips);
                let did = states[lane] != before || trips.len() > count;
                assert!(!did || who >> lane & 1 == 1 || lane == 3, "{sample}, {lane}");
            }
        }
        assert!((5000..20_000).contains(&named), "{named}");
    }

    #[test]
    fn who_is_not_named_does_nothing_with_and_without_noise() {
        for noise in [0.0, 3e-4] {
            who_is_not_named_does_nothing::<f32>(noise);
            who_is_not_named_does_nothing::<f64>(noise);
        }
    }
}
