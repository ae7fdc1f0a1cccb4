//! Simulated time in nanoseconds since the start of the mission.

use quantities::Rate;

const NANOSECONDS: u128 = 1_000_000_000;

/// `count` periods of a clock, to the nearest nanosecond; `None` beyond 584 years.
pub fn nanoseconds(count: u64, clock: Rate) -> Option<u64> {
    let [numerator, denominator] = clock.fraction().map(u128::from);
    let periods = u128::from(count) * denominator;
    // The whole seconds apart, so that nothing overflows.
    let (seconds, rest) = (periods / numerator, periods % numerator);
    let part = (2 * rest * NANOSECONDS / numerator).div_ceil(2);
    u64::try_from(seconds.checked_mul(NANOSECONDS)? + part).ok()
}

#[cfg(test)]
mod tests {
    use quantities::Rate;

    use super::nanoseconds;

    #[test]
    fn frames_and_ticks_to_the_nanosecond() {
        let of = |count, above, below| nanoseconds(count, Rate::new(above, below).expect("a rate"));
        assert_eq!(of(0, 15, 1), Some(0));
        assert_eq!(of(1, 15, 1), Some(66_666_667));
        assert_eq!(of(2, 15, 1), Some(133_333_333));
        assert_eq!(of(30_000, 30_000, 1001), Some(1_001_000_000_000));
        assert_eq!(of(1, 2_000_000_000, 1), Some(1));
        assert_eq!(of(1, 2_000_000_001, 1), Some(0));
        assert_eq!(of(u64::MAX, 1_000_000_000, 1), Some(u64::MAX));
        assert_eq!(of(u64::MAX, 999_999_999, 1), None);
        assert_eq!(of(u64::MAX, 1, u64::MAX), None);
    }
}
