//! A date and time in UTC for which the sky is known.

use std::fmt;
use std::str::FromStr;

use dates::{DateError, Moment};

use crate::terrestrial_time::ahead_of_utc;

/// A date and time in UTC. Leap seconds are seconds like others.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Instant(Moment);

/// First year that the theory is measured for.
pub const FIRST: i64 = 1960;
/// Last year that the theory is measured for.
pub const LAST: i64 = 2050;

const DAY: f64 = 86_400.0;

/// Why a text is no instant.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum InstantError {
    /// The text is no date and time.
    #[error(transparent)]
    Date(#[from] DateError),
    /// Date and time without an offset from UTC.
    #[error(
        "the time zone is missing; expected Z for UTC at the end, as in 1972-12-11T22:00:00Z, or an offset such as +01:00"
    )]
    NoZone,
    /// A year that the theory is not measured for.
    #[error(
        "the year {0}; expected a year from {FIRST} to {LAST}, for which the error of the sun is measured"
    )]
    Year(i64),
}

impl Instant {
    /// The instant `seconds` later. It may lie beyond [`LAST`]: see [`Instant::is_measured`].
    pub fn later(self, seconds: f64) -> Self {
        Self(self.0.later(seconds))
    }

    /// Seconds from `earlier` to this instant, leap seconds counted.
    pub fn since(self, earlier: Self) -> f64 {
        self.0.since(earlier.0)
    }

    /// Whether the error of the sky is measured for the year of this instant, [`FIRST`] to [`LAST`].
    pub fn is_measured(self) -> bool {
        (FIRST..=LAST).contains(&self.0.year())
    }

    /// Terrestrial time, Julian centuries after J2000.0 (2000-01-01T12:00:00 TT).
    pub(crate) fn centuries(self) -> f64 {
        let terrestrial = self.0.without_leaps() + ahead_of_utc(self.0);
        (terrestrial / DAY - 0.5) / 36_525.0
    }
}

impl FromStr for Instant {
    type Err = InstantError;

    /// Reads what [`dates::read`] does, with a zone, from [`FIRST`] to [`LAST`].
    fn from_str(text: &str) -> Result<Self, InstantError> {
        let written = dates::read(text)?;
        let instant = Self(written.moment);
        match written.has_zone {
            false => Err(InstantError::NoZone),
            true if instant.is_measured() => Ok(instant),
            true => Err(InstantError::Year(instant.0.year())),
        }
    }
}

impl fmt::Display for Instant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::{Instant, InstantError};

    fn read(text: &str) -> Result<Instant, InstantError> {
        text.parse()
    }

    #[test]
    fn an_instant_has_a_zone_and_a_measured_year() {
        assert_eq!(read("1972-12-11T22:00:00Z").unwrap().to_string(), "1972-12-11T22:00:00Z");
        assert_eq!(read("1972-12-11T22:00:00"), Err(InstantError::NoZone));
        assert!(matches!(read("1972-12-11"), Err(InstantError::Date(_))));
        for (text, year) in [
            ("1959-12-31T23:59:59Z", 1959),
            ("2051-01-01T00:00:00Z", 2051),
            ("1960-01-01T00:30:00+01:00", 1959),
        ] {
            assert_eq!(read(text), Err(InstantError::Year(year)), "{text}");
        }
        let last = read("2050-12-31T23:59:59.999Z").unwrap();
        assert!(read("1960-01-01T00:00:00Z").is_ok() && last.is_measured());
        assert!(!last.later(0.001).is_measured());
    }

    #[test]
    fn leap_seconds_count_between_instants() {
        let [before, leap, after] = ["2016-12-31T23:59:59Z", "2016-12-31T23:59:60Z", "2017-01-01T00:00:00Z"]
            .map(|text| read(text).unwrap());
        assert_eq!([leap, after], [before.later(1.0), before.later(2.0)]);
        assert_eq!((after.since(before), leap.to_string()), (2.0, "2016-12-31T23:59:60Z".into()));
        let terrestrial = |instant: Instant| (instant.centuries() * 36_525.0 + 0.5) * 86_400.0;
        assert!((terrestrial(leap) - terrestrial(before) - 1.0).abs() < 1e-5);
        assert!((terrestrial(after) - terrestrial(before) - 2.0).abs() < 1e-5);
    }
}
