//! Leap seconds (IERS Bulletin C): after the last one, of 2016, none is foreseen. Before 1972 UTC had none.

use crate::calendar::days_from_civil;

/// Seconds of a day without a leap second.
pub(crate) const DAY: i64 = 86_400;

/// The days that began right after a leap second: year, month, day.
const DAYS: [[i64; 3]; 27] = [
    [1972, 7, 1],
    [1973, 1, 1],
    [1974, 1, 1],
    [1975, 1, 1],
    [1976, 1, 1],
    [1977, 1, 1],
    [1978, 1, 1],
    [1979, 1, 1],
    [1980, 1, 1],
    [1981, 7, 1],
    [1982, 7, 1],
    [1983, 7, 1],
    [1985, 7, 1],
    [1988, 1, 1],
    [1990, 1, 1],
    [1991, 1, 1],
    [1992, 7, 1],
    [1993, 7, 1],
    [1994, 7, 1],
    [1996, 1, 1],
    [1997, 7, 1],
    [1999, 1, 1],
    [2006, 1, 1],
    [2009, 1, 1],
    [2012, 7, 1],
    [2015, 7, 1],
    [2017, 1, 1],
];

/// Whether the last minute of a day, so many days after 2000-01-01, had a 61st second.
pub(crate) fn ends_with_leap_second(day: i64) -> bool {
    DAYS.iter().any(|date| days_from_civil(*date) == day + 1)
}

/// Number of leap seconds before the day that is so many days after 2000-01-01.
pub(crate) fn before_day(day: i64) -> i64 {
    DAYS.iter().take_while(|date| days_from_civil(**date) <= day).count() as i64
}

/// Number of leap seconds that had ended `elapsed` seconds after the origin of a moment, and whether one was running.
pub(crate) fn by(elapsed: f64) -> (i64, bool) {
    // A leap second begins where the day after it would, with those before it counted.
    let begin = |(index, date): (usize, &[i64; 3])| (days_from_civil(*date) * DAY + index as i64) as f64;
    let ended = DAYS.iter().enumerate().map(begin).take_while(|begin| begin + 1.0 <= elapsed).count();
    let is_running = DAYS.get(ended).is_some_and(|date| begin((ended, date)) <= elapsed);
    (ended as i64, is_running)
}

#[cfg(test)]
mod tests {
    use super::{DAY, before_day, by, ends_with_leap_second};
    use crate::calendar::days_from_civil;

    #[test]
    fn days_with_a_leap_second() {
        let day = |date| ends_with_leap_second(days_from_civil(date));
        assert!(day([2016, 12, 31]) && day([1972, 6, 30]) && day([1972, 12, 31]));
        assert!(!day([2017, 12, 31]) && !day([1971, 12, 31]) && !day([2016, 12, 30]));
    }

    #[test]
    fn leap_seconds_are_counted_as_they_end() {
        let day = days_from_civil([2017, 1, 1]);
        assert_eq!([before_day(day - 1), before_day(day)], [26, 27]);
        assert_eq!(
            [-1.0, 0.0, 0.5, 1.0].map(|after| by((day * DAY + 26) as f64 + after)),
            [(26, false), (26, true), (26, true), (27, false)]
        );
        assert_eq!((by(-1e9), by(5e9)), ((0, false), (27, false)));
    }
}
