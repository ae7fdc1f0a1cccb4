//! Dates and times as ISO 8601 writes them.

use crate::calendar::{days_from_civil, days_of};
use crate::leaps::ends_with_leap_second;
use crate::moment::Moment;

/// A date and time as a text says it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Written {
    /// The instant; of a text without a zone, as if its clock showed UTC.
    pub moment: Moment,
    /// Whether the text says its distance from UTC: `Z`, `+01:00`.
    pub has_zone: bool,
}

/// Why a text is no date and time.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DateError {
    /// The text does not have the form of a date and time.
    #[error("expected {}", self.expected())]
    Form,
    /// A day that the calendar does not have, or a time that the day does not have.
    #[error("there is no {what} {found} here; expected {}", self.expected())]
    Calendar {
        /// Part of the date or time, as "month".
        what: &'static str,
        /// Number that was found.
        found: i64,
        /// Numbers that the part may be, in words.
        allowed: String,
    },
}

impl DateError {
    /// What was expected, as words behind "must be".
    pub fn expected(&self) -> String {
        match self {
            Self::Form => "a date and time such as 1972-12-11T22:00:00Z".into(),
            Self::Calendar { what, allowed, .. } => format!("a date with {what} {allowed}"),
        }
    }
}

/// Reads `2026-11-26T22:00:00.5Z`: also with a blank for the `T`, with a decimal comma, without seconds, with a zone such as
/// `+01:00`, `+0100` or `+01`, or without a zone. `23:59:60` is read where a leap second was.
///
/// # Errors
/// [`DateError::Form`] for other text, [`DateError::Calendar`] for days and times that do not exist.
pub fn read(text: &str) -> Result<Written, DateError> {
    let (date, clock) = text.split_at_checked(10).ok_or(DateError::Form)?;
    let clock = clock.strip_prefix(['T', 't', ' ']).ok_or(DateError::Form)?;
    let [year, month, day] = numbers(date, '-', [4, 2, 2])?;
    let (clock, ahead) = zone(clock)?;
    let ([hour, minute, second], fraction) = time(clock)?;
    within("year", year, 1, 9999)?;
    within("month", month, 1, 12)?;
    within("day", day, 1, days_of(year, month))?;
    within("hour", hour, 0, 23)?;
    within("minute", minute, 0, 59)?;
    let minutes = days_from_civil([year, month, day]) * 1440 + hour * 60 + minute - ahead.unwrap_or(0);
    let (day, minute) = (minutes.div_euclid(1440), minutes.rem_euclid(1440));
    if second == 60 && !(minute == 1439 && ends_with_leap_second(day)) {
        let allowed = "0 to 59, since no leap second ends that minute".into();
        return Err(DateError::Calendar { what: "second", found: second, allowed });
    }
    within("second", second, 0, 60)?;
    let moment = Moment::of_day(day, minute * 60 + second, fraction);
    Ok(Written { moment, has_zone: ahead.is_some() })
}

/// Hour, minute and second, and the decimals of the second.
fn time(clock: &str) -> Result<([i64; 3], f64), DateError> {
    match clock.split_once(['.', ',']) {
        Some((whole, decimals)) => Ok((numbers(whole, ':', [2; 3])?, fraction(decimals)?)),
        None if clock.len() == 5 => {
            let [hour, minute] = numbers(clock, ':', [2; 2])?;
            Ok(([hour, minute, 0], 0.0))
        }
        None => Ok((numbers(clock, ':', [2; 3])?, 0.0)),
    }
}

/// Numbers of so many digits each, with `between` between them.
fn numbers<const N: usize>(text: &str, between: char, digits: [usize; N]) -> Result<[i64; N], DateError> {
    let parts: Vec<&str> = text.split(between).collect();
    let parts: [&str; N] = parts.try_into().map_err(|_| DateError::Form)?;
    let mut numbers = [0; N];
    for (index, part) in parts.iter().enumerate() {
        if part.len() != digits[index] || !is_digits(part) {
            return Err(DateError::Form);
        }
        numbers[index] = part.parse().map_err(|_| DateError::Form)?;
    }
    Ok(numbers)
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Decimals of a second, below 1.
fn fraction(digits: &str) -> Result<f64, DateError> {
    if !is_digits(digits) {
        return Err(DateError::Form);
    }
    format!("0.{digits}").parse().map_err(|_| DateError::Form)
}

/// The time of day without its zone, and the minutes that the clock of the zone is ahead of UTC.
fn zone(clock: &str) -> Result<(&str, Option<i64>), DateError> {
    if let Some(rest) = clock.strip_suffix(['Z', 'z']) {
        return Ok((rest, Some(0)));
    }
    let Some(at) = clock.find(['+', '-']) else { return Ok((clock, None)) };
    let (rest, zone) = clock.split_at(at);
    let (sign, zone) = zone.split_at(1);
    let [hours, minutes] = match zone.len() {
        2 => numbers(zone, ':', [2]).map(|[hours]| [hours, 0])?,
        4 if is_digits(zone) => numbers(&format!("{}:{}", &zone[..2], &zone[2..]), ':', [2; 2])?,
        _ => numbers(zone, ':', [2; 2])?,
    };
    within("offset of hours", hours, 0, 14)?;
    within("offset of minutes", minutes, 0, 59)?;
    let ahead = hours * 60 + minutes;
    Ok((rest, Some(if sign == "-" { -ahead } else { ahead })))
}

fn within(what: &'static str, found: i64, least: i64, most: i64) -> Result<(), DateError> {
    if (least..=most).contains(&found) {
        return Ok(());
    }
    Err(DateError::Calendar { what, found, allowed: format!("{least} to {most}") })
}
