//! Reading a whole file, up to a limit.

use std::fs::{self, File, Metadata};
use std::io::Read;
use std::path::Path;

use limits::Limit;

use crate::error::{Action, FileError};
use crate::given::{self, Found};

/// Most bytes of a file: a number that stands, or a [`Limit`] that a user can raise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Most {
    /// Greatest number of bytes that are read.
    pub bytes: u64,
    /// What would allow more.
    pub raised_by: Option<Limit>,
}

impl From<u64> for Most {
    fn from(bytes: u64) -> Self {
        Self { bytes, raised_by: None }
    }
}

impl From<Limit> for Most {
    fn from(limit: Limit) -> Self {
        Self { bytes: limit.value(), raised_by: Some(limit) }
    }
}

/// The bytes of a file of at most so many.
///
/// # Errors
/// [`FileError::Missing`], [`FileError::IsFolder`], [`FileError::TooLarge`] (before anything is allocated,
/// where the file tells its size), and failures of the system.
pub fn read_all(path: impl AsRef<Path>, most: impl Into<Most>) -> Result<Vec<u8>, FileError> {
    let (path, most) = (path.as_ref(), most.into());
    if let Some(bytes) = given::read(path, most) {
        return bytes.map(|bytes| bytes.to_vec());
    }
    let (file, metadata) = open(path, most)?;
    bytes_of(file, &metadata, path, most)
}

/// Whether the file at `path` is there with exactly these bytes. A link is not.
pub fn holds(path: impl AsRef<Path>, bytes: &[u8]) -> bool {
    let path = path.as_ref();
    if let Some(found) = given::find(path) {
        return matches!(found, Found::File(held) if *held == *bytes);
    }
    let has_length =
        fs::symlink_metadata(path).is_ok_and(|found| found.is_file() && found.len() == bytes.len() as u64);
    has_length && read_all(path, bytes.len() as u64).is_ok_and(|found| found == bytes)
}

/// All bytes of an open file.
pub(crate) fn bytes_of(
    file: File,
    metadata: &Metadata,
    path: &Path,
    most: Most,
) -> Result<Vec<u8>, FileError> {
    let failed = |source| FileError::new(path, Action::Read, source);
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(metadata.len() as usize).map_err(|error| failed(error.into()))?;
    // One byte beyond the limit tells a device, or a file that grows, from a file that just fits.
    file.take(most.bytes.saturating_add(1)).read_to_end(&mut bytes).map_err(failed)?;
    most.allows(path, bytes.len() as u64)?;
    Ok(bytes)
}

/// A file that may be read, and what the system knows of it.
pub(crate) fn open(path: &Path, most: Most) -> Result<(File, Metadata), FileError> {
    let file = crate::open::open(path)?;
    let metadata = file.metadata().map_err(|source| FileError::new(path, Action::Read, source))?;
    most.allows(path, metadata.len())?;
    Ok((file, metadata))
}

impl Most {
    pub(crate) fn allows(self, path: &Path, bytes: u64) -> Result<(), FileError> {
        let Self { bytes: limit, raised_by } = self;
        if bytes <= limit {
            return Ok(());
        }
        Err(FileError::TooLarge { path: path.to_owned(), bytes, limit, raised_by })
    }
}
