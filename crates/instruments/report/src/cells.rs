//! Numbers as they stand in tables.

use quantities::fixed;

/// A whole number in groups of three digits, by a narrow space that does not break.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> = (0..digits.len().div_ceil(3))
        .rev()
        .map(|group| &digits[digits.len().saturating_sub(3 * group + 3)..digits.len() - 3 * group])
        .collect();
    groups.join("\u{202f}")
}

/// A share in percent: one place, and never 0 or 100 but where it is.
pub(crate) fn percent(share: f64) -> String {
    let value = 100.0 * share;
    match value {
        _ if value > 0.0 && value < 0.05 => "< 0.1 %".into(),
        _ if value > 99.95 && value < 100.0 => "> 99.9 %".into(),
        _ => format!("{value:.1} %"),
    }
}

/// Seconds in the unit that suits them, with a sign.
pub(crate) fn duration(seconds: f64) -> String {
    let size = seconds.abs();
    let (scale, unit) = match size {
        _ if size >= 1.0 => (1.0, "s"),
        _ if size >= 1e-3 => (1e3, "ms"),
        _ if size >= 1e-6 => (1e6, "µs"),
        _ => (1e9, "ns"),
    };
    format!("{} {unit}", shortened(seconds * scale, 2))
}

/// As many places, always: readings that change stay where they are.
pub(crate) fn placed(value: f64, places: usize) -> String {
    fixed(value, places).replace('-', "\u{2212}")
}

/// At most so many places, no zeros at the end.
pub(crate) fn shortened(value: f64, places: usize) -> String {
    let text = placed(value, places);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::{duration, grouped, percent, placed, shortened};

    #[test]
    fn numbers() {
        for (number, text) in [(0, "0"), (999, "999"), (1000, "1 000"), (1_234_567, "1 234 567")] {
            assert_eq!(grouped(number), text.replace(' ', "\u{202f}"));
        }
        assert_eq!(grouped(u64::MAX).chars().filter(|c| c.is_ascii_digit()).count(), 20);
        assert_eq!([percent(0.0), percent(1e-9), percent(1.0005)], ["0.0 %", "< 0.1 %", "100.0 %"]);
        assert_eq!([percent(0.9999999), percent(0.5)], ["> 99.9 %", "50.0 %"]);
        assert_eq!([duration(3e-7), duration(-5e-8), duration(0.0)], ["300 ns", "\u{2212}50 ns", "0 ns"]);
        assert_eq!([duration(0.28), duration(2.5), duration(4e-6)], ["280 ms", "2.5 s", "4 µs"]);
        assert_eq!([placed(2.0, 3), placed(-0.001, 2), placed(-1.5, 2)], ["2.000", "0.00", "\u{2212}1.50"]);
        assert_eq!([shortened(-0.001, 2), shortened(120.0, 0)], ["0", "120"]);
    }
}
