//! Numbers as a person reads them.

/// `value` with so many decimal places; what is 0 in them has no sign.
pub fn fixed(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    match text.strip_prefix('-') {
        Some(size) if size.bytes().all(|c| matches!(c, b'0' | b'.')) => size.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::fixed;

    #[test]
    fn nothing_has_no_sign() {
        assert_eq!([-0.0, -0.0004, -1e-17, 0.0].map(|value| fixed(value, 3)), ["0.000"; 4]);
        assert_eq!([fixed(-0.4, 0), fixed(-0.6, 0), fixed(-0.0006, 3)], ["0", "-1", "-0.001"]);
        assert_eq!(fixed(f64::NEG_INFINITY, 1), "-inf");
    }
}
