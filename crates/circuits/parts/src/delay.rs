//! A delay against the sweep clock.
//!
//! **Law.** `y(t) = u(t - delay)`; `delay = (whole + share) h`. The whole steps are an index into the caller's buffer,
//! the share is where in a step a change of the input arrives.
//! **Source.** Section 6: delays of converters, comparators and switches.

use quantities::SweepTime;

/// A constant delay, in steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Delay {
    /// Number of whole steps.
    pub whole: usize,
    /// The rest, 0..1 of a step.
    pub share: f64,
}

impl Delay {
    /// `delay` and the step `h` in seconds. More than 2^32 steps, infinity too, are 2^32: later than any sweep ends.
    pub fn new(h: f64, delay: f64) -> Self {
        let steps = in_steps(delay, h).min(4_294_967_296.0);
        let whole = steps.floor();
        Self { whole: whole as usize, share: steps - whole }
    }

    /// When what happens at `instant` arrives.
    pub fn after(&self, instant: SweepTime) -> SweepTime {
        SweepTime(instant.0 + self.whole as f64 + self.share)
    }
}

/// `time / h`, where nothing takes no steps whatever the step.
pub(crate) fn in_steps(time: f64, h: f64) -> f64 {
    if time == 0.0 { 0.0 } else { time / h }
}

#[cfg(test)]
mod tests {
    use quantities::SweepTime;

    use super::Delay;

    #[test]
    fn whole_and_share() {
        let delay = Delay::new(50e-9, 80e-9);
        assert_eq!(delay.whole, 1);
        assert!((delay.share - 0.6).abs() < 1e-12);
        assert!((delay.after(SweepTime(3.5)).0 - 5.1).abs() < 1e-12);
    }

    #[test]
    fn none_and_endless() {
        assert_eq!(Delay::new(50e-9, 0.0), Delay { whole: 0, share: 0.0 });
        assert_eq!(Delay::new(50e-9, f64::INFINITY).whole, 1 << 32);
    }
}
