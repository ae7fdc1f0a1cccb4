//! What people write and read: ranges of numbers ([`Span`]), tables in columns, numbers and places in words, bytes in base64, control characters made
//! visible ([`visible`]), what an XML reader is not given ([`xml`]), JSON of other people ([`read_json`]).

mod base64;
mod json;
mod span;
mod visible;
pub mod xml;

pub use base64::{base64, data_url};
pub use json::read_json;
pub use span::Span;
pub use visible::{visible, visible_json, visible_line};

/// Bytes of a text without the byte order mark of UTF-8, which some programs write in front.
pub fn without_byte_order_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// A rate with two digits at least, so that a slow one is no zero.
pub fn rate(value: f64) -> String {
    let places = [10.0, 1e2, 1e3, 1e4, 1e5].iter().position(|scale| value * scale >= 9.95);
    format!("{value:.*}", 1 + places.unwrap_or(0))
}

/// Frames by their numbers: `frame 3`, `frames 0, 3`.
pub fn named_frames(frames: &[u64]) -> String {
    let numbers: Vec<String> = frames.iter().map(u64::to_string).collect();
    format!("{} {}", if frames.len() == 1 { "frame" } else { "frames" }, numbers.join(", "))
}

/// Signals by their names; where there are many, the patterns that asked for them: `tg.* (571 signals)`.
pub fn named_signals<N: AsRef<str>>(names: &[N], asked: &[String]) -> String {
    const MOST_NAMED: usize = 12;
    match names.len() {
        0..=MOST_NAMED => names.iter().map(AsRef::as_ref).collect::<Vec<_>>().join(", "),
        count => format!("{} ({count} signals)", asked.join(", ")),
    }
}

/// Columns of text, each as wide as its widest cell. The last column is not padded.
pub fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

/// Rows as a table of Markdown, the first with the names of the columns. A bar within a cell is written so that it ends none.
pub fn markdown(rows: &[Vec<String>]) -> String {
    let mut text = String::new();
    for (number, row) in rows.iter().enumerate() {
        let cells: Vec<String> = row.iter().map(|cell| cell.replace('|', "\\|")).collect();
        text += &format!("| {} |\n", cells.join(" | "));
        if number == 0 {
            text += &format!("|{}\n", "---|".repeat(row.len()));
        }
    }
    text
}

/// `value` with at most `places` decimals, no zeros behind: lengths in metres have three, degrees six.
pub fn shortened(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".into() } else { short.into() }
}

/// A latitude (degrees) with its side of the equator, as [`shortened`] has it: `85 S`.
pub fn latitude(degrees: f64, places: usize) -> String {
    on_side(degrees, places, ["N", "S"])
}

/// A longitude (degrees, positive east) with its side of the prime meridian: `20.5 W`.
pub fn longitude(degrees: f64, places: usize) -> String {
    on_side(degrees, places, ["E", "W"])
}

fn on_side(degrees: f64, places: usize, [positive, negative]: [&str; 2]) -> String {
    let text = shortened(degrees, places);
    match text.strip_prefix('-') {
        Some(rest) => format!("{rest} {negative}"),
        None => format!("{text} {positive}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{latitude, longitude, markdown, named_frames, rate, shortened};

    #[test]
    fn one_frame_is_a_frame() {
        assert_eq!([named_frames(&[3]), named_frames(&[0, 3])], ["frame 3", "frames 0, 3"]);
    }

    #[test]
    fn slow_rates_are_no_zeros() {
        let said = [0.0, 1234.56, 24.31, 0.996, 0.0433, 0.00012, 1e-9].map(rate);
        assert_eq!(said, ["0.0", "1234.6", "24.3", "1.0", "0.043", "0.00012", "0.0"].map(str::to_owned));
    }

    #[test]
    fn a_bar_in_a_cell_ends_no_cell() {
        let rows = [["sun", "mean |z| (m)"], ["own", "1.5"]].map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(markdown(&rows), "| sun | mean \\|z\\| (m) |\n|---|---|\n| own | 1.5 |\n");
    }

    #[test]
    fn places_have_a_side() {
        assert_eq!([-85.0, 20.25, -0.000_01].map(|angle| latitude(angle, 3)), ["85 S", "20.25 N", "0 N"]);
        assert_eq!([-5.5, 180.0].map(|angle| longitude(angle, 6)), ["5.5 W", "180 E"]);
    }

    #[test]
    fn lengths_to_the_millimetre() {
        let short = [6.0, 150_550.635_443_332_93, -0.000_01, 1000.0, -89.875_000_000_000_01];
        assert_eq!(
            short.map(|value| shortened(value, 3)),
            ["6", "150550.635", "0", "1000", "-89.875"].map(str::to_owned)
        );
        assert_eq!(shortened(1e-7, 6), "0");
    }
}
