//! A date and time in UTC, as ISO 8601 writes it.

use std::fmt;
use std::str::FromStr;

use crate::terrestrial_time::{ends_with_leap_second, offset};

/// A date and time in UTC.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Instant {
    /// Seconds after 2000-01-01T00:00:00Z, every day having 86 400. A leap second counts as the first second of the next day.
    seconds: f64,
}

/// First year that the theory is measured for.
pub const FIRST: i64 = 1960;
/// Last year that the theory is measured for.
pub const LAST: i64 = 2050;

const DAY: f64 = 86_400.0;

/// Why a text is no instant.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum InstantError {
    /// The text does not have the form of a date and time.
    #[error("expected a date and time such as 1972-12-11T22:00:00Z")]
    Form,
    /// Date and time without an offset from UTC.
    #[error(
        "the time zone is missing; expected Z for UTC at the end, as in 1972-12-11T22:00:00Z, or an offset such as +01:00"
    )]
    NoZone,
    /// A day that the calendar does not have, or a time that the day does not have.
    #[error("there is no {what} {found} here; expected {expected}")]
    Calendar {
        /// Part of the date or time, as "month".
        what: &'static str,
        /// Number that was found.
        found: i64,
        /// What the part may be.
        expected: String,
    },
    /// A year that the theory is not measured for.
    #[error(
        "the year {0}; expected a year from {FIRST} to {LAST}, for which the error of the sun is measured"
    )]
    Year(i64),
}

impl Instant {
    /// The instant `seconds` later; it may lie beyond [`LAST`], where the error is not measured.
    pub fn later(self, seconds: f64) -> Self {
        Self { seconds: self.seconds + seconds }
    }

    /// Seconds from `earlier` to this instant, leap seconds not counted.
    pub fn since(self, earlier: Self) -> f64 {
        self.seconds - earlier.seconds
    }

    /// Terrestrial time, Julian centuries after J2000.0 (2000-01-01T12:00:00 TT).
    pub(crate) fn centuries(self) -> f64 {
        let terrestrial = self.seconds + offset(self.seconds / DAY);
        (terrestrial / DAY - 0.5) / 36_525.0
    }
}

impl FromStr for Instant {
    type Err = InstantError;

    /// Reads `YYYY-MM-DDThh:mm`, with or without seconds and their decimals, and an offset from UTC behind: `Z` or `+hh:mm`.
    fn from_str(text: &str) -> Result<Self, InstantError> {
        let (date, time) = text.split_once('T').ok_or(InstantError::Form)?;
        let [year, month, day] = numbers(date, '-', [4, 2, 2])?;
        let (time, zone) = match time.find(['Z', '+', '-']) {
            Some(at) => time.split_at(at),
            None => return Err(InstantError::NoZone),
        };
        let (whole, decimals) =
            time.split_once('.').map_or((time, None), |(whole, rest)| (whole, Some(rest)));
        let [hour, minute, second] = match decimals {
            None if whole.len() == 5 => {
                numbers(whole, ':', [2, 2]).map(|[hour, minute]| [hour, minute, 0])?
            }
            _ => numbers(whole, ':', [2, 2, 2])?,
        };
        let decimals = decimals.map_or(Ok(0.0), fraction)?;
        let ahead = zone_minutes(zone)?;
        within("month", month, 1, 12)?;
        within("day", day, 1, days_of(year, month))?;
        within("hour", hour, 0, 23)?;
        within("minute", minute, 0, 59)?;
        let minutes = days_from_civil(year, month, day) * 1440 + hour * 60 + minute - ahead;
        let is_last = minutes.rem_euclid(1440) == 1439 && ends_with_leap_second(minutes.div_euclid(1440));
        within("second", second, 0, if is_last { 60 } else { 59 })?;
        let instant = Self { seconds: (minutes * 60 + second) as f64 + decimals };
        match civil_from_days((instant.seconds / DAY).floor() as i64)[0] {
            FIRST..=LAST => Ok(instant),
            year => Err(InstantError::Year(year)),
        }
    }
}

