//! Numbers in cells, with a decimal point or a decimal comma.

/// Sign in front of the decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sign {
    Point,
    Comma,
}

/// A number as it stands in a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Number {
    pub value: f64,
    /// Sign in front of its decimals, where it has one.
    pub sign: Option<Sign>,
    /// Its decimal comma could stand between thousands as well: `1,234`.
    pub is_ambiguous: bool,
}

/// Why a cell holds no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NoNumber {
    /// Its text is none.
    Text,
    /// It has a decimal comma where commas stand between cells.
    CommaAmongCommas,
    /// It has a point and a comma, or two commas.
    Thousands,
}

impl NoNumber {
    /// What the user can do about it.
    pub fn help(self) -> Option<&'static str> {
        match self {
            Self::Text => None,
            Self::CommaAmongCommas => Some("write a decimal point, or put semicolons between cells"),
            Self::Thousands => Some("write numbers without marks between thousands"),
        }
    }
}

/// The finite number in `text`.
pub(crate) fn number(text: &str, commas_are_decimal: bool) -> Result<Number, NoNumber> {
    let is_part = |letter: char| letter.is_ascii_digit() || "+-.,eE".contains(letter);
    if !text.chars().all(is_part) {
        return Err(NoNumber::Text);
    }
    let (points, commas) = (text.matches('.').count(), text.matches(',').count());
    let value = |text: &str| text.parse().ok().filter(|value: &f64| value.is_finite()).ok_or(NoNumber::Text);
    match (points, commas) {
        (0, 0) => Ok(Number { value: value(text)?, sign: None, is_ambiguous: false }),
        (1, 0) => Ok(Number { value: value(text)?, sign: Some(Sign::Point), is_ambiguous: false }),
        (0, 1) if !commas_are_decimal => Err(NoNumber::CommaAmongCommas),
        (0, 1) => {
            let value = value(&text.replace(',', "."))?;
            Ok(Number { value, sign: Some(Sign::Comma), is_ambiguous: is_ambiguous(text) })
        }
        (_, 0) => Err(NoNumber::Text),
        _ => Err(NoNumber::Thousands),
    }
}

/// Whether a number with one comma reads as one with thousands too: one to three digits, a comma, three digits.
fn is_ambiguous(text: &str) -> bool {
    let digits = |part: &str| part.chars().all(|letter| letter.is_ascii_digit());
    let text = text.trim_start_matches(['+', '-']);
    let parts = text.split_once(',');
    parts.is_some_and(|(whole, decimals)| {
        (1..=3).contains(&whole.len()) && decimals.len() == 3 && digits(whole) && digits(decimals)
    })
}

#[cfg(test)]
mod tests {
    use super::{NoNumber, Number, Sign, number};

    #[test]
    fn points_and_commas() {
        let found = |text| number(text, true).map(|Number { value, sign, .. }| (value, sign));
        assert_eq!(found("-1.5e3"), Ok((-1500.0, Some(Sign::Point))));
        assert_eq!(found("+1,5e3"), Ok((1500.0, Some(Sign::Comma))));
        assert_eq!(found("7"), Ok((7.0, None)));
        for none in ["", "nan", "inf", "1e999", "0x10", "1_0", "1 0", "1.2.3", "−5", "-", "e", "."] {
            assert_eq!(number(none, true), Err(NoNumber::Text), "{none}");
        }
        for grouped in ["1.234,5", "1,234.5", "1,234,567", "1.234.567,0"] {
            assert_eq!(number(grouped, true), Err(NoNumber::Thousands), "{grouped}");
        }
        assert_eq!(number("1,5", false), Err(NoNumber::CommaAmongCommas));
    }

    #[test]
    fn three_decimals_may_be_thousands() {
        let is_ambiguous = |text| number(text, true).map(|number| number.is_ambiguous);
        for (text, expected) in [("1,234", true), ("-123,000", true), ("1,23", false), ("1234,567", false)] {
            assert_eq!(is_ambiguous(text), Ok(expected), "{text}");
        }
    }
}
