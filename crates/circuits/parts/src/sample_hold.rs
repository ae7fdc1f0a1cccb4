//! Sample-and-hold of the projection processor (fig. 30).
//!
//! **Law** (sections 3.6 and 6). Tracking: a lag `t_acq / 6.9`, from the held value when it begins again. Holding from
//! a command at t: `y(t + a) = w(t - t_a) + V_p - D a`, w what is tracked, `t_a` the aperture delay with its jitter.
//! **Parameters.** [`SampleHoldLaw`].
//! **State and timing.** None of its own: the caller has the tracked signal and the level. [`SampleHold::taken_at`]
//! is the instant whose value is held, [`SampleHold::tracked`] that value within a step.

use quantities::SweepTime;
use signal::Real;

use crate::delay::in_steps;
use crate::lag::LagStep;
use crate::{Wire, settling_time_constant};

/// What a sample-and-hold is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleHoldLaw {
    /// Acquisition to 0.1 % (s).
    pub acquisition: f64,
    /// Aperture delay of the hold command (s).
    pub aperture: f64,
    /// Aperture jitter (s, one sigma).
    pub jitter: f64,
    /// Pedestal V_p (share of full scale).
    pub pedestal: f64,
    /// Droop D (full scales a second).
    pub droop: f64,
}

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleHold<S> {
    track: LagStep<S>,
    pedestal: S,
    /// Droop of one step.
    droop: S,
    /// Aperture delay in units of steps.
    aperture: f64,
    jitter: f64,
    h: f64,
    tau: f64,
}

impl<S: Real> SampleHold<S> {
    /// For steps of `h` seconds.
    pub fn new(h: f64, law: &SampleHoldLaw) -> Self {
        let tau = settling_time_constant(law.acquisition, 0.001);
        Self {
            track: LagStep::new(h, tau),
            pedestal: S::from_f64(law.pedestal),
            droop: S::from_f64(law.droop * h),
            aperture: in_steps(law.aperture, h),
            jitter: in_steps(law.jitter, h),
            h,
            tau,
        }
    }

    /// The tracked signal after a step of the input from `u0` to `u1`.
    #[inline(always)]
    pub fn track<V: Wire<S>>(&self, y: V, u0: V, u1: V) -> V {
        self.track.step(y, u0, u1)
    }

    /// The tracked signal at `share` (0..=1) of a step that begins with `y` and has the input from `u0` to `u1`.
    pub fn tracked(&self, y: S, u0: S, u1: S, share: f64) -> S {
        let there = u0 + (u1 - u0) * S::from_f64(share);
        LagStep::<S>::new(self.h * share, self.tau).step(y, u0, there)
    }

    /// The instant whose value a hold command at `command` takes; `deviate` is its jitter's.
    pub fn taken_at(&self, command: SweepTime, deviate: f64) -> SweepTime {
        SweepTime(command.0 - self.aperture + self.jitter * deviate)
    }

    /// The output `steps` after the command, holding the `tracked` value.
    #[inline(always)]
    pub fn held<V: Wire<S>>(&self, tracked: V, steps: V) -> V {
        tracked + self.pedestal - steps * self.droop
    }
}

#[cfg(test)]
mod tests {
    use quantities::SweepTime;

    use super::{SampleHold, SampleHoldLaw};

    /// 5 mV and 0.01 mV a microsecond of 10 V.
    const NOMINAL: SampleHoldLaw =
        SampleHoldLaw { acquisition: 400e-9, aperture: 20e-9, jitter: 1e-9, pedestal: 5e-4, droop: 1.0 };

    #[test]
    fn acquires_to_a_thousandth() {
        let part = SampleHold::<f64>::new(50e-9, &NOMINAL);
        let after = (0..8).fold(0.0, |y, _| part.track(y, 1.0, 1.0));
        assert!((1.0 - after - 0.001).abs() < 1e-12, "{after}");
    }

    #[test]
    fn within_a_step_as_at_its_ends() {
        let part = SampleHold::<f64>::new(50e-9, &NOMINAL);
        assert_eq!(part.tracked(0.2, 0.3, 0.5, 0.0), 0.2);
        assert_eq!(part.tracked(0.2, 0.3, 0.5, 1.0), part.track(0.2, 0.3, 0.5));
        let half = part.tracked(0.2, 0.3, 0.5, 0.5);
        let fine = SampleHold::<f64>::new(25e-9, &NOMINAL);
        assert!((fine.track(half, 0.4, 0.5) - part.track(0.2, 0.3, 0.5)).abs() < 1e-15);
    }

    #[test]
    fn holds_with_pedestal_and_droop() {
        let part = SampleHold::<f64>::new(50e-9, &NOMINAL);
        // 20 steps are 1 microsecond.
        assert!((part.held(0.4, 20.0) - (0.4 + 5e-4 - 1e-6)).abs() < 1e-15);
        assert!((part.taken_at(SweepTime(7.0), 0.0).0 - 6.6).abs() < 1e-12);
        assert!((part.taken_at(SweepTime(7.0), 2.0).0 - 6.64).abs() < 1e-12);
    }
}
