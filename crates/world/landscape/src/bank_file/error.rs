//! What can be wrong with a bank file.

use crate::BankError;
use files::FileError;
use std::fmt;
use std::path::PathBuf;

/// A bank file that could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum BankFileError {
    /// The file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// What is in it.
    #[error("{path}: {source}")]
    Format {
        /// The path as given.
        path: PathBuf,
        /// Fault in the contents of the file.
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
        /// Number of bytes in the file.
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
        /// Section that begins at a wrong byte.
        section: SectionName,
        /// Byte of the file at which the section begins.
        offset: u64,
    },
    /// A section lies outside the file, or in the header or the table.
    #[error("{section}: {length} bytes from byte {offset} on, expected within bytes {first} to {end}")]
    Outside {
        /// Section that lies outside its limits.
        section: SectionName,
        /// Byte of the file at which the section begins.
        offset: u64,
        /// Length of the section in bytes.
        length: u64,
        /// End of the table.
        first: u64,
        /// End of the file.
        end: u64,
    },
    /// Two sections share bytes.
    #[error("{section}: begins at byte {offset}, inside {other}, expected byte {expected} or later")]
    Overlap {
        /// Section that begins too early.
        section: SectionName,
        /// Byte of the file at which the section begins.
        offset: u64,
        /// Section before it, whose bytes it shares.
        other: SectionName,
        /// End of the one before.
        expected: u64,
    },
    /// A section is damaged.
    #[error("{section}, byte {offset}: checksum {found}, expected {expected}; copy the file again")]
    Checksum {
        /// Section with the wrong checksum.
        section: SectionName,
        /// Byte of the file at which the section begins.
        offset: u64,
        /// Of the bytes there.
        found: String,
        /// As in the table.
        expected: String,
    },
    /// The length of a section is not what its kind or its corner counts need.
    #[error("{section}, byte {offset}: {found} bytes, expected {expected}")]
    SectionLength {
        /// Section with the wrong length.
        section: SectionName,
        /// Byte of the file at which the section begins.
        offset: u64,
        /// Number of bytes in the section.
        found: u64,
        /// Bytes needed, in words.
        expected: String,
    },
    /// A value is out of its range.
    #[error("{section}, byte {offset}: {found}, expected {expected}")]
    Value {
        /// Section that holds the value.
        section: SectionName,
        /// Where the value stands.
        offset: u64,
        /// Value that was found, as text.
        found: String,
        /// Its range and meaning.
        expected: String,
    },
    /// A kind of which there can be one stands twice.
    #[error("{section}, byte {offset}: found a second one, expected at most one")]
    Repeated {
        /// Second section of the kind.
        section: SectionName,
        /// Byte of the file at which the second section begins.
        offset: u64,
    },
    /// True north of a bank that has no place.
    #[error("section north without a section place, expected both or neither")]
    NorthWithoutPlace,
    /// A level that cannot be.
    #[error("{section}, byte {offset}: {source}")]
    Level {
        /// Section that holds the level.
        section: SectionName,
        /// Byte of the file at which the section begins.
        offset: u64,
        /// Fault that the level was refused for.
        source: BankError,
    },
    /// The levels do not make a bank.
    #[error(transparent)]
    Bank(#[from] BankError),
}
