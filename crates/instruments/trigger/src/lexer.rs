//! Words, numbers and signs of a condition, each with its place.

use std::ops::Range;

/// What stands at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Token<'t> {
    /// A name or a word.
    Word(&'t str),
    /// A number, which is finite.
    Number(f64),
    /// `..`, `/` or a comparison.
    Sign(&'t str),
    /// What belongs to no condition.
    Stray(&'t str),
    /// The end of the text.
    End,
}

impl Token<'_> {
    /// As it is told in an error.
    pub fn told(&self) -> String {
        match self {
            Self::Word(text) | Self::Sign(text) | Self::Stray(text) => format!("`{text}`"),
            Self::Number(value) => format!("`{value}`"),
            Self::End => "the end".into(),
        }
    }
}

/// Signs, the longer first.
const SIGNS: [&str; 8] = ["..", ">=", "<=", "!=", ">", "<", "=", "/"];

/// The tokens of `text` in order, the end among them.
pub fn tokens(text: &str) -> Vec<(Token<'_>, Range<usize>)> {
    let mut found = Vec::new();
    let mut at = 0;
    loop {
        at += text[at..].len() - text[at..].trim_start().len();
        if at == text.len() {
            found.push((Token::End, at..at));
            return found;
        }
        let (token, length) = first(&text[at..]);
        found.push((token, at..at + length));
        at += length;
    }
}

/// The token at the start of `text`, which begins with no space, and its length.
fn first(text: &str) -> (Token<'_>, usize) {
    if let Some(sign) = SIGNS.into_iter().find(|sign| text.starts_with(sign)) {
        return (Token::Sign(&text[..sign.len()]), sign.len());
    }
    let length = number_length(text);
    if let Some(value) = text[..length].parse::<f64>().ok().filter(|value| value.is_finite()) {
        return (Token::Number(value), length);
    }
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    let length = text.find(|c| !is_part(c)).unwrap_or(text.len());
    let begins = text.starts_with(char::is_alphabetic);
    match (begins, length) {
        (true, _) => (Token::Word(&text[..length]), length),
        (false, 0) => {
            let length = text.chars().next().map_or(0, char::len_utf8);
            (Token::Stray(&text[..length]), length)
        }
        (false, _) => (Token::Stray(&text[..length]), length),
    }
}

/// Length of the number at the start of `text`: two points end it, since they part the ends of a window.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| from + bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let signed = |at: usize| at + usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let mut end = digits(signed(0));
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1) != Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let exponent = signed(end + 1);
        if digits(exponent) > exponent {
            end = digits(exponent);
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::{Token, tokens};

    #[test]
    fn numbers_end_before_two_points() {
        let found: Vec<Token<'_>> =
            tokens("tg.height in -1.5..2e3/m").into_iter().map(|(token, _)| token).collect();
        let expected = [
            Token::Word("tg.height"),
            Token::Word("in"),
            Token::Number(-1.5),
            Token::Sign(".."),
            Token::Number(2000.0),
            Token::Sign("/"),
            Token::Word("m"),
            Token::End,
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn what_belongs_nowhere_is_stray() {
        for text in ["§", "-", "1e999", "_a", "é§"] {
            let found = tokens(text);
            let has_stray = found.iter().any(|(token, _)| matches!(token, Token::Stray(_)));
            assert!(has_stray && found.last().is_some_and(|(token, _)| *token == Token::End), "{found:?}");
        }
    }
}
