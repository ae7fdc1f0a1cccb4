//! A range of whole numbers as a person writes it.

use std::fmt::{self, Display};
use std::ops::Range;
use std::str::FromStr;

/// `A..B`, `A..`, `..B` or `N`: a half-open range of whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span {
    start: Option<u64>,
    end: Option<u64>,
}

impl Span {
    /// The range, where `all` is what open ends mean. `None` if it is empty or leaves `all`.
    pub fn within(self, all: &Range<u64>) -> Option<Range<u64>> {
        let range = self.start.unwrap_or(all.start)..self.end.unwrap_or(all.end);
        (!range.is_empty() && range.start >= all.start && range.end <= all.end).then_some(range)
    }
}

impl FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong =
            || format!("expected A..B (A up to, not including, B), A.., ..B or one number, not `{text}`");
        let number = |text: &str| text.parse::<u64>().map_err(|_| wrong());
        let open = |text: &str| if text.is_empty() { Ok(None) } else { number(text).map(Some) };
        let span = match text.split_once("..") {
            Some((start, end)) => Self { start: open(start)?, end: open(end)? },
            None => {
                let one = number(text)?;
                Self { start: Some(one), end: Some(one.checked_add(1).ok_or_else(wrong)?) }
            }
        };
        match span {
            Self { start: Some(start), end: Some(end) } if start >= end => Err(wrong()),
            span => Ok(span),
        }
    }
}

impl Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |bound: Option<u64>| bound.map(|bound| bound.to_string()).unwrap_or_default();
        write!(f, "{}..{}", text(self.start), text(self.end))
    }
}

#[cfg(test)]
mod tests {
    use super::Span;

    #[test]
    fn spans() {
        let all = 0..10;
        for (text, expected) in [("0..2", 0..2), ("3..", 3..10), ("..4", 0..4), ("7", 7..8), ("..", 0..10)] {
            assert_eq!(text.parse::<Span>().unwrap().within(&all), Some(expected), "{text}");
        }
        for outside in ["0..11", "10", "12.."] {
            assert_eq!(outside.parse::<Span>().unwrap().within(&all), None, "{outside}");
        }
        for wrong in ["", "a..b", "2..2", "3..1", "-1..2", "1.5", "0..2..4", "18446744073709551615"] {
            assert!(wrong.parse::<Span>().is_err(), "{wrong}");
        }
    }
}
