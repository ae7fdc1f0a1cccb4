//! Video switch: one of two inputs through.
//!
//! ```text
//! C ─▶ ┐
//! S ─▶ ┴ cross-fade g, 0..=1 ─▶ out
//! ```
//!
//! **Law** (section 6). `out = (1 - g) C + g ((1 + eg) S + ed)`: eg and ed are the mismatch of gain and level between the
//! two ways. g is a [`crate::Fade`]; what gets through of the input that is off is its [`crate::HighPass`], by the
//! share that it is off ([`Switch::leak`]).
//! **Parameters.** [`SwitchLaw`], shares of full scale. -50 dB is a share of 0.0032.
//! **State and timing.** None.

use signal::Real;

use crate::Wire;

/// What a switch is.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SwitchLaw {
    /// eg: gain of S over that of C, less 1.
    pub gain_mismatch: f64,
    /// ed: level of S over that of C (share of full scale).
    pub level_mismatch: f64,
}

/// The video switch with its static errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch<S> {
    gain: S,
    level: S,
}

impl<S: Real> Switch<S> {
    /// In the scalar of the run.
    pub fn new(law: &SwitchLaw) -> Self {
        Self { gain: S::from_f64(1.0 + law.gain_mismatch), level: S::from_f64(law.level_mismatch) }
    }

    /// The output at `g` with the inputs `c` and `s`.
    #[inline(always)]
    pub fn output<V: Wire<S>>(&self, g: V, c: V, s: V) -> V {
        let on = s * self.gain + self.level;
        c + (on - c) * g
    }

    /// What comes through of the inputs that are off, from the crosstalk of either.
    #[inline(always)]
    pub fn leak<V: Wire<S>>(g: V, of_c: V, of_s: V) -> V {
        of_s + (of_c - of_s) * g
    }
}

#[cfg(test)]
mod tests {
    use super::{Switch, SwitchLaw};

    #[test]
    fn both_ends_have_their_errors() {
        let switch = Switch::<f64>::new(&SwitchLaw { gain_mismatch: 0.01, level_mismatch: 0.02 });
        assert_eq!(switch.output(0.0, 0.4, 0.7), 0.4);
        assert!((switch.output(1.0, 0.4, 0.7) - (1.01 * 0.7 + 0.02)).abs() < 1e-15);
        assert!((switch.output(0.5, 0.4, 0.7) - 0.5 * (0.4 + 1.01 * 0.7 + 0.02)).abs() < 1e-15);
    }

    #[test]
    fn what_is_off_leaks() {
        assert_eq!([0.0, 1.0].map(|g| Switch::<f64>::leak(g, 0.003, 0.005)), [0.005, 0.003]);
    }
}
