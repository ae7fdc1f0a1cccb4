//! A function generator of the processor: bow and lag.

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
        if let Some(bow) = self.bow {
            let (most, inverse) = (bow * half, S::ONE / half);
            signal
                .iter_mut()
                .for_each(|value| *value = value.map(|u| bowed(u, most, (u - middle) * inverse)));
        }
        if let Some(lag) = &self.lag {
            delay(lag, signal);
        }
    }
}

/// `e (1 - u²)` within the field, nothing outside.
fn bowed<S: Real>(value: S, most: S, share: S) -> S {
    value + most * (S::ONE - share * share).at_least(S::ZERO)
}

fn delay<S: Real>(lag: &LagStep<S>, signal: &mut [Lanes<S>]) {
    let Some(&first) = signal.first() else { return };
    let (mut before, mut out) = (first, first);
    for value in signal {
        out = lag.step(out, before, *value);
        before = *value;
        *value = out;
    }
}
