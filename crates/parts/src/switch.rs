//! Video switch: one of two inputs through, with a transition.
//!
//! ```text
//! C ─▶ ┐
//! S ─▶ ┴ cross-fade g, 0..=1 ─▶ out
//! ```
//!
//! **Law** (section 6). A toggle acts after the delay; then g runs in a straight line from 0 to 1, or back, over the
//! transition `t_vs`, from wherever it is. `out = (1 - g) (C + x S) + g ((1 + eg) S + ed + x C)`: eg and ed are the
//! mismatch of gain and level between the two ways, x is the share of the other input that gets through.
//! **Parameters.** [`SwitchLaw`]. -50 dB is `x = 0.0032`.
//! **State and timing.** g. Between toggles it is a straight line or stands ([`Switch::fade`]).
//! **Not modelled.** Crosstalk grows with frequency in a part; here it is the same share at all.

use quantities::SweepTime;
use signal::Real;

use crate::Wire;
use crate::delay::in_steps;

/// What a switch is.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SwitchLaw {
    /// From toggle to the start of the transition (s).
    pub delay: f64,
    /// Transition t_vs (s).
    pub transition: f64,
    /// eg: gain of S over that of C, less 1.
    pub gain_mismatch: f64,
    /// ed: level of S over that of C (share of full scale).
    pub level_mismatch: f64,
    /// x: share of the input that is off.
    pub crosstalk: f64,
}

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch<S> {
    /// In steps.
    delay: f64,
    /// Change of g in a step.
    rate: S,
    gain: S,
    level: S,
    crosstalk: S,
}

impl<S: Real> Switch<S> {
    /// For steps of `h` seconds.
    pub fn new(h: f64, law: &SwitchLaw) -> Self {
        let s = S::from_f64;
        Self {
            delay: in_steps(law.delay, h),
            rate: s(h / law.transition),
            gain: s(1.0 + law.gain_mismatch),
            level: s(law.level_mismatch),
            crosstalk: s(law.crosstalk),
        }
    }

    /// When a toggle at `toggle` begins to act.
    pub fn acts_at(&self, toggle: SweepTime) -> SweepTime {
        SweepTime(toggle.0 + self.delay)
    }

    /// g after `steps`, from `g`, towards S if `towards_s`, else towards C.
    #[inline]
    pub fn fade(&self, g: S, towards_s: bool, steps: S) -> S {
        // No time is no way, however fast the switch.
        let way = if steps > S::ZERO { self.rate * steps } else { S::ZERO };
        if towards_s { if g + way < S::ONE { g + way } else { S::ONE } } else { (g - way).at_least(S::ZERO) }
    }

    /// The output at `g` with the inputs `c` and `s`.
    #[inline(always)]
    pub fn output<V: Wire<S>>(&self, g: V, c: V, s: V) -> V {
        let leak = V::splat(self.crosstalk);
        let off = c + s * leak;
        let on = s * V::splat(self.gain) + V::splat(self.level) + c * leak;
        off + (on - off) * g
    }
}

#[cfg(test)]
mod tests {
    use quantities::SweepTime;

    use super::{Switch, SwitchLaw};

    const LAW: SwitchLaw = SwitchLaw {
        delay: 5e-9,
        transition: 20e-9,
        gain_mismatch: 0.01,
        level_mismatch: 0.02,
        crosstalk: 0.003,
    };

    #[test]
    fn fades_over_the_transition_and_turns_round_in_it() {
        let switch = Switch::<f64>::new(10e-9, &LAW);
        assert_eq!(switch.acts_at(SweepTime(2.0)), SweepTime(2.5));
        assert_eq!(switch.fade(0.0, true, 0.5), 0.25);
        assert_eq!(switch.fade(0.25, false, 0.25), 0.125);
        assert_eq!((switch.fade(0.3, true, 2.0), switch.fade(0.3, false, 2.0)), (1.0, 0.0));
    }

    #[test]
    fn both_ends_have_their_errors() {
        let switch = Switch::<f64>::new(10e-9, &LAW);
        assert!((switch.output(0.0, 0.4, 0.7) - (0.4 + 0.003 * 0.7)).abs() < 1e-15);
        assert!((switch.output(1.0, 0.4, 0.7) - (1.01 * 0.7 + 0.02 + 0.003 * 0.4)).abs() < 1e-15);
    }

    #[test]
    fn no_transition_is_a_jump_and_an_endless_one_never_moves() {
        let at_once = Switch::<f64>::new(10e-9, &SwitchLaw { transition: 0.0, ..LAW });
        assert_eq!((at_once.fade(0.0, true, 1e-9), at_once.fade(1.0, false, 1e-9)), (1.0, 0.0));
        assert_eq!((at_once.fade(0.0, true, 0.0), at_once.fade(1.0, false, 0.0)), (0.0, 1.0));
        let stuck = Switch::<f64>::new(10e-9, &SwitchLaw { transition: f64::INFINITY, ..LAW });
        assert_eq!(stuck.fade(0.5, true, 1e9), 0.5);
    }
}
