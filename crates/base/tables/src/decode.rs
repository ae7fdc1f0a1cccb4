//! From the bytes of a file to text with one kind of line end.

use std::path::Path;
use std::sync::Arc;

use diagnostics::{Place, Problem, Problems, Source};
use limits::Limit;

/// Reads the text of a table of at most [`Limit::ListBytes`]; a fault goes to `problems`.
pub fn read_text(path: &Path, problems: &Problems) -> Option<Arc<Source>> {
    let name = path.display().to_string();
    match files::read_all(path, Limit::ListBytes) {
        Ok(bytes) => decode(&name, bytes, problems),
        Err(error) => {
            problems.push(Problem::of_file(name, error.to_string()));
            None
        }
    }
}

/// The text in `bytes`: UTF-8 without its byte order mark, and with `\n` at the end of every line. Other encodings are
/// refused by name, in `problems`.
pub fn decode(name: &str, bytes: Vec<u8>, problems: &Problems) -> Option<Arc<Source>> {
    if let Some(encoding) = other_encoding(&bytes) {
        let problem = Problem::of_file(name, format!("the file is {encoding} text"));
        problems.push(problem.expected("UTF-8 text").help("save the file as UTF-8"));
        return None;
    }
    let text = String::from_utf8(bytes).map_err(|error| problems.push(not_text(name, &error))).ok()?;
    Some(Arc::new(Source { name: name.into(), text: with_plain_ends(text) }))
}

/// Encodings of Windows that a byte order mark names, or the zeros between their letters.
fn other_encoding(bytes: &[u8]) -> Option<&'static str> {
    // The marks of UTF-32 begin with those of UTF-16.
    let marks: [(&[u8], &str); 4] = [
        (&[0xff, 0xfe, 0, 0], "UTF-32"),
        (&[0, 0, 0xfe, 0xff], "UTF-32"),
        (&[0xff, 0xfe], "UTF-16"),
        (&[0xfe, 0xff], "UTF-16"),
    ];
    if let Some((_, name)) = marks.into_iter().find(|(mark, _)| bytes.starts_with(mark)) {
        return Some(name);
    }
    let head = &bytes[..bytes.len().min(64) & !1];
    let zeros = |odd: usize| head.iter().skip(odd).step_by(2).filter(|byte| **byte == 0).count();
    let half = head.len() / 2;
    let is_wide = half > 1 && [0, 1].into_iter().any(|odd| zeros(odd) == half && zeros(1 - odd) == 0);
    is_wide.then_some("UTF-16")
}

fn not_text(name: &str, error: &std::string::FromUtf8Error) -> Problem {
    let good = error.utf8_error().valid_up_to();
    // What comes before the byte is text, and shows the line.
    let text = String::from_utf8_lossy(&error.as_bytes()[..good]).replace("\r\n", "\n").replace('\r', "\n");
    let place = Place { span: text.len()..text.len(), source: Arc::new(Source { name: name.into(), text }) };
    let title = format!("not text: byte {good} is not UTF-8");
    Problem::at(&place, title).expected("UTF-8 text").help("save the file as UTF-8")
}

fn with_plain_ends(text: String) -> String {
    let text = match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    };
    if text.contains('\r') { text.replace("\r\n", "\n").replace('\r', "\n") } else { text }
}
