//! Why there is no database.

use std::path::PathBuf;

use files::FileError;
use limits::Limit;

use crate::blocks::Block;
use crate::header::VERSION;

/// A value that a terrain cannot have.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{key} is {found}: expected {expected}")]
pub struct Unfit {
    /// Name of the value, with the number of its post or boulder.
    pub key: String,
    /// The value that was found, in words.
    pub found: String,
    /// The values that are allowed, in words.
    pub expected: String,
}

/// An `Unfit` unless what is allowed holds. Conditions are written so that NaN does not fulfil them.
pub(crate) fn expect(
    holds: bool,
    key: impl ToString,
    found: impl ToString,
    expected: impl ToString,
) -> Result<(), Unfit> {
    let unfit = || Unfit { key: key.to_string(), found: found.to_string(), expected: expected.to_string() };
    if holds { Ok(()) } else { Err(unfit()) }
}

/// A value that a terrain cannot have, and the block that it stands in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UnfitBlock {
    pub block: Block,
    pub unfit: Unfit,
}

impl From<UnfitBlock> for Unfit {
    fn from(of: UnfitBlock) -> Self {
        of.unfit
    }
}

/// A file that is no terrain database, or a damaged one.
#[derive(Debug, thiserror::Error)]
pub enum DatabaseError {
    /// The file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file begins otherwise.
    #[error("{path}: the first bytes are {found:02x?}; expected a terrain database; make one with `lunoid terrain export`", path = .path.display())]
    Magic {
        /// Path of the file.
        path: PathBuf,
        /// First bytes of the file.
        found: Vec<u8>,
    },
    /// The file has another version.
    #[error("{path}: terrain database of version {found}; expected version {VERSION}; export the landscape again", path = .path.display())]
    Version {
        /// Path of the file.
        path: PathBuf,
        /// Version of the file.
        found: u32,
    },
    /// The file has another length than its header says.
    #[error("{path}: {found} bytes; expected {expected} by its header: the file is cut off or its header is damaged; export the landscape again", path = .path.display())]
    Length {
        /// Path of the file.
        path: PathBuf,
        /// Bytes of the file.
        found: u64,
        /// Bytes that the header says, or at least so many.
        expected: String,
    },
    /// A block whose hash differs.
    #[error("{path}: the block of {block} is damaged: its hash differs; export the landscape again", path = .path.display())]
    Damaged {
        /// Path of the file.
        path: PathBuf,
        /// Which block is damaged.
        block: Block,
    },
    /// A block that is whole, and says what cannot be.
    #[error("{path}: the block of {block}: {unfit}; export the landscape again", path = .path.display())]
    Unfit {
        /// Path of the file.
        path: PathBuf,
        /// The block at fault.
        block: Block,
        /// Its value that cannot be.
        unfit: Unfit,
    },
    /// Heights that take more memory than is allowed.
    #[error("{path}: {posts} posts take {bytes} bytes; expected at most {allowed}; {limit}", path = .path.display(), allowed = .limit.value())]
    TooLarge {
        /// Path of the file.
        path: PathBuf,
        /// How many posts it has.
        posts: u64,
        /// Bytes of their heights in memory.
        bytes: u64,
        /// What would allow more.
        limit: Limit,
    },
}
