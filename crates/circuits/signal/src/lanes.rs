//! One sample of [`LANES`] sweeps that run side by side.

use std::array;
use std::ops::{Add, Div, Index, IndexMut, Mul, Sub};

use crate::Real;

/// Sweeps in a group.
pub const LANES: usize = 8;

/// One sample of a group of sweeps; lane n is sweep n of the group.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Lanes<S>(pub [S; LANES]);

impl<S: Real> Lanes<S> {
    /// The same value in every lane.
    #[inline(always)]
    pub fn splat(value: S) -> Self {
        Self([value; LANES])
    }

    /// Each lane from its number.
    #[inline(always)]
    pub fn from_fn(value: impl FnMut(usize) -> S) -> Self {
        Self(array::from_fn(value))
    }

    /// Each lane's value through `f`.
    #[inline(always)]
    pub fn map(self, f: impl FnMut(S) -> S) -> Self {
        Self(self.0.map(f))
    }

    /// Square root lane by lane.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        self.map(S::root)
    }
}

impl<S: Real> Default for Lanes<S> {
    fn default() -> Self {
        Self::splat(S::ZERO)
    }
}

impl<S> Index<usize> for Lanes<S> {
    type Output = S;
    fn index(&self, lane: usize) -> &S {
        &self.0[lane]
    }
}

impl<S> IndexMut<usize> for Lanes<S> {
    fn index_mut(&mut self, lane: usize) -> &mut S {
        &mut self.0[lane]
    }
}

macro_rules! lane_by_lane {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<S: Real> $trait for Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // A loop, and no closure: that would be compiled without the width of vectors of whoever asks.
                let mut out = self;
                for lane in 0..LANES {
                    out.0[lane] = self.0[lane] $op other.0[lane];
                }
                out
            }
        }
    };
}

macro_rules! by_the_same {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<S: Real> $trait<S> for Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: S) -> Self {
                self $op Self::splat(other)
            }
        }
    };
}

by_the_same!(Add, add, +);
by_the_same!(Mul, mul, *);
lane_by_lane!(Add, add, +);
lane_by_lane!(Sub, sub, -);
lane_by_lane!(Mul, mul, *);
lane_by_lane!(Div, div, /);
