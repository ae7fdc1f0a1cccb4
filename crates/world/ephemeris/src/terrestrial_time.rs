//! From UTC to terrestrial time (TT).
//!
//! From 1972 on TT - UTC is 32.184 s and the leap seconds (IERS Bulletin C). After the last one, of 2017, none is foreseen.
//! Before 1972 UTC kept within 0.2 s of UT: TT - UT is tabled there (J. Meeus, Astronomical Algorithms, 2nd ed., table 10.A)
//! and straight in between. The Moon turns by 0.00015 degrees a second, so a second more or less does not matter here.

use crate::instant::days_from_civil;

/// Atomic time less terrestrial time (s).
const ATOMIC: f64 = 32.184;

/// Year, month and day from which on atomic time is so many seconds ahead of UTC.
const LEAPS: [([i64; 3], f64); 28] = [
    ([1972, 1, 1], 10.0),
    ([1972, 7, 1], 11.0),
    ([1973, 1, 1], 12.0),
    ([1974, 1, 1], 13.0),
    ([1975, 1, 1], 14.0),
    ([1976, 1, 1], 15.0),
    ([1977, 1, 1], 16.0),
    ([1978, 1, 1], 17.0),
    ([1979, 1, 1], 18.0),
    ([1980, 1, 1], 19.0),
    ([1981, 7, 1], 20.0),
    ([1982, 7, 1], 21.0),
    ([1983, 7, 1], 22.0),
    ([1985, 7, 1], 23.0),
    ([1988, 1, 1], 24.0),
    ([1990, 1, 1], 25.0),
    ([1991, 1, 1], 26.0),
    ([1992, 7, 1], 27.0),
    ([1993, 7, 1], 28.0),
    ([1994, 7, 1], 29.0),
    ([1996, 1, 1], 30.0),
    ([1997, 7, 1], 31.0),
    ([1999, 1, 1], 32.0),
    ([2006, 1, 1], 33.0),
    ([2009, 1, 1], 34.0),
    ([2012, 7, 1], 35.0),
    ([2015, 7, 1], 36.0),
    ([2017, 1, 1], 37.0),
];

/// Year, and terrestrial time less universal time at its begin (s).
const BEFORE_LEAPS: [(i64, f64); 7] =
    [(1960, 33.1), (1962, 34.0), (1964, 35.0), (1966, 36.5), (1968, 38.3), (1970, 40.2), (1972, 42.2)];

/// Terrestrial time less UTC (s), `days` (UTC, with their fraction) after 2000-01-01.
pub fn offset(days: f64) -> f64 {
    let starts =
        |([year, month, day], _): &&([i64; 3], f64)| days_from_civil(*year, *month, *day) as f64 <= days;
    match LEAPS.iter().rev().find(starts) {
        Some((_, ahead)) => ATOMIC + ahead,
        None => before_leaps(days),
    }
}

fn before_leaps(days: f64) -> f64 {
    let begin = |(year, _): (i64, f64)| days_from_civil(year, 1, 1) as f64;
    let later = BEFORE_LEAPS.partition_point(|row| begin(*row) <= days).clamp(1, BEFORE_LEAPS.len() - 1);
    let (before, after) = (BEFORE_LEAPS[later - 1], BEFORE_LEAPS[later]);
    let share = (days - begin(before)) / (begin(after) - begin(before));
    before.1 + share * (after.1 - before.1)
}

/// Whether the last minute of a day, so many days after 2000-01-01, had a 61st second.
pub fn ends_with_leap_second(day: i64) -> bool {
    // The first row begins the count; no second was put in before it.
    LEAPS[1..].iter().any(|([year, month, first], _)| days_from_civil(*year, *month, *first) == day + 1)
}

#[cfg(test)]
mod tests {
    use super::{ends_with_leap_second, offset};
    use crate::instant::days_from_civil;

    #[test]
    fn known_offsets() {
        let at = |year, month, day| offset(days_from_civil(year, month, day) as f64);
        assert!((at(2017, 1, 1) - 69.184).abs() < 1e-12 && (at(2016, 12, 31) - 68.184).abs() < 1e-12);
        assert!((at(2049, 1, 1) - 69.184).abs() < 1e-12 && (at(1972, 1, 1) - 42.184).abs() < 1e-12);
        // TAI - UTC was 6.1 s on 1968-02-01 by the formula of that time (USNO, tai-utc.dat).
        assert!((at(1968, 2, 1) - 38.29).abs() < 0.2, "{}", at(1968, 2, 1));
        assert!((at(1961, 1, 1) - 33.61).abs() < 0.2, "{}", at(1961, 1, 1));
        // The step into the leap seconds is no jump.
        assert!((at(1971, 12, 31) - at(1972, 1, 1)).abs() < 0.05);
    }

    #[test]
    fn days_with_a_leap_second() {
        let day = |year, month, day| ends_with_leap_second(days_from_civil(year, month, day));
        assert!(day(2016, 12, 31) && day(1972, 6, 30) && day(1972, 12, 31));
        assert!(!day(2017, 12, 31) && !day(1971, 12, 31) && !day(2016, 12, 30));
    }
}
