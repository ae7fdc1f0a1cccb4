//! Files of a record.

use std::path::{Component, Path};

use files::FileError;
use serde::{Deserialize, Serialize};

/// Largest file of a run that is read back (bytes).
pub const MAX_BYTES: u64 = 1 << 32;

/// Path and hash of one file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileRecord {
    /// Path from the run folder, with `/`; of an input as the user gave it.
    pub file: String,
    /// BLAKE3 of its bytes, hexadecimal.
    pub blake3: String,
}

impl FileRecord {
    /// The record of a file as it is now.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        Ok(Self { file: path.display().to_string(), blake3: file_hash(path)? })
    }

    /// Whether the file in `folder` is what the record says; a missing or unreadable one is not.
    pub fn is_whole(&self, folder: &Path) -> bool {
        file_hash(&folder.join(&self.file)).is_ok_and(|found| found == self.blake3)
    }
}

/// BLAKE3 of a file, hexadecimal.
///
/// # Errors
/// If the file cannot be read.
pub fn file_hash(path: &Path) -> Result<String, FileError> {
    Ok(hash(&files::read_all(path, MAX_BYTES)?))
}

/// BLAKE3 of bytes, hexadecimal.
pub fn hash(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// Whether a name of a record leads to a file of its own folder, whoever wrote the record.
pub fn stays_inside(file: &str) -> bool {
    !file.is_empty() && Path::new(file).components().all(|part| matches!(part, Component::Normal(_)))
}
