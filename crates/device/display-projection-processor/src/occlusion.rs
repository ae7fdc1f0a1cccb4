//! The two occlusion circuits (section 15.2), stepped from sample to sample and, where a profile bends between two
//! samples, over its bends.

mod circuit;

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use signal::{Breaks, LANES, Lanes, Number, Real};

pub(crate) use self::circuit::{Circuit, Derivative, Memory, PeakHold};
use self::circuit::{entry_of, has_top, top_of};
use crate::Projected;

/// What lies between the samples of a group.
#[derive(Debug, Clone, Copy)]
pub struct BrokenProfile<'a, S> {
    /// Breaks lane by lane; each `sample` is at least 1 and below the number of samples.
    pub breaks: &'a Breaks<S>,
    /// Which of them bend the profile.
    pub bends: &'a [Vec<bool>; LANES],
}

/// Runs a circuit along a group: side by side where no profile bends, lane by lane around a bend.
#[inline(always)]
pub(crate) fn occlude<L: Simd, S: Real, C: Circuit>(
    simd: L,
    out: &mut Projected<S>,
    broken: BrokenProfile<'_, S>,
) {
    let Some(&first) = out.elevation.first() else { return };
    let mut memory = Memory::new(first);
    let samples = out.elevation.len();
    let mut passed = [0; LANES];
    let mut sample = 0;
    while sample < samples {
        // The sample before a bend is next to it: its top is not that of a parabola across the bend.
        let bent = broken.next_bend(&mut passed).map_or(samples, |bend| sample.max(bend - 1));
        smooth::<L, S, C>(simd, out, sample..bent, &mut memory);
        if bent < samples {
            for (lane, passed) in passed.iter_mut().enumerate() {
                Lane { broken, lane, passed }.step::<C>(out, bent, &mut memory);
            }
        }
        sample = bent + 1;
    }
    broken.hold_at_smooth_breaks(out);
}

#[inline(always)]
fn smooth<L: Simd, S: Real, C: Circuit>(
    simd: L,
    out: &mut Projected<S>,
    samples: Range<usize>,
    memory: &mut Memory<Lanes<S>>,
) {
    let Projected { elevation, hold, entry, .. } = out;
    let mut running = memory.in_vectors(simd);
    for sample in samples {
        let now = S::Vector::<L>::from_slice(simd, &elevation[sample].0);
        let after = elevation.get(sample + 1);
        let after = after.map_or(now.like(BEYOND), |after| S::Vector::<L>::from_slice(simd, &after.0));
        running.step::<C>(now, after).store_slice(&mut entry[sample].0);
        running.hold.store_slice(&mut hold[sample].0);
    }
    *memory = Memory::of_vectors::<L>(running);
}

/// Beyond the last sample the profile is taken to rise: no top there.
pub(crate) const BEYOND: f64 = f64::INFINITY;

/// Whether something is so in all lanes. A plain loop: an iterator's would be called, and lose the vectors of its caller.
#[inline(always)]
pub(crate) fn all(is_so: impl Fn(usize) -> bool) -> bool {
    let mut all = true;
    for lane in 0..LANES {
        all &= is_so(lane);
    }
    all
}

impl<S: Real> Memory<Lanes<S>> {
    /// The same in the computer's vectors. Arrays that are carried from sample to sample the compiler cuts into pieces and joins
    /// again at each sample.
    #[inline(always)]
    fn in_vectors<L: Simd>(&self, simd: L) -> Memory<S::Vector<L>> {
        let Self { below, before, hold } = self;
        let [below, before, hold] =
            [below, before, hold].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
        Memory { below, before, hold }
    }

    /// The same as lanes again.
    #[inline(always)]
    fn of_vectors<L: Simd>(memory: Memory<S::Vector<L>>) -> Self {
        let mut lanes = Memory::new(Lanes::default());
        memory.below.store_slice(&mut lanes.below.0);
        memory.before.store_slice(&mut lanes.before.0);
        memory.hold.store_slice(&mut lanes.hold.0);
        lanes
    }
}

