//! Dates and times of day in UTC: one reader of ISO 8601 for every file and option, the calendar, leap seconds.
//!
//! - [`read`]: a text as a date and time; [`DateError`] says what is wrong with it.
//! - [`Moment`]: the instant that it says, on a clock that counts leap seconds like all others.
//!
//! ```
//! let moment = |text| dates::read(text).map(|written| written.moment);
//! let (last, first) = (moment("2016-12-31T23:59:60Z")?, moment("2017-01-01T00:00:00Z")?);
//! assert_eq!((first.since(last), last.to_string()), (1.0, "2016-12-31T23:59:60Z".to_owned()));
//! # Ok::<(), dates::DateError>(())
//! ```

mod calendar;
mod leaps;
mod moment;
mod read;

pub use calendar::days_from_civil;
pub use moment::Moment;
pub use read::{DateError, Written, read};
