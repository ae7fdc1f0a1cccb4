//! Dates as ISO 8601 has them.

/// An instant that a date and a time of day say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Seconds since 1970-01-01T00:00:00, every day with 86 400 s: leap seconds do not count.
    pub seconds: f64,
    /// Whether the text says its distance from UTC: `Z`, `+01:00`. Without it the zone is open.
    pub has_zone: bool,
}

/// Reads `2026-11-26T22:00:00.5Z`, also with a blank for the `T`, without seconds, with a zone as `+01:00` or without a
/// zone. `None` for other text and for days and hours that do not exist.
pub fn date_time(text: &str) -> Option<Moment> {
    let (date, clock) = (text.get(..10)?, text.get(10..)?.strip_prefix(['T', 't', ' '])?);
    let [year, month, day] = numbers(date, '-', [4, 2, 2])?;
    if year == 0 || !(1..=12).contains(&month) || !(1..=days_of(year, month)).contains(&day) {
        return None;
    }
    let (clock, zone) = zone(clock)?;
    let (clock, fraction) = match clock.split_once(['.', ',']) {
        Some((clock, digits)) if !digits.is_empty() && digits.chars().all(|digit| digit.is_ascii_digit()) => {
            (clock, format!("0.{digits}").parse().ok()?)
        }
        Some(_) => return None,
        None => (clock, 0.0),
    };
    let [hour, minute, second] = match clock.len() {
        5 if fraction == 0.0 => numbers(&format!("{clock}:00"), ':', [2; 3])?,
        _ => numbers(clock, ':', [2; 3])?,
    };
    if hour > 23 || minute > 59 || second > 59 {
        return None;
    }
    let whole = days_since_1970(year, month, day) * 86_400 + hour * 3600 + minute * 60 + second;
    Some(Moment { seconds: (whole - zone.unwrap_or(0)) as f64 + fraction, has_zone: zone.is_some() })
}

/// Three numbers of so many digits.
fn numbers(text: &str, separator: char, digits: [usize; 3]) -> Option<[i64; 3]> {
    let mut parts = text.split(separator);
    let mut found = [0; 3];
    for (number, digits) in found.iter_mut().zip(digits) {
        let part = parts.next()?;
        if part.len() != digits || !part.chars().all(|digit| digit.is_ascii_digit()) {
            return None;
        }
        *number = part.parse().ok()?;
    }
    parts.next().is_none().then_some(found)
}

/// The time of day without its zone, and the zone in seconds east of UTC.
fn zone(clock: &str) -> Option<(&str, Option<i64>)> {
    if let Some(rest) = clock.strip_suffix(['Z', 'z']) {
        return Some((rest, Some(0)));
    }
    let Some(at) = clock.rfind(['+', '-']) else { return Some((clock, None)) };
    let (rest, zone) = clock.split_at(at);
    let sign = if zone.starts_with('-') { -1 } else { 1 };
    let zone = &zone[1..];
    let text = match zone.len() {
        2 => format!("{zone}:00:00"),
        4 => format!("{}:{}:00", zone.get(..2)?, zone.get(2..)?),
        _ => format!("{zone}:00"),
    };
    let [hours, minutes, _] = numbers(&text, ':', [2; 3])?;
    (hours <= 14 && minutes <= 59).then_some((rest, Some(sign * (hours * 3600 + minutes * 60))))
}

fn is_leap(year: i64) -> bool {
    year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
}

fn days_of(year: i64, month: i64) -> i64 {
    match month {
        2 if is_leap(year) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Days from 1970-01-01 on, in the Gregorian calendar.
fn days_since_1970(year: i64, month: i64, day: i64) -> i64 {
    let before = year - 1;
    let leaps = before / 4 - before / 100 + before / 400;
    // Days from 0001-01-01 to 1970-01-01.
    const TO_1970: i64 = 719_162;
    let months: i64 = (1..month).map(|month| days_of(year, month)).sum();
    365 * before + leaps - TO_1970 + months + day - 1
}

#[cfg(test)]
mod tests {
    use super::{Moment, date_time};

    /// Seconds by `date -u -d TEXT +%s` of GNU coreutils.
    #[test]
    fn known_instants() {
        let known = [
            ("1970-01-01T00:00:00Z", 0.0),
            ("2023-11-14T22:13:20Z", 1_700_000_000.0),
            ("2000-02-29 12:00:00.25Z", 951_825_600.25),
            ("1969-07-20T20:17:40Z", -14_182_940.0),
            ("2100-03-01T00:00:00Z", 4_107_542_400.0),
            ("2023-11-14T23:13:20+01:00", 1_700_000_000.0),
            ("2023-11-14T16:43:20-0530", 1_700_000_000.0),
            ("2023-11-14T23:13+01", 1_699_999_980.0),
        ];
        for (text, seconds) in known {
            assert_eq!(date_time(text), Some(Moment { seconds, has_zone: true }), "{text}");
        }
        assert_eq!(date_time("2023-11-14T22:13:20").map(|moment| moment.has_zone), Some(false));
    }

    #[test]
    fn what_is_no_date() {
        let wrong = [
            "",
            "2023",
            "2023-11-14",
            "2023-13-01T00:00:00Z",
            "2023-02-29T00:00:00Z",
            "2023-11-14T24:00:00Z",
            "2023-11-14T00:60:00Z",
            "2016-12-31T23:59:60Z",
            "2023-11-14T00:00:00.Z",
            "2023-11-14T00:00:00+99:00",
            "14.11.2023 22:13:20",
            "2023-11-14T1:00:00Z",
            "+023-11-14T01:00:00Z",
            "2023-11-14T01:00:00ZZ",
            "20\u{e4}3-11-14T01:00:00Z",
            "2023-11-14T01:00.5Z",
            "0000-01-01T00:00:00Z",
        ];
        for text in wrong {
            assert_eq!(date_time(text), None, "{text}");
        }
    }
}
