//! A function generator of the processor: bow and lag.

use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use parts::LagStep;
use signal::{Lanes, Real};

/// What is not ideal about a function generator; what is `None` is not there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Function<S> {
    /// Deviation in the middle of the field (share of full scale).
    pub bow: Option<S>,
    pub lag: Option<LagStep<S>>,
}

impl<S: Real> Function<S> {
    /// Passes a signal through it; `half` full scales about `middle` are the field. The lag is settled at the first
    /// sample.
    pub fn pass(&self, signal: &mut [Lanes<S>], middle: S, half: S) {
        dispatch!(Level::new(), simd => self.pass_wide(simd, signal, middle, half));
    }

    #[inline(always)]
    fn pass_wide<L: Simd>(&self, simd: L, signal: &mut [Lanes<S>], middle: S, half: S) {
        if let Some(bow) = self.bow {
            let (most, inverse) = (bow * half, S::ONE / half);
            for value in &mut *signal {
                let from = S::Vector::<L>::from_slice(simd, &value.0);
                (from + bowed::<L, S>(simd, (from - middle) * inverse) * most).store_slice(&mut value.0);
            }
        }
        if let Some(lag) = &self.lag {
            delay(simd, lag, signal);
        }
    }
}

/// `1 - u²` within the field, nothing outside.
#[inline(always)]
fn bowed<L: Simd, S: Real>(simd: L, share: S::Vector<L>) -> S::Vector<L> {
    let zero = S::Vector::<L>::simd_from(simd, S::ZERO);
    let inside = S::Vector::<L>::simd_from(simd, S::ONE) - share * share;
    inside.simd_gt(zero).select(inside, zero)
}

#[inline(always)]
fn delay<L: Simd, S: Real>(simd: L, lag: &LagStep<S>, signal: &mut [Lanes<S>]) {
    let Some(first) = signal.first() else { return };
    let mut before = S::Vector::<L>::from_slice(simd, &first.0);
    let mut out = before;
    for value in signal {
        let now = S::Vector::<L>::from_slice(simd, &value.0);
        out = lag.step(out, before, now);
        before = now;
        out.store_slice(&mut value.0);
    }
}