impl fmt::Display for Instant {
    /// As ISO 8601 in UTC, to the millisecond where it is not a whole second.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let milliseconds = (self.seconds * 1e3).round() as i64;
        let (day, in_day) = (milliseconds.div_euclid(86_400_000), milliseconds.rem_euclid(86_400_000));
        let [year, month, date] = civil_from_days(day);
        let [hour, minute, second] = [in_day / 3_600_000, in_day / 60_000 % 60, in_day / 1000 % 60];
        write!(f, "{year:04}-{month:02}-{date:02}T{hour:02}:{minute:02}:{second:02}")?;
        match in_day % 1000 {
            0 => f.write_str("Z"),
            rest => write!(f, ".{rest:03}Z"),
        }
    }
}

/// Numbers of so many digits each, with `between` between them.
fn numbers<const N: usize>(text: &str, between: char, digits: [usize; N]) -> Result<[i64; N], InstantError> {
    let parts: Vec<&str> = text.split(between).collect();
    let parts: [&str; N] = parts.try_into().map_err(|_| InstantError::Form)?;
    let mut numbers = [0; N];
    for (index, part) in parts.iter().enumerate() {
        if part.len() != digits[index] || !part.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(InstantError::Form);
        }
        numbers[index] = part.parse().map_err(|_| InstantError::Form)?;
    }
    Ok(numbers)
}

/// Decimals of a second.
fn fraction(digits: &str) -> Result<f64, InstantError> {
    let is_fraction = (1..=9).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit());
    if is_fraction {
        format!("0.{digits}").parse().map_err(|_| InstantError::Form)
    } else {
        Err(InstantError::Form)
    }
}

/// Minutes that the clock of a zone is ahead of UTC.
fn zone_minutes(zone: &str) -> Result<i64, InstantError> {
    if zone == "Z" {
        return Ok(0);
    }
    let sign = if zone.starts_with('-') { -1 } else { 1 };
    let [hours, minutes] = numbers(&zone[1..], ':', [2, 2])?;
    within("offset of hours", hours, 0, 14)?;
    within("offset of minutes", minutes, 0, 59)?;
    Ok(sign * (hours * 60 + minutes))
}

fn within(what: &'static str, found: i64, least: i64, most: i64) -> Result<(), InstantError> {
    if (least..=most).contains(&found) {
        return Ok(());
    }
    Err(InstantError::Calendar { what, found, expected: format!("{least} to {most}") })
}

fn is_leap_year(year: i64) -> bool {
    year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
}

