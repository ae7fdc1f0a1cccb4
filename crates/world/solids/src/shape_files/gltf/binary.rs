//! The chunks of a binary glTF file.

use diagnostics::{Problem, ProblemList};

/// Magic, version and length.
const HEAD: usize = 12;
const JSON: [u8; 4] = *b"JSON";
const BUFFER: [u8; 4] = *b"BIN\0";

/// The JSON of a file, and its buffer where it has one.
///
/// # Errors
/// If lengths contradict the file, or a chunk is of another kind.
pub(super) fn chunks<'b>(name: &str, bytes: &'b [u8]) -> Result<(&'b [u8], Option<&'b [u8]>), ProblemList> {
    let wrong = |title: String, expected: &str| Err(Problem::of_file(name, title).expected(expected).into());
    let word = |at: usize| {
        bytes.get(at..).and_then(|bytes| bytes.first_chunk()).map(|word| u32::from_le_bytes(*word))
    };
    match (word(4), word(8)) {
        (Some(2), Some(length)) if length as usize == bytes.len() => {}
        (Some(2), Some(length)) => {
            let title = format!("the head says {length} bytes, but the file has {}", bytes.len());
            return wrong(title, "a whole file");
        }
        (Some(version), _) => {
            return wrong(format!("binary glTF of version {version} is not read"), "version 2");
        }
        (None, _) => return wrong(format!("binary glTF of {} bytes", bytes.len()), "a head of 12 bytes"),
    }
    let mut chunks = Vec::new();
    let mut left = &bytes[HEAD..];
    while let Some((length, behind)) = left.split_first_chunk() {
        let length = u32::from_le_bytes(*length) as usize;
        let Some((kind, behind)) = behind.split_first_chunk::<4>() else { break };
        let Some((chunk, behind)) = behind.split_at_checked(length) else {
            let title = format!("a chunk of {length} bytes, but {} are left", behind.len());
            return wrong(title, "a whole file");
        };
        chunks.push((*kind, chunk));
        left = behind;
    }
    match chunks[..] {
        [(JSON, json)] if left.is_empty() => Ok((json, None)),
        [(JSON, json), (BUFFER, buffer)] if left.is_empty() => Ok((json, Some(buffer))),
        _ => {
            wrong("other chunks than JSON and BIN".into(), "one chunk of JSON, and one BIN or none behind it")
        }
    }
}