impl<S: Real> BrokenProfile<'_, S> {
    /// Step of the nearest bend of any lane among those not `passed`, which then stand at bends.
    fn next_bend(&self, passed: &mut [usize; LANES]) -> Option<usize> {
        let nearest = |(lane, passed): (usize, &mut usize)| {
            *passed += self.bends[lane][*passed..].iter().take_while(|&&bend| !bend).count();
            self.breaks[lane].get(*passed).map(|bend| bend.sample)
        };
        passed.iter_mut().enumerate().filter_map(nearest).min()
    }

    /// Breaks that do not bend the profile leave the hold as it was before them.
    fn hold_at_smooth_breaks(&self, out: &mut Projected<S>) {
        for lane in 0..LANES {
            let holds = &mut out.breaks.hold[lane];
            let (mut step, mut held) = (0, S::ZERO);
            for ((place, &bend), hold) in self.breaks[lane].iter().zip(&self.bends[lane]).zip(holds) {
                if place.sample != step {
                    (step, held) = (place.sample, out.hold[place.sample - 1][lane]);
                }
                held = if bend { *hold } else { held };
                *hold = held;
            }
        }
    }
}

/// One lane next to a bend.
struct Lane<'a, S> {
    broken: BrokenProfile<'a, S>,
    lane: usize,
    /// Breaks of the lane that lie behind.
    passed: &'a mut usize,
}

impl<S: Real> Lane<'_, S> {
    /// The step to `sample`: over its bends, then to the sample.
    fn step<C: Circuit>(&mut self, out: &mut Projected<S>, sample: usize, memory: &mut Memory<Lanes<S>>) {
        let lane = self.lane;
        let mut own =
            Memory { below: memory.below[lane], before: memory.before[lane], hold: memory.hold[lane] };
        let (mut from, mut entry) = (S::ZERO, S::ZERO);
        while let Some((index, share)) = self.bend_in(sample) {
            let bend = out.breaks.elevation[lane][index];
            entry = later(entry, from, share, entry_of(own.below, own.hold, bend, bend));
            let hold = C::held(own.before, own.hold, bend);
            out.breaks.hold[lane][index] = hold;
            own = Memory { below: bend, before: bend, hold };
            from = share;
            *self.passed = index + 1;
        }
        let now = out.elevation[sample][lane];
        let top = self.top(out, sample, own.below, from);
        out.entry[sample][lane] = later(entry, from, S::ONE, entry_of(own.below, own.hold, now, top));
        let hold = C::held(own.before, own.hold, top);
        out.hold[sample][lane] = hold;
        (memory.below[lane], memory.before[lane], memory.hold[lane]) = (now, top, hold);
    }

    /// The next bend, if it lies in the step to `sample`: its index and share.
    fn bend_in(&self, sample: usize) -> Option<(usize, S)> {
        let ahead = self.broken.breaks[self.lane].iter().zip(&self.broken.bends[self.lane]).enumerate();
        let (index, (place, _)) = ahead.skip(*self.passed).find(|(_, (_, bend))| **bend)?;
        (place.sample == sample).then_some((index, place.share))
    }

    /// What the circuit sees around `sample`, where the profile comes from `below` at share `from` of the step.
    fn top(&self, out: &Projected<S>, sample: usize, below: S, from: S) -> S {
        let now = out.elevation[sample][self.lane];
        let infinity = S::from_f64(f64::INFINITY);
        match self.bend_in(sample + 1) {
            Some((index, reach)) => {
                top_between([below, now, out.breaks.elevation[self.lane][index]], S::ONE - from, reach)
            }
            None => {
                let after = out.elevation.get(sample + 1).map_or(infinity, |after| after[self.lane]);
                let even = from == S::ZERO;
                if even {
                    top_of(below, now, after)
                } else {
                    top_between([below, now, after], S::ONE - from, S::ONE)
                }
            }
        }
    }
}

/// The share of a step at which a profile comes into sight, given that of a stretch of it; the latest counts.
fn later<S: Real>(entry: S, from: S, to: S, in_stretch: S) -> S {
    if in_stretch > S::ZERO { from + (to - from) * in_stretch } else { entry }
}

/// A bend nearer to a sample than this part of a step says nothing of the curve around the sample.
const NEAREST: f64 = 0.125;

