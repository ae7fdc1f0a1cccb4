//! Clocks as exact rationals of one another; no float accumulates time.

use std::fmt;

/// Ticks of the master clock since the start of the mission.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Tick(pub u64);

/// A real instant inside one sweep, in accumulator steps: sample n is at n, the eye's foot at -1.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct SweepTime(pub f64);

impl SweepTime {
    /// Index of the first sample at or after this instant.
    #[inline]
    pub fn sample_at_or_after(self) -> usize {
        // The cast truncates.
        let whole = (self.0 as i64).max(0);
        whole as usize + usize::from((whole as f64) < self.0)
    }
}

/// A rate in hertz as an exact fraction, lowest terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rate {
    numerator: u64,
    denominator: u64,
}

impl Rate {
    /// `numerator / denominator` hertz; `None` if either is zero.
    pub fn new(numerator: u64, denominator: u64) -> Option<Self> {
        if numerator == 0 || denominator == 0 {
            return None;
        }
        let common = gcd(numerator, denominator);
        Some(Self { numerator: numerator / common, denominator: denominator / common })
    }

    /// Hertz as the nearest float, for people and plots.
    pub fn hertz(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }

    /// Numerator and denominator, in lowest terms.
    pub fn fraction(self) -> [u64; 2] {
        [self.numerator, self.denominator]
    }

    /// `self * factor`; `None` on overflow.
    pub fn times(self, factor: u64) -> Option<Self> {
        Self::new(self.numerator.checked_mul(factor)?, self.denominator)
    }

    /// `self / other` if that is a whole number.
    pub fn whole_ratio(self, other: Rate) -> Option<u64> {
        let numerator = u128::from(self.numerator) * u128::from(other.denominator);
        let denominator = u128::from(self.denominator) * u128::from(other.numerator);
        (numerator % denominator == 0).then_some((numerator / denominator) as u64)
    }

    /// Length of a period in whole ticks of a clock of so many hertz, at least 1.
    pub fn period_ticks(self, hertz: u64) -> u64 {
        let ticks = u128::from(hertz) * u128::from(self.denominator) / u128::from(self.numerator);
        u64::try_from(ticks).unwrap_or(u64::MAX).max(1)
    }

    /// Periods of this clock in `count` periods of another: whole part and fraction.
    fn periods_in(self, count: u64, of: Rate) -> (u64, f64) {
        let numerator = u128::from(count) * u128::from(self.numerator) * u128::from(of.denominator);
        let denominator = u128::from(self.denominator) * u128::from(of.numerator);
        let whole = (numerator / denominator) as u64;
        (whole, (numerator % denominator) as f64 / denominator as f64)
    }
}

impl fmt::Display for Rate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => write!(f, "{} Hz", self.numerator),
            denominator => write!(f, "{}/{} Hz", self.numerator, denominator),
        }
    }
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The clocks of one machine: master clock, accumulator (sample) clock, sweep and frame, all exact.
///
/// A sweep is a whole number of accumulator steps, a frame a whole number of sweeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Timebase {
    /// Master clock of the digital side.
    pub master: Rate,
    /// Pictures computed a second.
    pub update: Rate,
    /// Number of sweeps a frame.
    pub sweeps: u32,
    /// Accumulator steps that are drawn in one sweep.
    pub active_samples: u32,
    /// Accumulator steps of retrace in one sweep.
    pub retrace_samples: u32,
    sample: Rate,
}

/// The clocks do not fit in 64 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimebaseError;

impl fmt::Display for TimebaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("sweeps x samples x update rate: expected a product below 2^63 Hz; lower one of them")
    }
}

impl std::error::Error for TimebaseError {}

impl Timebase {
    /// The clocks of a raster of `sweeps` sweeps, each of `active_samples` drawn and `retrace_samples` blanked
    /// accumulator steps, computed `update` times a second.
    ///
    /// # Errors
    /// If the sample rate does not fit in 64 bits.
    pub fn new(
        master: Rate,
        update: Rate,
        sweeps: u32,
        active_samples: u32,
        retrace_samples: u32,
    ) -> Result<Self, TimebaseError> {
        let steps = u64::from(sweeps) * (u64::from(active_samples) + u64::from(retrace_samples));
        let sample = update.times(steps).ok_or(TimebaseError)?;
        Ok(Self { master, update, sweeps, active_samples, retrace_samples, sample })
    }

    /// The same clocks with `count` steps in each accumulator step, for what is told between samples. The last step that is drawn
    /// is the last sample.
    ///
    /// # Errors
    /// If the sample rate does not fit in 64 bits, or a sweep has more steps than 32 bits count.
    pub fn divided(&self, count: u32) -> Result<Self, TimebaseError> {
        let all = self.sweep_samples().checked_mul(count).ok_or(TimebaseError)?;
        let drawn = self.active_samples.saturating_sub(1) * count + self.active_samples.min(1);
        Self::new(self.master, self.update, self.sweeps, drawn, all - drawn)
    }

    /// Accumulator steps a second.
    pub fn sample_rate(&self) -> Rate {
        self.sample
    }

    /// Accumulator steps of one sweep, retrace included.
    pub fn sweep_samples(&self) -> u32 {
        self.active_samples + self.retrace_samples
    }

    /// Master ticks in one accumulator step, as a float for latencies inside one sweep.
    pub fn ticks_per_sample(&self) -> f64 {
        self.master.hertz() / self.sample.hertz()
    }

    /// The master clock as one sweep sees it.
    pub fn sweep_clock(&self, frame: u64, sweep: u32) -> SweepClock {
        let (whole, rest) = self.master.periods_in(self.first_step(frame, sweep), self.sample);
        SweepClock { whole, rest, ticks_per_sample: self.ticks_per_sample() }
    }

