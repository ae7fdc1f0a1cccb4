//! Reading a whole file, up to a limit.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::error::{Action, FileError};

/// The bytes of a file of at most `limit` bytes.
///
/// # Errors
/// [`FileError::Missing`], [`FileError::IsFolder`], [`FileError::TooLarge`] (before anything is allocated,
/// where the file tells its size), and failures of the system.
pub fn read_all(path: impl AsRef<Path>, limit: u64) -> Result<Vec<u8>, FileError> {
    let path = path.as_ref();
    let failed = |source| FileError::new(path, Action::Read, source);
    let too_large = |bytes| FileError::TooLarge { path: path.to_owned(), bytes, limit };
    let file = File::open(path).map_err(failed)?;
    let metadata = file.metadata().map_err(failed)?;
    if metadata.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned(), action: Action::Read });
    }
    if metadata.len() > limit {
        return Err(too_large(metadata.len()));
    }
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(metadata.len() as usize).map_err(|error| failed(error.into()))?;
    // One byte beyond the limit tells a device, or a file that grows, from a file that just fits.
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > limit { Err(too_large(bytes.len() as u64)) } else { Ok(bytes) }
}