/// The same where a neighbour is a bend, `back` and `ahead` of the sample in steps: up to the bend the profile is smooth.
fn top_between<S: Real>([below, now, after]: [S; 3], back: S, ahead: S) -> S {
    let (rise, fall) = (now - below, now - after);
    let nearest = S::from_f64(NEAREST);
    let near = back < nearest || ahead < nearest;
    if near || !has_top(rise, fall) {
        return now;
    }
    let (climb, descent) = (rise / back, fall / ahead);
    let slope = climb * ahead - descent * back;
    now + slope * slope / (S::from_f64(4.0) * (back + ahead) * (climb + descent))
}

#[cfg(test)]
mod tests {
    use fearless_simd::Level;
    use proptest::prelude::{any, prop_assert_eq, proptest};
    use scenario::{Curvature, Occlusion, Projection};
    use signal::{LANES, Lanes, Real};

    use super::{Circuit, Derivative, PeakHold, entry_of, top_of};
    use crate::{Deflection, Processor, Projected};

    /// Elevation, hold, entry, position and line of one lane, sample by sample with nothing cut short.
    fn plainly<S: Real>(elevation: &[S], occlusion: Occlusion, deflection: &Deflection) -> Vec<[S; 5]> {
        let [mut below, mut before, mut hold] = [elevation[0]; 3];
        let [a, b, c, e] = [deflection.a, deflection.b, deflection.c, deflection.e].map(S::from_f64);
        let line = |tangent: S| (a - b * tangent) / (c + e * tangent);
        let step = |k: usize| {
            let infinity = S::from_f64(f64::INFINITY);
            let (now, after) = (elevation[k], elevation.get(k + 1).copied().unwrap_or(infinity));
            let top = top_of(below, now, after);
            let entry = entry_of(below, hold, now, top);
            hold = match occlusion {
                Occlusion::PeakHold => PeakHold::held(before, hold, top),
                Occlusion::Derivative => Derivative::held(before, hold, top),
            };
            (below, before) = (now, top);
            [now, hold, entry, line(now), line(hold)]
        };
        (0..elevation.len()).map(step).collect()
    }

    /// The processor by the vectors of this computer and by those that all have, against every lane by itself.
    fn check<S: Real>(
        tangents: &[Lanes<f64>],
        occlusion: Occlusion,
    ) -> Result<(), proptest::test_runner::TestCaseError> {
        // A metre before the eye a height is its tangent.
        let mut processor = Processor::<S>::new(occlusion, Curvature::None, &vec![1.0; tangents.len()]);
        let height: Vec<Lanes<S>> =
            tangents.iter().map(|sample| Lanes::from_fn(|lane| S::from_f64(sample[lane]))).collect();
        let deflection = std::array::from_fn(|lane| {
            Deflection::new(Projection::Exact, 0.1, 0.05 * lane as f64).in_lines(575.0, 0.268)
        });
        for vectors in [Level::new(), Level::baseline()] {
            processor.vectors = vectors;
            let mut out = Projected::default();
            processor.run(&height, &deflection, &mut out);
            for lane in 0..LANES {
                let alone: Vec<S> = height.iter().map(|sample| sample[lane]).collect();
                for (sample, plain) in plainly(&alone, occlusion, &deflection[lane]).into_iter().enumerate() {
                    let signals = [&out.elevation, &out.hold, &out.entry, &out.position, &out.line];
                    let together = signals.map(|signal| signal[sample][lane].to_f64().to_bits());
                    prop_assert_eq!(
                        together,
                        plain.map(|value| value.to_f64().to_bits()),
                        "{} {}",
                        sample,
                        lane
                    );
                }
            }
        }
        Ok(())
    }

    proptest! {
        /// Neighbouring profiles that climb, fall, stand still and hide one another, in coarse steps so that they also touch.
        #[test]
        fn what_is_plain_at_a_glance_changes_no_bit(
            steps in proptest::collection::vec((-6..7i8, any::<[i8; LANES]>()), 1..60),
            coarse in any::<bool>(),
        ) {
            let grain = if coarse { 0.5 } else { 0.003 };
            let mut sum = 0.0;
            let sample = |(step, own): &(i8, [i8; LANES])| {
                sum += f64::from(*step) * 0.02;
                Lanes::from_fn(|lane| sum + grain * f64::from(own[lane] / 32) * 0.01)
            };
            let tangents: Vec<Lanes<f64>> = steps.iter().map(sample).collect();
            for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
                check::<f32>(&tangents, occlusion)?;
                check::<f64>(&tangents, occlusion)?;
            }
        }
    }
}
