//! What a part's step is generic over: the value on one wire, or on the same wire of a group of sweeps.

use std::ops::{Add, Mul, Sub};

use signal::{Lanes, Real};

/// A scalar of the run, or [`Lanes`] of it. Lane by lane the operations are the scalar's, so the bits are too.
pub trait Wire<S: Real>: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The same value everywhere.
    fn splat(value: S) -> Self;
    /// Each value through `f`.
    fn each(self, f: impl FnMut(S) -> S) -> Self;
}

impl<S: Real> Wire<S> for S {
    #[inline(always)]
    fn splat(value: S) -> Self {
        value
    }
    #[inline(always)]
    fn each(self, mut f: impl FnMut(S) -> S) -> Self {
        f(self)
    }
}

impl<S: Real> Wire<S> for Lanes<S> {
    #[inline(always)]
    fn splat(value: S) -> Self {
        Lanes::splat(value)
    }
    #[inline(always)]
    fn each(self, f: impl FnMut(S) -> S) -> Self {
        self.map(f)
    }
}
