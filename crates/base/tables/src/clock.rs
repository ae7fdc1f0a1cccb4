//! Times of a table, as seconds from its start.

use dates::Written;

/// A time as a table has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Time {
    /// Seconds since an instant that the table does not name.
    Seconds(f64),
    /// A date and a time of day.
    Date(Written),
}

/// From this many seconds on, a time is one since 1970, and a pause in a table is a mistake (3 years).
const SINCE_1970: f64 = 1e8;

/// From this many seconds on, a time is in a smaller unit than the second: milliseconds since 1970, not the year 5138.
const SMALLER_UNIT: f64 = 1e11;

/// Counts the times of one table. Dates and times of 10^8 s and more count from the first row. Other times count from 0, or
/// from the first row where the form of the table says so.
#[derive(Debug, Clone)]
pub struct Clock {
    from_first: bool,
    start: Option<Start>,
}

#[derive(Debug, Clone, Copy)]
struct Start {
    first: Time,
    origin: f64,
}

impl Clock {
    /// A clock for a table whose times may count from 0.
    pub fn from_zero() -> Self {
        Self { from_first: false, start: None }
    }

    /// A clock for a table whose times always count from its first row.
    pub fn from_first_row() -> Self {
        Self { from_first: true, start: None }
    }

    /// Seconds since the start of the table.
    ///
    /// # Errors
    /// What was expected: a time of the kind of the first row, less than 10^8 s away from it, in seconds.
    pub fn count(&mut self, time: Time) -> Result<f64, String> {
        let seconds = time.seconds();
        if matches!(time, Time::Seconds(seconds) if seconds.abs() >= SMALLER_UNIT) {
            return Err(
                "a number of seconds below 1e11; t_ms, t_us and t_ns are columns of smaller units".into()
            );
        }
        let start = *self.start.get_or_insert_with(|| {
            let from_first = self.from_first || time.is_absolute();
            Start { first: time, origin: if from_first { seconds } else { 0.0 } }
        });
        let counted = seconds - start.origin;
        match (start.first, time) {
            (Time::Date(first), Time::Date(date)) if first.has_zone != date.has_zone => Err(format!(
                "a date {} a zone, as in the first row",
                if first.has_zone { "with" } else { "without" }
            )),
            (Time::Date(_), Time::Seconds(_)) => Err("a date, as in the first row".into()),
            (Time::Seconds(_), Time::Date(_)) => Err("seconds, as in the first row".into()),
            _ if counted.abs() >= SINCE_1970 => {
                Err("a time less than 1e8 s (3 years) from the first row".into())
            }
            _ => Ok(counted),
        }
    }

    /// What the user should know of the origin, if times were moved to the first row because of their size or kind.
    pub fn note(&self) -> Option<String> {
        let start = self.start.filter(|start| start.first.is_absolute())?;
        let first = match start.first {
            Time::Seconds(seconds) => format!("which is at {seconds} s"),
            Time::Date(_) => "since they are dates".into(),
        };
        Some(format!("times count from the first row, {first}"))
    }
}

impl Time {
    fn seconds(self) -> f64 {
        match self {
            Self::Seconds(seconds) => seconds,
            Self::Date(date) => date.moment.elapsed(),
        }
    }

    /// Whether it counts from an instant long before the table.
    fn is_absolute(self) -> bool {
        matches!(self, Self::Date(_)) || self.seconds().abs() >= SINCE_1970
    }
}

#[cfg(test)]
mod tests {
    use super::{Clock, Time};

    fn counted(mut clock: Clock, times: &[f64]) -> Vec<Option<f64>> {
        times.iter().map(|time| clock.count(Time::Seconds(*time)).ok()).collect()
    }

    #[test]
    fn large_times_count_from_the_first_row() {
        assert_eq!(counted(Clock::from_zero(), &[1.7e9, 1.7e9 + 1.0]), [Some(0.0), Some(1.0)]);
        assert_eq!(counted(Clock::from_zero(), &[1e8, 1e8 + 1.0]), [Some(0.0), Some(1.0)]);
        assert_eq!(counted(Clock::from_zero(), &[99_999_999.0]), [Some(99_999_999.0)]);
        assert_eq!(counted(Clock::from_zero(), &[-3.0, 4.0]), [Some(-3.0), Some(4.0)]);
        assert_eq!(counted(Clock::from_first_row(), &[1000.0, 1001.0]), [Some(0.0), Some(1.0)]);
    }

    #[test]
    fn jumps_and_smaller_units_are_refused() {
        assert_eq!(counted(Clock::from_zero(), &[0.0, 1.7e9]), [Some(0.0), None]);
        assert_eq!(counted(Clock::from_zero(), &[1.7e9, 1.0]), [Some(0.0), None]);
        assert_eq!(counted(Clock::from_zero(), &[1.7e12]), [None]);
    }

    #[test]
    fn kinds_of_times_are_not_mixed() {
        let date = |text| Time::Date(dates::read(text).expect("a date"));
        let mut clock = Clock::from_zero();
        assert_eq!(clock.count(date("2023-11-14T22:13:20Z")), Ok(0.0));
        assert_eq!(clock.count(date("2023-11-14T23:13:21+01:00")), Ok(1.0));
        assert!(clock.count(date("2023-11-14T22:13:22")).is_err());
        assert!(clock.count(Time::Seconds(2.0)).is_err());
        assert!(clock.note().is_some_and(|note| note.contains("dates")));
        let mut clock = Clock::from_zero();
        assert_eq!(clock.count(Time::Seconds(2.0)), Ok(2.0));
        assert!(clock.count(date("2023-11-14T22:13:22Z")).is_err());
        assert_eq!(clock.note(), None);
    }
}
