//! The circuits of eight sweeps side by side, in the computer's vectors: lane by lane what [`top_of`](super::top_of),
//! [`entry_of`](super::entry_of) and the circuit of a lane do, to the bit.
//!
//! Vectors by name: of arrays that go round from sample to sample the compiler makes pieces, and joins them again in each.

use fearless_simd::Simd;
use fearless_simd::prelude::{Select, SimdBase, SimdMask};
use signal::{Lanes, Number, Real};

use super::{CLIFF, Circuit, Memory};

/// What the circuits remember on their way.
#[derive(Clone, Copy)]
pub(crate) struct Running<L: Simd, S: Real> {
    below: S::Vector<L>,
    before: S::Vector<L>,
    hold: S::Vector<L>,
}

impl<L: Simd, S: Real> Running<L, S> {
    /// Of a group that has come to its first sample.
    #[inline(always)]
    pub(crate) fn new(first: S::Vector<L>) -> Self {
        Self { below: first, before: first, hold: first }
    }

    /// Of a group that remembers.
    #[inline(always)]
    pub(super) fn resume(simd: L, Memory { below, before, hold }: &Memory<Lanes<S>>) -> Self {
        let [below, before, hold] =
            [below, before, hold].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
        Self { below, before, hold }
    }

    /// What is remembered.
    #[inline(always)]
    pub(super) fn rest(self) -> Memory<Lanes<S>> {
        let mut memory = Memory::new(Lanes::default());
        self.below.store_slice(&mut memory.below.0);
        self.before.store_slice(&mut memory.before.0);
        self.hold.store_slice(&mut memory.hold.0);
        memory
    }

    /// The held elevation.
    #[inline(always)]
    pub(crate) fn hold(&self) -> S::Vector<L> {
        self.hold
    }

    /// The next sample, and the one after it; returns the part of the step at which the profile comes into sight.
    #[inline(always)]
    pub(crate) fn step<C: Circuit>(&mut self, now: S::Vector<L>, after: S::Vector<L>) -> S::Vector<L> {
        let Self { below, before, hold } = *self;
        (self.below, self.before) = (now, now);
        let zero = now.like(0.0);
        if is_hidden::<L, S>([below, now, after], hold) {
            return zero;
        }
        // In sight before the sample and rising beyond it: no top, and nothing comes into sight.
        if (below.simd_ge(hold) & after.simd_gt(now)).all_true() {
            self.hold = C::of_group::<L, S>(before, hold, now);
            return zero;
        }
        let top = tops::<L, S>(below, now, after);
        self.before = top;
        self.hold = C::of_group::<L, S>(before, hold, top);
        entries::<L, S>(below, hold, now, top)
    }
}

/// Whether all lanes stay below the held elevation, tops between samples included: nothing changes, and a circuit that was or
/// is now below it is blanked. Most samples of a group are so, or climb, and need none of the quotients.
#[inline(always)]
fn is_hidden<L: Simd, S: Real>([below, now, after]: [S::Vector<L>; 3], hold: S::Vector<L>) -> bool {
    let zero = now.like(0.0);
    let (rise, fall) = ((now - below).at_least(zero), (now - after).at_least(zero));
    // A top is at most an eighth of rise and fall above its sample; twice that leaves rounding no say.
    (now + now.like(0.25) * (rise + fall)).simd_lt(hold).all_true()
}

/// [`top_of`](super::top_of) in each lane.
#[inline(always)]
fn tops<L: Simd, S: Real>(below: S::Vector<L>, now: S::Vector<L>, after: S::Vector<L>) -> S::Vector<L> {
    let (rise, fall, zero) = (now - below, now - after, now.like(0.0));
    let skew = rise - fall;
    let top = now + skew * skew / (now.like(8.0) * (rise + fall));
    (rise.simd_gt(zero) & fall.simd_ge(zero) & fall.simd_lt(now.like(CLIFF))).select(top, now)
}

/// [`entry_of`](super::entry_of) in each lane.
#[inline(always)]
fn entries<L: Simd, S: Real>(
    before: S::Vector<L>,
    hold: S::Vector<L>,
    now: S::Vector<L>,
    top: S::Vector<L>,
) -> S::Vector<L> {
    let (zero, one) = (now.like(0.0), now.like(1.0));
    let share = (hold - before) / (now - before);
    let at_the_top = top.simd_gt(hold).select(one, zero);
    before.simd_lt(hold).select(now.simd_gt(hold).select(share, at_the_top), zero)
}
