//! A value that a landscape cannot have.

/// A number, or a set of numbers, that was refused: the key of the file, what was found, what was expected.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{key}` is {found}: expected {expected}")]
pub struct Refused {
    /// Key under which the file has the value.
    pub key: &'static str,
    /// The value that was found, in words.
    pub found: String,
    /// The values that are allowed, in words.
    pub expected: &'static str,
}

impl Refused {
    /// A refusal of the value under a key of the file.
    pub fn new(key: &'static str, found: impl ToString, expected: &'static str) -> Self {
        Self { key, found: found.to_string(), expected }
    }
}

/// A refusal unless what is allowed holds. Conditions are written so that NaN does not fulfil them.
pub(crate) fn expect(
    holds: bool,
    key: &'static str,
    found: impl ToString,
    expected: &'static str,
) -> Result<(), Refused> {
    if holds { Ok(()) } else { Err(Refused::new(key, found, expected)) }
}
