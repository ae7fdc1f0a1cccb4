//! Numbers of several places side by side, as many as a law takes at once.

use std::ops::{Add, Div, Mul, Neg, Sub};

use signal::{Number, Real};

/// `N` places of a run. Plain loops over an array, which the compiler turns into the widest vectors that its caller is compiled
/// for: quotients and roots of sixteen f32 take as long as those of eight where there is AVX-512.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Places<S, const N: usize>(pub [S; N]);

macro_rules! place_by_place {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<S: Real, const N: usize> $trait for Places<S, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let mut out = self;
                for n in 0..N {
                    out.0[n] = self.0[n] $op other.0[n];
                }
                out
            }
        }
    };
}

place_by_place!(Add, add, +);
place_by_place!(Sub, sub, -);
place_by_place!(Mul, mul, *);
place_by_place!(Div, div, /);

impl<S: Real, const N: usize> Neg for Places<S, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for n in 0..N {
            self.0[n] = -self.0[n];
        }
        self
    }
}

impl<S: Real, const N: usize> Number for Places<S, N> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self([S::from_f64(value); N])
    }
    #[inline(always)]
    fn root(mut self) -> Self {
        for n in 0..N {
            self.0[n] = self.0[n].root();
        }
        self
    }
    #[inline(always)]
    fn at_least(mut self, other: Self) -> Self {
        for n in 0..N {
            self.0[n] = self.0[n].at_least(other.0[n]);
        }
        self
    }
}
