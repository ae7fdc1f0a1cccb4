//! An instant, as a clock counts it that knows leap seconds.

use std::fmt;

use crate::calendar::civil_from_days;
use crate::leaps::{self, DAY};

/// An instant, exact to a fraction of a microsecond in our times.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Moment {
    /// Seconds after the origin: those of the days since 2000-01-01, each having 86 400, and all leap seconds since 1972.
    elapsed: f64,
}

impl Moment {
    /// So many days after 2000-01-01, and so many seconds into the day: from 86 400 on within a leap second.
    pub(crate) fn of_day(day: i64, second: i64, fraction: f64) -> Self {
        Self { elapsed: (day * DAY + second + leaps::before_day(day)) as f64 + fraction }
    }

    /// Seconds after an origin that all moments share: a clock that counts leap seconds, too.
    pub fn elapsed(self) -> f64 {
        self.elapsed
    }

    /// The moment `seconds` later, leap seconds counted.
    pub fn later(self, seconds: f64) -> Self {
        Self { elapsed: self.elapsed + seconds }
    }

    /// Seconds from `earlier` to this moment, leap seconds counted.
    pub fn since(self, earlier: Self) -> f64 {
        self.elapsed - earlier.elapsed
    }

    /// Number of leap seconds that had ended since 1972.
    pub fn leap_seconds(self) -> i64 {
        leaps::by(self.elapsed).0
    }

    /// Seconds after 2000-01-01T00:00:00Z without leap seconds; one of these counts as the second after it.
    pub fn without_leaps(self) -> f64 {
        self.elapsed - self.leap_seconds() as f64
    }

    /// Year in UTC, in which the moment lies.
    pub fn year(self) -> i64 {
        civil_from_days(self.day_and_thousandths().0)[0]
    }

    /// Days after 2000-01-01, and thousandths of a second into the day, rounded.
    fn day_and_thousandths(self) -> (i64, i64) {
        let rounded = (self.elapsed * 1e3).round();
        let (leaps, is_leap) = leaps::by(1e-3 * rounded);
        let thousandths = rounded as i64 - 1000 * leaps;
        let (day, in_day) = (thousandths.div_euclid(1000 * DAY), thousandths.rem_euclid(1000 * DAY));
        // A leap second belongs to the day before.
        if is_leap { (day - 1, in_day + 1000 * DAY) } else { (day, in_day) }
    }
}

impl fmt::Display for Moment {
    /// As ISO 8601 in UTC, to the millisecond where it is not a whole second.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (day, in_day) = self.day_and_thousandths();
        let [year, month, date] = civil_from_days(day);
        let minutes = (in_day / 60_000).min(DAY / 60 - 1);
        let [hour, minute, second] = [minutes / 60, minutes % 60, in_day / 1000 - 60 * minutes];
        write!(f, "{year:04}-{month:02}-{date:02}T{hour:02}:{minute:02}:{second:02}")?;
        match in_day % 1000 {
            0 => f.write_str("Z"),
            rest => write!(f, ".{rest:03}Z"),
        }
    }
}