fn days_of(year: i64, month: i64) -> i64 {
    match month {
        2 if is_leap_year(year) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Days from 2000-01-01 to a date of the Gregorian calendar.
pub(crate) fn days_from_civil(year: i64, month: i64, day: i64) -> i64 {
    let before = year - 1;
    let of_years = 365 * before + before.div_euclid(4) - before.div_euclid(100) + before.div_euclid(400);
    let of_months: i64 = (1..month).map(|month| days_of(year, month)).sum();
    // 730 119 days of whole years before the year 2000.
    of_years + of_months + day - 1 - 730_119
}

/// Year, month and day, so many days after 2000-01-01.
fn civil_from_days(days: i64) -> [i64; 3] {
    // Not after the right one, on either side of 2000.
    let mut year = 2000 + days.div_euclid(366).min(days.div_euclid(365));
    while days_from_civil(year + 1, 1, 1) <= days {
        year += 1;
    }
    let month = (1..=12).rev().find(|month| days_from_civil(year, *month, 1) <= days).unwrap_or(1);
    [year, month, days - days_from_civil(year, month, 1) + 1]
}

#[cfg(test)]
mod tests {
    use super::{FIRST, Instant, InstantError, LAST, civil_from_days, days_from_civil};
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    fn read(text: &str) -> Result<Instant, InstantError> {
        text.parse()
    }

    #[test]
    fn julian_days_of_meeus() {
        // Astronomical Algorithms, 2nd ed., p. 62: Julian days of noon; J2000.0 is 2451545.
        for ([year, month, day], julian) in [
            ([2000, 1, 1], 2_451_545),
            ([1987, 6, 19], 2_446_966),
            ([1999, 1, 1], 2_451_180),
            ([1600, 12, 31], 2_305_813),
        ] {
            assert_eq!(days_from_civil(year, month, day) + 2_451_545, julian, "{year}-{month}-{day}");
        }
    }

    #[test]
    fn forms_of_one_instant() {
        let expected = read("1972-12-11T22:00:00Z").unwrap();
        for text in [
            "1972-12-11T22:00Z",
            "1972-12-11T22:00:00.000Z",
            "1972-12-11T23:00:00+01:00",
            "1972-12-12T03:30:00+05:30",
            "1972-12-11T16:00:00-06:00",
        ] {
            assert_eq!(read(text), Ok(expected), "{text}");
        }
        assert_eq!(expected.to_string(), "1972-12-11T22:00:00Z");
        assert_eq!(read("1969-07-20T20:17:40.25Z").unwrap().to_string(), "1969-07-20T20:17:40.250Z");
        assert_eq!(read("2016-12-31T23:59:60Z").unwrap(), read("2017-01-01T00:00:00Z").unwrap());
        assert_eq!(read("2017-01-01T00:59:60+01:00").unwrap(), read("2017-01-01T00:00:00Z").unwrap());
        assert_eq!(expected.later(90.5).since(expected), 90.5);
    }

    #[test]
    fn what_is_no_instant() {
        for text in [
            "",
            "1972-12-11",
            "22:00:00Z",
            "1972-12-11 22:00:00Z",
            "72-12-11T22:00:00Z",
            "1972-1-11T22:00:00Z",
            "1972-12-11T2200Z",
            "1972-12-11T22:00:00.Z",
            "1972-12-11T22:00.5Z",
            "1972-12-11T22:00:00Zulu",
            "1972-12-11T22:00:00+1",
            "1972-12-11T22:00:00+0100",
            "+972-12-11T22:00:00Z",
            "1972-12-11T22:00:00.1234567890Z",
            "1972-12-11T22:00:00+é1:00",
        ] {
            assert_eq!(read(text), Err(InstantError::Form), "{text}");
        }
        assert_eq!(read("1972-12-11T22:00:00"), Err(InstantError::NoZone));
        for (text, word) in [
            ("1972-13-11T22:00:00Z", "month 13"),
            ("1972-00-11T22:00:00Z", "month 0"),
            ("1973-02-29T22:00:00Z", "day 29"),
            ("1900-02-29T22:00:00Z", "day 29"),
            ("1972-12-11T24:00:00Z", "hour 24"),
            ("1972-12-11T22:60:00Z", "minute 60"),
            ("1972-12-11T22:00:60Z", "second 60"),
            ("2017-12-31T23:59:60Z", "second 60"),
            ("1972-12-11T22:00:00+15:00", "offset of hours 15"),
        ] {
            let said = read(text).unwrap_err().to_string();
            assert!(said.contains(word) && said.contains("expected"), "{text}: {said}");
        }
        for (text, year) in [
            ("1959-12-31T23:59:59Z", 1959),
            ("2051-01-01T00:00:00Z", 2051),
            ("1960-01-01T00:30:00+01:00", 1959),
        ] {
            assert_eq!(read(text), Err(InstantError::Year(year)), "{text}");
        }
        assert!(read("1960-01-01T00:00:00Z").is_ok() && read("2050-12-31T23:59:59.999Z").is_ok());
    }

    proptest! {
        #[test]
        fn dates_and_days_are_inverse(day in -40_000..40_000i64) {
            let [year, month, date] = civil_from_days(day);
            prop_assert_eq!(days_from_civil(year, month, date), day);
            prop_assert!((1..=12).contains(&month) && (1..=31).contains(&date));
        }

        #[test]
        fn what_is_written_reads_back(seconds in 0..2_800_000_000_i64) {
            let first = read(&format!("{FIRST}-01-01T00:00:00Z")).unwrap();
            let instant = first.later(seconds as f64);
            prop_assert_eq!(read(&instant.to_string()), Ok(instant));
            let end = (LAST + 1).to_string();
            prop_assert!(instant.to_string() < end);
        }

        #[test]
        fn no_text_panics(text in "\\PC{0,30}", digits in "[0-9TZ:.+-]{0,30}") {
            let _ = (read(&text), read(&digits));
        }
    }
}
