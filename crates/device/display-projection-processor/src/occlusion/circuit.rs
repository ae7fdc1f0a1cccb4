//! The occlusion circuits of one sweep, or of eight side by side in the computer's vectors: one text for both.

use signal::{Comparable, Truth};

/// The law by which the sample-and-hold of the projection processor finds what is hidden (section 15.2).
pub(crate) trait Circuit {
    /// What is held after a step: elevation before, held value before, elevation now.
    fn held<T: Comparable>(before: T, hold: T, now: T) -> T;
}

/// The hold follows the highest elevation so far.
pub(crate) struct PeakHold;

impl Circuit for PeakHold {
    #[inline(always)]
    fn held<T: Comparable>(_before: T, hold: T, now: T) -> T {
        now.at_least(hold)
    }
}

/// As reported: while unblanked the hold follows the elevation; a fall of it blanks and holds.
pub(crate) struct Derivative;

impl Circuit for Derivative {
    #[inline(always)]
    fn held<T: Comparable>(before: T, hold: T, now: T) -> T {
        let is_blanked = before.is_below(hold);
        let stays_blanked = now.is_below(is_blanked.choose(hold, before));
        stays_blanked.choose(hold, now)
    }
}

/// What the circuit of a sweep, or those of a group, remember.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Memory<T> {
    /// Elevation of the place before.
    pub below: T,
    /// What the circuit saw there: the same, or the top near it.
    pub before: T,
    /// Output of the sample-and-hold (tangent of the elevation): ground below it is hidden.
    pub hold: T,
}

impl<T: Copy> Memory<T> {
    /// Of one that has come to its first sample.
    #[inline(always)]
    pub fn new(first: T) -> Self {
        Self { below: first, before: first, hold: first }
    }
}

impl<T: Comparable> Memory<T> {
    /// The next sample, and the one after it; returns the part of the step at which the profile comes into sight.
    #[inline(always)]
    pub fn step<C: Circuit>(&mut self, now: T, after: T) -> T {
        let Self { below, before, hold } = *self;
        (self.below, self.before) = (now, now);
        let zero = now.like(0.0);
        if is_hidden([below, now, after], hold) {
            return zero;
        }
        // In sight before the sample and rising beyond it: no top, and nothing comes into sight.
        if (below.is_at_least(hold) & after.is_above(now)).is_everywhere() {
            self.hold = C::held(before, hold, now);
            return zero;
        }
        let top = top_of(below, now, after);
        self.before = top;
        self.hold = C::held(before, hold, top);
        entry_of(below, hold, now, top)
    }
}

/// Whether all lanes stay below the held elevation, tops between samples included: nothing changes, and a circuit that was or
/// is now below it is blanked. Most samples of a group are so, or climb, and need none of the quotients.
#[inline(always)]
fn is_hidden<T: Comparable>([below, now, after]: [T; 3], hold: T) -> bool {
    let zero = now.like(0.0);
    let (rise, fall) = ((now - below).at_least(zero), (now - after).at_least(zero));
    // A top is at most an eighth of rise and fall above its sample; twice that leaves rounding no say.
    (now + now.like(0.25) * (rise + fall)).is_below(hold).is_everywhere()
}

/// A fall to the next place by more than this (tangent) is taken for the end of the profile, not its shape.
const CLIFF: f64 = 0.25;

/// Whether a sample is the highest of three, given the rise to it and the fall behind it.
#[inline(always)]
pub(crate) fn has_top<T: Comparable>(rise: T, fall: T) -> T::Truth {
    let zero = rise.like(0.0);
    rise.is_above(zero) & fall.is_at_least(zero) & fall.is_below(rise.like(CLIFF))
}

/// What the circuit sees around a sample: its elevation, or the top of the parabola through it and its neighbours
/// where it is the highest of the three. The derivative changes sign there, between two samples.
#[inline(always)]
pub(crate) fn top_of<T: Comparable>(below: T, now: T, after: T) -> T {
    let (rise, fall) = (now - below, now - after);
    let skew = rise - fall;
    let top = now + skew * skew / (now.like(8.0) * (rise + fall));
    has_top(rise, fall).choose(top, now)
}

/// Where in a stretch the elevation rises through the held one; 1 if only the top beyond it does.
#[inline(always)]
pub(crate) fn entry_of<T: Comparable>(before: T, hold: T, now: T, top: T) -> T {
    let (zero, one) = (now.like(0.0), now.like(1.0));
    let share = (hold - before) / (now - before);
    let at_the_top = top.is_above(hold).choose(one, zero);
    before.is_below(hold).choose(now.is_above(hold).choose(share, at_the_top), zero)
}
