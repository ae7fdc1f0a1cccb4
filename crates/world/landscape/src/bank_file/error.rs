//! What can be wrong with a bank file.

use crate::BankError;
use files::FileError;
use std::fmt;
use std::path::PathBuf;

/// A bank file that could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum BankFileError {
    /// The file.
    #[error(transparent)]
    File(#[from] FileError),
    /// What is in it.
    #[error("{path}: {source}")]
    Format {
        /// The path as given.
        path: PathBuf,
        /// What is wrong.
        source: BankFormatError,
    },
}

/// A section by its place in the table and its kind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SectionName {
    /// Place in the table, from 0.
    pub index: usize,
    /// Kind, trailing zero bytes left out.
    pub kind: String,
}

impl fmt::Display for SectionName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "section {} ({})", self.index, self.kind)
    }
}

/// Bytes that are not the bank file they should be. Offsets are bytes from the start of the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BankFormatError {
    /// The magic bytes are missing.
    #[error("not a bank: byte 0: found \"{found}\", expected \"LUNOBANK\"")]
    NotBank {
        /// The first bytes, escaped.
        found: String,
    },
    /// Written by a later version.
    #[error("byte 8: format {found}, expected {}: use a newer lunoid", super::FORMAT)]
    Version {
        /// As in the header.
        found: u32,
    },
    /// The file ends too early, or something was appended.
    #[error("the file has {found} bytes, expected {expected}; copy it again")]
    FileLength {
        /// Bytes there.
        found: u64,
        /// Bytes that the header, or the table, needs.
        expected: u64,
    },
    /// The table is damaged.
    #[error("section table, byte {offset}: checksum {found}, expected {expected}; copy the file again")]
    TableChecksum {
        /// Where the table begins.
        offset: u64,
        /// Of the bytes there.
        found: String,
        /// As in the header.
        expected: String,
    },
    /// A section does not begin on a multiple of 64 bytes.
    #[error("{section}: begins at byte {offset}, expected a multiple of 64")]
    Misaligned {
        /// Which.
        section: SectionName,
        /// Where it begins.
        offset: u64,
    },
    /// A section lies outside the file, or in the header or the table.
    #[error("{section}: {length} bytes from byte {offset} on, expected within bytes {first} to {end}")]
    Outside {
        /// Which.
        section: SectionName,
        /// Where it begins.
        offset: u64,
        /// Its bytes.
        length: u64,
        /// End of the table.
        first: u64,
        /// End of the file.
        end: u64,
    },
    /// Two sections share bytes.
    #[error("{section}: begins at byte {offset}, inside {other}, expected byte {expected} or later")]
    Overlap {
        /// Which.
        section: SectionName,
        /// Where it begins.
        offset: u64,
        /// The one before.
        other: SectionName,
        /// End of the one before.
        expected: u64,
    },
    /// A section is damaged.
    #[error("{section}, byte {offset}: checksum {found}, expected {expected}; copy the file again")]
    Checksum {
        /// Which.
        section: SectionName,
        /// Where it begins.
        offset: u64,
        /// Of the bytes there.
        found: String,
        /// As in the table.
        expected: String,
    },
    /// The length of a section is not what its kind or its corner counts need.
    #[error("{section}, byte {offset}: {found} bytes, expected {expected}")]
    SectionLength {
        /// Which.
        section: SectionName,
        /// Where it begins.
        offset: u64,
        /// Bytes there.
        found: u64,
        /// Bytes needed, in words.
        expected: String,
    },
    /// A value is out of its range.
    #[error("{section}, byte {offset}: {found}, expected {expected}")]
    Value {
        /// Which.
        section: SectionName,
        /// Where the value stands.
        offset: u64,
        /// The value.
        found: String,
        /// Its range and meaning.
        expected: String,
    },
    /// A kind of which there can be one stands twice.
    #[error("{section}, byte {offset}: found a second one, expected at most one")]
    Repeated {
        /// The second.
        section: SectionName,
        /// Where it begins.
        offset: u64,
    },
    /// A level that cannot be.
    #[error("{section}, byte {offset}: {source}")]
    Level {
        /// Which.
        section: SectionName,
        /// Where it begins.
        offset: u64,
        /// What is wrong.
        source: BankError,
    },
    /// The levels do not make a bank.
    #[error(transparent)]
    Bank(#[from] BankError),
}
