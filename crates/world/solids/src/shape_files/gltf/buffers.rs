//! Bytes that a glTF file refers to: inside it, beside it, or written out in its JSON.

use std::path::{Path, PathBuf};

use diagnostics::ProblemList;
use files::{folder_of, leads_outside};
use limits::Limit;

use super::json::Json;

/// The buffers of a file; each is read when it is first asked for.
pub(super) struct Buffers<'a> {
    folder: &'a Path,
    entries: Vec<Json<'a>>,
    chunk: Option<&'a [u8]>,
    read: Vec<Option<Vec<u8>>>,
    files: Vec<PathBuf>,
    /// Bytes that are read so far.
    bytes: u64,
}

impl<'a> Buffers<'a> {
    /// The buffers of the file at `path`; `chunk` is the buffer inside a binary file.
    ///
    /// # Errors
    /// If the list of buffers cannot be read.
    pub fn new(path: &'a Path, root: &Json<'a>, chunk: Option<&'a [u8]>) -> Result<Self, ProblemList> {
        let entries = root.list("buffers")?;
        let read = entries.iter().map(|_| None).collect();
        Ok(Self { folder: folder_of(path), entries, chunk, read, files: Vec::new(), bytes: 0 })
    }

    /// The files that were read.
    pub fn into_files(self) -> Vec<PathBuf> {
        self.files
    }

    /// The bytes of a buffer; `asked` refers to it.
    ///
    /// # Errors
    /// If there is none of that number, or its bytes cannot be had.
    pub fn bytes(&mut self, number: usize, asked: &Json) -> Result<&[u8], ProblemList> {
        let Some(entry) = self.entries.get(number).cloned() else {
            return Err(asked
                .problem(format!("buffer {number} does not exist"), "the number of a buffer")
                .into());
        };
        if self.read[number].is_none() {
            let bytes = self.read(number, &entry)?;
            self.bytes += bytes.len() as u64;
            if !Limit::ShapeBytes.allows(self.bytes) {
                let expected = format!("at most {} bytes", Limit::ShapeBytes.value());
                return Err(entry
                    .problem("the buffers are too large", expected)
                    .help(Limit::ShapeBytes.to_string())
                    .into());
            }
            self.read[number] = Some(bytes);
        }
        Ok(self.read[number].as_deref().unwrap_or_default())
    }

    fn read(&mut self, number: usize, entry: &Json) -> Result<Vec<u8>, ProblemList> {
        entry.expect_known(&["uri", "byteLength"], &[])?;
        let length = entry.required("byteLength")?.whole()?;
        let mut bytes = match (entry.get("uri"), self.chunk) {
            (None, Some(chunk)) if number == 0 => chunk.to_vec(),
            (None, _) => return Err(entry.problem("no `uri`", "a file, or data in base64").into()),
            (Some(uri), _) => match uri.text()?.strip_prefix("data:") {
                Some(data) => from_data(&uri, data)?,
                None => self.bytes_of_file(&uri)?,
            },
        };
        if bytes.len() < length {
            let title = format!("{length} bytes are promised, {} are there", bytes.len());
            return Err(entry.problem(title, "a whole buffer").into());
        }
        bytes.truncate(length);
        Ok(bytes)
    }

    fn bytes_of_file(&mut self, uri: &Json) -> Result<Vec<u8>, ProblemList> {
        const INSIDE: &str = "a file in the folder of this file, or below";
        let path = decoded(uri.text()?)
            .filter(|path| is_plain(path))
            .ok_or_else(|| uri.problem("leads elsewhere", INSIDE))?;
        let path = self.folder.join(path);
        if let Some(found) = leads_outside(self.folder, &path) {
            return Err(uri.problem(format!("leads to {}", found.display()), INSIDE).into());
        }
        let bytes = files::read_all(&path, Limit::ShapeBytes)
            .map_err(|error| uri.problem(error.to_string(), INSIDE))?;
        self.files.push(path);
        Ok(bytes)
    }
}

/// Whether a path names files below a folder alone: no scheme, no root, no way up.
fn is_plain(path: &str) -> bool {
    let is_name = |piece: &str| !piece.is_empty() && piece != "..";
    !path.contains([':', '\\', '\0']) && path.split('/').all(is_name)
}

/// A path with its `%20` and the like as the characters that they are.
fn decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut pieces = uri.split('%');
    bytes.extend(pieces.next()?.bytes());
    for piece in pieces {
        let (code, rest) = piece.split_at_checked(2)?;
        bytes.push(u8::from_str_radix(code, 16).ok()?);
        bytes.extend(rest.bytes());
    }
    String::from_utf8(bytes).ok()
}

/// The bytes of `data:MEDIA;base64,DIGITS`, without the scheme.
fn from_data(uri: &Json, data: &str) -> Result<Vec<u8>, ProblemList> {
    let digits =
        data.split_once(',').filter(|(media, _)| media.ends_with(";base64")).map(|(_, digits)| digits);
    let bytes = digits.and_then(from_base64);
    bytes.ok_or_else(|| {
        uri.problem("data that cannot be read", "data:application/octet-stream;base64,...").into()
    })
}

/// Bytes of digits of base64 (RFC 4648): four digits for three bytes, and `=` for those that are not there.
fn from_base64(digits: &str) -> Option<Vec<u8>> {
    let digits = digits.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(digits.len() / 4 * 3 + 2);
    for four in digits.chunks(4) {
        let mut word = 0_u32;
        for digit in four {
            let value = match digit {
                b'A'..=b'Z' => digit - b'A',
                b'a'..=b'z' => digit - b'a' + 26,
                b'0'..=b'9' => digit - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => return None,
            };
            word = word << 6 | u32::from(value);
        }
        match four.len() {
            4 => bytes.extend(&word.to_be_bytes()[1..]),
            3 => bytes.extend(&(word >> 2).to_be_bytes()[2..]),
            2 => bytes.extend(&(word >> 4).to_be_bytes()[3..]),
            _ => return None,
        }
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::{decoded, from_base64, is_plain};

    /// The examples of RFC 4648, section 10.
    #[test]
    fn base64_of_every_length() {
        let pairs = [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYg==", "foob"),
            ("Zm9vYmFy", "foobar"),
        ];
        for (digits, bytes) in pairs {
            assert_eq!(from_base64(digits).as_deref(), Some(bytes.as_bytes()), "{digits}");
        }
        assert_eq!(from_base64("+/+/"), Some(vec![0xfb, 0xff, 0xbf]));
        assert!(from_base64("Zm9v Zm9v").is_none() && from_base64("Z").is_none());
    }

    #[test]
    fn paths_that_stay_below() {
        for good in ["a.bin", "buffers/a.bin", "a b.bin", "..a"] {
            assert!(is_plain(good), "{good}");
        }
        for bad in ["", "/etc/passwd", "../a.bin", "a/../../b", "http://a/b", "c:a", "a\\b", "a//b"] {
            assert!(!is_plain(bad), "{bad}");
        }
        assert_eq!(decoded("a%20b%2F%2E%2e").as_deref(), Some("a b/.."));
        assert!(decoded("a%2").is_none() && decoded("a%zz").is_none() && decoded("%ff").is_none());
    }
}
