//! Bytes of a file as text.

use diagnostics::{Problem, ProblemList};

use super::mesh::At;

/// A word and the bytes of the text that it takes.
pub(super) type Word<'t> = (&'t str, At);

/// The words of a piece of a text.
pub(super) fn words<'t>(text: &'t str, piece: &'t str) -> impl Iterator<Item = Word<'t>> {
    let start_of = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    piece.split_whitespace().map(move |word| (word, start_of(word)..start_of(word) + word.len()))
}

/// The bytes from the first of some words to the end of the last.
pub(super) fn extent(words: &[Word]) -> At {
    words.first().map_or(0, |(_, first)| first.start)..words.last().map_or(0, |(_, last)| last.end)
}

/// The text of `bytes`: UTF-8, with or without a byte order mark, or Latin-1 if they are no UTF-8. Every line ends with a line
/// feed; a carriage return before it stays.
///
/// # Errors
/// UTF-16, and a byte of 0: no text has one.
pub(super) fn text_of(name: &str, bytes: &[u8]) -> Result<String, ProblemList> {
    let refused = |title: String| Err(Problem::of_file(name, title).help("save the file as UTF-8").into());
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return refused("the text is UTF-16".into());
    }
    if let Some(at) = bytes.iter().position(|&byte| byte == 0) {
        return refused(format!("not text: byte {at} is 0"));
    }
    let bytes = text::without_byte_order_mark(bytes);
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    };
    Ok(with_line_feeds(text))
}

/// The same with a line feed for each carriage return that has none behind it.
fn with_line_feeds(text: String) -> String {
    let mut pieces = text.split('\r');
    let mut made = String::with_capacity(text.len());
    made.extend(pieces.next());
    for piece in pieces {
        made.push(if piece.starts_with('\n') { '\r' } else { '\n' });
        made.push_str(piece);
    }
    made
}

#[cfg(test)]
mod tests {
    use super::text_of;

    #[test]
    fn texts_of_every_age() {
        let read = |bytes: &[u8]| text_of("a.obj", bytes).unwrap();
        let refused = |bytes: &[u8]| text_of("a.obj", bytes).unwrap_err().to_string();
        assert_eq!(read(b"\xef\xbb\xbfv 1"), "v 1");
        assert_eq!(read(b"# \xe9\nv"), "# é\nv");
        assert_eq!(read("# é\nv".as_bytes()), "# é\nv");
        assert_eq!(read(b"a\rb\r\nc\nd\r"), "a\nb\r\nc\nd\n");
        for wide in [&b"\xff\xfev\0"[..], b"\xfe\xff\0v"] {
            assert!(refused(wide).contains("the text is UTF-16"));
        }
        assert!(refused(b"v \0").contains("not text: byte 2 is 0"));
    }
}
