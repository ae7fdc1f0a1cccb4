//! The journal of a landscape's edits, by which they are undone, to the byte.
//!
//! A line of JSON an edit, in a file beside the landscape: `NAME.toml.journal`. An edit keeps what was there, what came instead and
//! where, so any number of edits is undone, the last one first. The hash of the whole text guards against a text that was changed by
//! hand since.

use serde_json::{Value, json};

/// An edit that was made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// What was done, in words.
    pub what: String,
    /// Byte of the text at which the edit begins.
    at: usize,
    before: String,
    after: String,
    /// Hash of the text after the edit.
    hash: String,
}

/// Edits in the order in which they were made.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Journal {
    edits: Vec<Edit>,
}

/// Why an edit cannot be undone.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum JournalError {
    /// A line that is no edit.
    #[error(
        "line {line} of the journal: {found}; expected an edit; delete the journal to go on without undo"
    )]
    Line {
        /// Number of the line, from 1.
        line: usize,
        /// What is wrong with it.
        found: String,
    },
    /// No edit is left.
    #[error("nothing to undo: the journal has no edit")]
    Empty,
    /// The text is not as the last edit left it.
    #[error(
        "the landscape was changed by hand since the edit {0:?}: expected the text as that edit left it; undo by hand, or delete the journal"
    )]
    Changed(String),
}

impl Journal {
    /// Reads the text of a journal.
    ///
    /// # Errors
    /// If a line is no edit.
    pub fn parse(text: &str) -> Result<Self, JournalError> {
        let edit = |(index, line): (usize, &str)| {
            let wrong = |found: String| JournalError::Line { line: index + 1, found };
            let value: Value = serde_json::from_str(line).map_err(|error| wrong(error.to_string()))?;
            Edit::of(&value).ok_or_else(|| wrong("keys are missing or of another type".into()))
        };
        Ok(Self { edits: text.lines().enumerate().map(edit).collect::<Result<_, _>>()? })
    }

    /// Text of the journal, a line an edit.
    pub fn text(&self) -> String {
        self.edits.iter().map(|edit| format!("{}\n", edit.json())).collect()
    }

    /// Edits in the order in which they were made.
    pub fn edits(&self) -> &[Edit] {
        &self.edits
    }

    /// Writes down an edit that turned one text into another.
    pub fn push(&mut self, what: &str, from: &str, to: &str) {
        let start = common(from.char_indices(), to.char_indices());
        let (from_rest, to_rest) = (&from[start..], &to[start..]);
        let end = common_end(from_rest, to_rest);
        self.edits.push(Edit {
            what: what.into(),
            at: start,
            before: from_rest[..from_rest.len() - end].into(),
            after: to_rest[..to_rest.len() - end].into(),
            hash: hash(to),
        });
    }

    /// The text before the last edit, and what was undone. The edit leaves the journal.
    ///
    /// # Errors
    /// If there is no edit, or the text is not as the edit left it.
    pub fn undo(&mut self, text: &str) -> Result<(String, String), JournalError> {
        let edit = self.edits.last().ok_or(JournalError::Empty)?;
        let changed = || JournalError::Changed(edit.what.clone());
        let rest = text.get(edit.at..).filter(|_| hash(text) == edit.hash).ok_or_else(changed)?;
        let rest = rest.strip_prefix(edit.after.as_str()).ok_or_else(changed)?;
        let undone = (format!("{}{}{rest}", &text[..edit.at], edit.before), edit.what.clone());
        self.edits.pop();
        Ok(undone)
    }
}

impl Edit {
    fn of(value: &Value) -> Option<Self> {
        let text = |key: &str| value.get(key)?.as_str().map(str::to_owned);
        let at = usize::try_from(value.get("at")?.as_u64()?).ok()?;
        Some(Self {
            what: text("what")?,
            at,
            before: text("before")?,
            after: text("after")?,
            hash: text("hash")?,
        })
    }

    fn json(&self) -> Value {
        json!({ "what": self.what, "at": self.at, "before": self.before, "after": self.after, "hash": self.hash })
    }
}

fn hash(text: &str) -> String {
    blake3::hash(text.as_bytes()).to_hex().to_string()
}

/// Bytes that two texts have in common at their beginning, whole characters.
fn common(from: std::str::CharIndices, to: std::str::CharIndices) -> usize {
    let alike = from.zip(to).take_while(|(a, b)| a == b);
    alike.last().map_or(0, |((at, c), _)| at + c.len_utf8())
}

/// Bytes that two texts have in common at their end, whole characters.
fn common_end(from: &str, to: &str) -> usize {
    let alike = from.chars().rev().zip(to.chars().rev()).take_while(|(a, b)| a == b);
    alike.map(|(c, _)| c.len_utf8()).sum()
}
