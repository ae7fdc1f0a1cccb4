//! From UTC to terrestrial time (TT).
//!
//! From 1972 on TT - UTC is 32.184 s, 10 s and the leap seconds since. Before 1972 UTC kept within 0.2 s of UT: TT - UT is
//! tabled there (J. Meeus, Astronomical Algorithms, 2nd ed., table 10.A) and straight in between. The Moon turns by 0.00015
//! degrees a second, so a second more or less does not matter here.

use dates::{Moment, days_from_civil};

/// Atomic time less terrestrial time (s).
const ATOMIC: f64 = 32.184;

/// Atomic time less UTC at the begin of 1972 (s).
const FIRST_AHEAD: i64 = 10;

/// Seconds of a day without a leap second.
const DAY: f64 = 86_400.0;

/// Year, and terrestrial time less universal time at its begin (s).
const BEFORE_LEAPS: [(i64, f64); 7] =
    [(1960, 33.1), (1962, 34.0), (1964, 35.0), (1966, 36.5), (1968, 38.3), (1970, 40.2), (1972, 42.2)];

/// Days from 2000-01-01 to the begin of a year.
fn begin(year: i64) -> f64 {
    days_from_civil([year, 1, 1]) as f64
}

/// Terrestrial time less UTC (s).
pub fn ahead_of_utc(moment: Moment) -> f64 {
    let days = moment.without_leaps() / DAY;
    if days >= begin(1972) {
        ATOMIC + (FIRST_AHEAD + moment.leap_seconds()) as f64
    } else {
        before_leaps(days)
    }
}

fn before_leaps(days: f64) -> f64 {
    let later =
        BEFORE_LEAPS.partition_point(|(year, _)| begin(*year) <= days).clamp(1, BEFORE_LEAPS.len() - 1);
    let (before, after) = (BEFORE_LEAPS[later - 1], BEFORE_LEAPS[later]);
    let share = (days - begin(before.0)) / (begin(after.0) - begin(before.0));
    before.1 + share * (after.1 - before.1)
}

#[cfg(test)]
mod tests {
    use super::ahead_of_utc;

    #[test]
    fn known_offsets() {
        let at = |date: &str| ahead_of_utc(dates::read(&format!("{date}T00:00:00Z")).expect("a date").moment);
        assert!((at("2017-01-01") - 69.184).abs() < 1e-12 && (at("2016-12-31") - 68.184).abs() < 1e-12);
        assert!((at("2049-01-01") - 69.184).abs() < 1e-12 && (at("1972-01-01") - 42.184).abs() < 1e-12);
        // TAI - UTC was 6.1 s on 1968-02-01 by the formula of that time (USNO, tai-utc.dat).
        assert!((at("1968-02-01") - 38.29).abs() < 0.2, "{}", at("1968-02-01"));
        assert!((at("1961-01-01") - 33.61).abs() < 0.2, "{}", at("1961-01-01"));
        // The step into the leap seconds is no jump.
        assert!((at("1971-12-31") - at("1972-01-01")).abs() < 0.05);
    }
}
