//! Text of a file or a command line, safe to show.

use std::borrow::Cow;

/// `text` with its control characters made visible: a byte that would move a cursor or turn the order of letters is shown as
/// `\u{1b}`. Line breaks and tabs stay.
///
/// ```
/// assert_eq!(text::visible("title \u{1b}[31m red\n"), "title \\u{1b}[31m red\n");
/// ```
pub fn visible(text: &str) -> Cow<'_, str> {
    shown(text, |c| is_control(c) && c != '\n' && c != '\t', |c| format!("\\u{{{:x}}}", u32::from(c)))
}

/// The same for text that must stay in its line, as in the head of a table: line breaks and tabs are shown too.
///
/// ```
/// assert_eq!(text::visible_line("a\nb"), "a\\u{a}b");
/// ```
pub fn visible_line(text: &str) -> Cow<'_, str> {
    shown(text, is_control, |c| format!("\\u{{{:x}}}", u32::from(c)))
}

/// A JSON document with control characters in the escapes of JSON: it stays the same document.
///
/// ```
/// assert_eq!(text::visible_json("\"\u{9b}31m\""), "\"\\u009b31m\"");
/// ```
pub fn visible_json(document: &str) -> Cow<'_, str> {
    shown(document, |c| is_control(c) && c != '\n' && c != '\t', |c| format!("\\u{:04x}", u32::from(c)))
}

/// C0, DEL and C1 (Unicode's category Cc), line and paragraph separators, and whatever turns the order of letters (UAX 9).
fn is_control(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn shown(text: &str, is_hidden: impl Fn(char) -> bool, escaped: impl Fn(char) -> String) -> Cow<'_, str> {
    if !text.chars().any(&is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_hidden(c) { shown.push_str(&escaped(c)) } else { shown.push(c) }
    }
    Cow::Owned(shown)
}

#[cfg(test)]
mod tests {
    use super::{visible, visible_json, visible_line};

    #[test]
    fn nothing_that_steers_a_terminal_is_left() {
        for code in (0..=0x2070).filter_map(char::from_u32) {
            let text = format!("a{code}b");
            let steers = code < ' '
                || ('\u{7f}'..='\u{9f}').contains(&code)
                || "\u{202e}\u{2066}\u{2028}".contains(code);
            assert_eq!(visible_line(&text).contains(code), !visible_line(&text).contains("\\u{"), "{code:?}");
            assert!(!(steers && visible_line(&text).contains(code)), "{code:?}");
            assert_eq!(
                visible(&text).contains(code),
                visible_line(&text).contains(code) || "\n\t".contains(code)
            );
        }
        for plain in ["", "plain", "déjà vu, 月, 🌕, \u{301}", "rows\n\tand tabs"] {
            assert_eq!(visible(plain), plain);
        }
        assert_eq!(visible_json("{\"a\": \"\u{202e}\"}\n"), "{\"a\": \"\\u202e\"}\n");
    }
}
