//! Degrees, minutes and seconds that cannot be read two ways.
//!
//! There are two forms. Signed decimal degrees: `-122.0383`. Degrees, minutes, seconds and one hemisphere letter, without any
//! sign: `122:02:17.89W`, with a blank before the letter if wished. The thesis's program wanted a minus sign on each of three
//! parts in the west; here a sign within the second form is refused.

use quantities::{degrees, radians};

use crate::CameraError;

/// Which angle of a place a text gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Latitude, north positive, -90 to 90 degrees.
    Latitude,
    /// Longitude, east positive, -180 to 180 degrees.
    Longitude,
}

impl Axis {
    fn letters(self) -> [char; 2] {
        match self {
            Self::Latitude => ['N', 'S'],
            Self::Longitude => ['E', 'W'],
        }
    }

    fn largest_deg(self) -> f64 {
        match self {
            Self::Latitude => 90.0,
            Self::Longitude => 180.0,
        }
    }

    fn refuse(self, text: &str, fault: &'static str) -> CameraError {
        let (axis, example) = match self {
            Self::Latitude => ("latitude", "37:22:47 N"),
            Self::Longitude => ("longitude", "122:05:03 W"),
        };
        CameraError::Angle { text: text.to_owned(), axis, fault, example }
    }
}

/// The angle (rad) that `text` gives: signed decimal degrees, or D:M:S with a hemisphere letter.
///
/// # Errors
///
/// If `text` has neither form, mixes a sign with a letter, has minutes or seconds of 60 or more, or leaves the range of `axis`.
pub fn parse_angle(text: &str, axis: Axis) -> Result<f64, CameraError> {
    let trimmed = text.trim();
    let angle_deg = match trimmed.contains(':') {
        true => sexagesimal(trimmed, axis),
        false => decimal(trimmed),
    }
    .map_err(|fault| axis.refuse(text, fault))?;
    match angle_deg.abs() <= axis.largest_deg() {
        true => Ok(radians(angle_deg)),
        false => Err(axis.refuse(text, "it is out of range")),
    }
}

fn decimal(text: &str) -> Result<f64, &'static str> {
    let body = text.strip_prefix(['-', '+']).unwrap_or(text);
    let value = unsigned(body).ok_or("the degrees are no decimal number")?;
    Ok(if text.starts_with('-') { -value } else { value })
}

fn sexagesimal(text: &str, axis: Axis) -> Result<f64, &'static str> {
    if text.contains(['-', '+']) {
        return Err("a sign stands in degrees, minutes and seconds");
    }
    let [positive, negative] = axis.letters();
    let (body, sign) = match (text.strip_suffix(positive), text.strip_suffix(negative)) {
        (Some(body), _) => (body, 1.0),
        (_, Some(body)) => (body, -1.0),
        _ => return Err("the hemisphere letter is missing or of the other angle"),
    };
    let parts: Vec<&str> = body.trim_end().split(':').collect();
    let [whole, minutes, seconds] = parts[..] else {
        return Err("degrees, minutes and seconds are not three numbers");
    };
    let [whole, minutes] = [whole, minutes].map(digits);
    let whole = whole.ok_or("the degrees are no whole number")?;
    let minutes = minutes.filter(|&part| part < 60.0).ok_or("the minutes are no whole number below 60")?;
    let seconds =
        unsigned(seconds).filter(|&part| part < 60.0).ok_or("the seconds are no number below 60")?;
    Ok(sign * (whole + (minutes * 60.0 + seconds) / 3600.0))
}

fn digits(text: &str) -> Option<f64> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| unsigned(text)).flatten()
}

fn unsigned(text: &str) -> Option<f64> {
    let plain = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    plain.then(|| text.parse().ok()).flatten()
}

/// Writes an angle (rad) as D:M:S and a hemisphere letter, with the seconds to 1e-6; [`parse_angle`] reads it back.
pub fn write_angle(angle: f64, axis: Axis) -> String {
    let [positive, negative] = axis.letters();
    let letter = if angle < 0.0 { negative } else { positive };
    // Whole microseconds first: rounding the seconds last would write 60.
    let micro = (degrees(angle.abs()) * 3.6e9).round() as u64;
    let (minutes, micro) = (micro / 60_000_000, micro % 60_000_000);
    let (whole, minutes) = (minutes / 60, minutes % 60);
    format!("{whole}:{minutes:02}:{:02}.{:06} {letter}", micro / 1_000_000, micro % 1_000_000)
}
