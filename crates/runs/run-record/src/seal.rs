//! The last key of a document: a hash of everything before it. Who reads the document sees whether it was changed since.
//!
//! A seal finds damage and edits by hand. It is no signature: whoever changes a document on purpose can seal it again.

use serde::Deserialize;

use crate::hash;

/// The key of the seal, as it is written.
const KEY: &str = "\"seal\"";

/// The end of a document from its seal on, with a brace in front.
#[derive(Deserialize)]
struct End {
    seal: String,
}

/// The document `text`, a JSON object of at least one key, with its seal. It is laid out as it was: on one line or on many.
pub fn sealed(text: &str) -> String {
    let body = text.trim_end().strip_suffix('}').map_or(text, str::trim_end);
    let end_of_line = if body.contains('\n') { "\n" } else { "" };
    let indent = if body.contains('\n') { "\n  " } else { "" };
    let before = format!("{body},{indent}");
    let seal = hash(before.as_bytes());
    let space = if indent.is_empty() { "" } else { " " };
    format!("{before}{KEY}:{space}\"{seal}\"{end_of_line}}}{end_of_line}")
}

/// Whether the document is as it was when it was sealed; a document without a seal is not.
pub fn is_as_sealed(text: &str) -> bool {
    let Some(place) = text.rfind(KEY) else { return false };
    let (before, end) = text.split_at(place);
    serde_json::from_str::<End>(&format!("{{{end}")).is_ok_and(|end| end.seal == hash(before.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::{is_as_sealed, sealed};

    #[test]
    fn every_change_breaks_the_seal() {
        for text in ["{\n  \"a\": 1,\n  \"b\": \"seal\"\n}\n", "{\"a\":1,\"b\":\"\\\"seal\\\"\"}"] {
            let whole = sealed(text);
            assert!(is_as_sealed(&whole), "{whole}");
            assert!(serde_json::from_str::<serde_json::Value>(&whole).is_ok(), "{whole}");
            let places = whole.char_indices().filter(|(_, letter)| !letter.is_whitespace());
            for (place, letter) in places {
                let mut changed = whole.clone();
                let other = if letter == '7' { "8" } else { "7" };
                changed.replace_range(place..place + letter.len_utf8(), other);
                assert!(!is_as_sealed(&changed), "{changed}");
            }
            assert!(!is_as_sealed(text), "without a seal");
        }
    }
}
