//! The header of an ENVI file: key = value, where a value in braces may go on over lines.

use std::path::Path;

use super::words::KEYS;
use crate::error::SurveyError;
use crate::read::gate;
use crate::read::refusal::field;
use crate::read::words::{Decider, Met, seen};

/// Most bytes of a header; those of pictures with many bands have some hundred thousand.
const MOST_BYTES: u64 = 1 << 22;

/// A header whose keys are decided.
pub struct Header<'a> {
    /// Path of the header.
    pub path: &'a Path,
    entries: Vec<Entry>,
}

/// A key with its value.
struct Entry {
    /// In small letters, with single spaces.
    key: String,
    /// The text without braces.
    value: String,
    /// Line of the key, from 1.
    line: usize,
}

impl Entry {
    fn place(&self) -> String {
        format!("header line {}, {}", self.line, seen(&self.key))
    }

    fn wrong(&self, path: &Path, expected: &str) -> SurveyError {
        let advice = "the header is damaged or of a kind not read here";
        field(path, self.place(), seen(&self.value), expected, advice)
    }
}

impl<'a> Header<'a> {
    /// Reads a header and decides its keys.
    ///
    /// # Errors
    /// If the header is damaged, or a key is refused or unknown, or stands there twice.
    pub fn read(path: &'a Path, decider: &mut Decider) -> Result<Self, SurveyError> {
        let bytes = gate::front(path, MOST_BYTES + 1)?;
        if bytes.len() as u64 > MOST_BYTES {
            let expected = format!("at most {MOST_BYTES} bytes");
            return Err(field(path, "header", "a longer one", expected, "name the header or the samples"));
        }
        let header = Self { path, entries: entries(path, &String::from_utf8_lossy(&bytes))? };
        for (at, entry) in header.entries.iter().enumerate() {
            if header.entries[..at].iter().any(|before| before.key == entry.key) {
                return Err(entry.wrong(path, "one value of a key"));
            }
            let (place, word) = (entry.place(), KEYS.of_name(&entry.key));
            decider.decide(Met { of: &KEYS, word, place: &place, name: &entry.key, value: &entry.value })?;
        }
        Ok(header)
    }

    /// The value of a key, without braces.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.entry(key).map(|entry| entry.value.as_str())
    }

    fn entry(&self, key: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.key == key)
    }

    /// The values of a key, which commas part.
    pub fn list(&self, key: &str) -> Option<Vec<&str>> {
        self.get(key).map(|value| value.split(',').map(str::trim).collect())
    }

    /// A whole number, 0 or more.
    pub fn count(&self, key: &str) -> Result<Option<u64>, SurveyError> {
        let number = |text: &str| text.parse().map_err(|_| self.wrong(key, "a whole number, 0 or more"));
        self.get(key).map(number).transpose()
    }

    /// A whole number that must be there.
    pub fn needed(&self, key: &str) -> Result<u64, SurveyError> {
        self.count(key)?.ok_or_else(|| self.missing(key))
    }

    /// A finite number of a band: one number, or one for each of so many bands.
    pub fn of_band(&self, key: &str, [band, bands]: [usize; 2]) -> Result<Option<f64>, SurveyError> {
        let Some(list) = self.list(key) else { return Ok(None) };
        let text = match list.as_slice() {
            [one] => one,
            each if each.len() == bands => each[band],
            _ => return Err(self.wrong(key, "one number, or one for each band")),
        };
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        number.map(Some).ok_or_else(|| self.wrong(key, "a finite number"))
    }

    /// The error for a value that cannot be used.
    pub fn wrong(&self, key: &str, expected: &str) -> SurveyError {
        self.entry(key).map_or_else(|| self.missing(key), |entry| entry.wrong(self.path, expected))
    }

    /// The error for a key that is not there.
    pub fn missing(&self, key: &str) -> SurveyError {
        let advice = "the header is incomplete or of a kind not read here";
        field(self.path, format!("header, {key}"), "nothing", "a value", advice)
    }
}

fn entries(path: &Path, text: &str) -> Result<Vec<Entry>, SurveyError> {
    let damaged = |line: usize, found: &str, expected: &str| {
        let advice = "the header is damaged: correct it or fetch it again";
        Err(field(path, format!("header line {line}"), seen(found), expected, advice))
    };
    let (mut out, mut lines) = (Vec::new(), text.lines().enumerate().skip(1));
    while let Some((index, text)) = lines.next() {
        let (line, text) = (index + 1, text.trim());
        if text.is_empty() || text.starts_with(';') {
            continue;
        }
        let Some((key, value)) = text.split_once('=') else { return damaged(line, text, "KEY = VALUE") };
        let key = key.split_whitespace().collect::<Vec<_>>().join(" ").to_ascii_lowercase();
        let value = value.trim();
        let Some(inside) = value.strip_prefix('{') else {
            out.push(Entry { key, value: value.to_owned(), line });
            continue;
        };
        let (mut inside, mut is_closed) = (inside.to_owned(), inside.contains('}'));
        while !is_closed {
            let more = lines.next().map(|(_, more)| more).filter(|more| !more.contains('{'));
            let Some(more) = more else { return damaged(line, text, "a closing brace") };
            inside.push(' ');
            inside.push_str(more.trim());
            is_closed = more.contains('}');
        }
        let Some((value, "")) = inside.split_once('}').map(|(value, rest)| (value, rest.trim())) else {
            return damaged(line, text, "nothing behind the closing brace");
        };
        out.push(Entry { key, value: value.trim().to_owned(), line });
    }
    Ok(out)
}