    fn first_step(&self, frame: u64, sweep: u32) -> u64 {
        (frame * u64::from(self.sweeps) + u64::from(sweep)) * u64::from(self.sweep_samples())
    }
}

/// The master clock as one sweep sees it: the first sample falls `rest` of a tick after tick `whole`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepClock {
    whole: u64,
    rest: f64,
    ticks_per_sample: f64,
}

/// Steps by which a tick and a step may differ and are one instant: ticks and steps are whole counts of two exact rates, and
/// what does not fall together is farther apart.
const SAME_INSTANT: f64 = 1e-9;

impl SweepClock {
    /// The first tick at or after `time`: when the digital side sees it.
    #[inline]
    pub fn tick_at_or_after(&self, time: SweepTime) -> Tick {
        // Folds before the first sample have negative instants. The cast truncates towards 0.
        let ticks = self.rest + time.0 * self.ticks_per_sample;
        let whole = ticks as i64;
        let after = if (whole as f64) < ticks { whole.saturating_add(1) } else { whole };
        Tick(self.whole.saturating_add_signed(after))
    }

    /// When `tick` falls; negative before the first sample.
    #[inline]
    pub fn instant_of(&self, tick: Tick) -> SweepTime {
        // The difference of two counts either way, each below 2^63.
        let ticks = tick.0.wrapping_sub(self.whole) as i64 as f64;
        let steps = (ticks - self.rest) / self.ticks_per_sample;
        // Rounding must not put what falls on a step behind it, where the next one sees it first.
        let nearest = (steps + 0.5) as i64 as f64;
        SweepTime(if (steps - nearest).abs() < SAME_INSTANT { nearest } else { steps })
    }
}

#[cfg(test)]
mod tests {
    use super::{Rate, SweepTime, Tick, Timebase};

    fn nominal() -> Timebase {
        let master = Rate::new(20_000_000, 1).unwrap();
        Timebase::new(master, Rate::new(30, 1).unwrap(), 525, 1000, 208).unwrap()
    }

    #[test]
    fn figures_of_525_sweeps_at_30_hertz() {
        let clocks = nominal();
        assert_eq!(clocks.sample_rate(), Rate::new(525 * 30 * 1208, 1).unwrap());
        assert!((1.0 / clocks.sample_rate().hertz() - 52.56e-9).abs() < 1e-11);
    }

    #[test]
    fn a_period_is_counted_in_whole_ticks() {
        let rate = |frames, seconds| Rate::new(frames, seconds).unwrap();
        assert_eq!(rate(30, 1).period_ticks(1_000_000_000), 33_333_333);
        assert_eq!(rate(30_000, 1001).period_ticks(40_000_000), 1_334_666);
        assert_eq!((rate(30, 1).period_ticks(1), rate(1, u64::MAX).period_ticks(u64::MAX)), (1, u64::MAX));
    }

    #[test]
    fn a_million_frames_do_not_drift() {
        let clocks = nominal();
        let start = clocks.sweep_clock(3_000_000, 0).tick_at_or_after(SweepTime(0.0));
        // 3 000 000 frames at 30 Hz are 100 000 s of a 20 MHz clock.
        assert_eq!(start, Tick(2_000_000_000_000));
    }

    #[test]
    fn ticks_round_up_and_come_back() {
        let clocks = nominal();
        for sweep in 0..525 {
            let time = SweepTime(f64::from(sweep) * 1.7 - 0.9);
            let clock = clocks.sweep_clock(7, sweep);
            let tick = clock.tick_at_or_after(time);
            let back = clock.instant_of(tick);
            let late = (back.0 - time.0) * clocks.ticks_per_sample();
            assert!((-1e-6..1.0 + 1e-6).contains(&late), "sweep {sweep}: {late} ticks late");
        }
    }

    /// 20 MHz over 15 750 sweeps a second: sweep k begins at 1269 + 53/63 ticks times k.
    #[test]
    fn a_sweep_begins_between_two_ticks() {
        let clocks = nominal();
        for (sweep, tick) in [(0, 0), (1, 1270), (2, 2540), (3, 3810), (63, 80_000), (64, 81_270)] {
            let clock = clocks.sweep_clock(0, sweep);
            assert_eq!(clock.tick_at_or_after(SweepTime(0.0)), Tick(tick), "sweep {sweep}");
        }
    }

    /// 20 250 ticks to 25 110 steps: tick 50 of a sweep that begins on a tick is its step 62, which the quotient of the rates
    /// puts at 62.000 000 000 000 01.
    #[test]
    fn a_tick_that_falls_on_a_step_is_seen_by_it() {
        let rate = |hertz| Rate::new(hertz, 1).unwrap();
        let clocks = Timebase::new(rate(20_250), rate(30), 9, 75, 18).unwrap();
        let clock = clocks.sweep_clock(3, 2);
        assert_eq!(clock.tick_at_or_after(SweepTime(0.0)), Tick(2175));
        let instant = clock.instant_of(Tick(2225));
        assert_eq!((instant, instant.sample_at_or_after()), (SweepTime(62.0), 62));
        assert_eq!(clock.instant_of(Tick(2224)).sample_at_or_after(), 61);
    }

    #[test]
    fn rates_are_in_lowest_terms() {
        assert_eq!(Rate::new(60_000, 1001), Rate::new(120_000, 2002));
        assert_eq!(Rate::new(0, 1), None);
        assert_eq!(Rate::new(30, 1).unwrap().to_string(), "30 Hz");
    }
}
