//! Reading a whole file, up to a limit.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use limits::Limit;

use crate::error::{Action, FileError};

/// Most bytes of a file: a number that stands, or a [`Limit`] that a user can raise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Most {
    /// That many.
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
    let path = path.as_ref();
    let Most { bytes: limit, raised_by } = most.into();
    let failed = |source| FileError::new(path, Action::Read, source);
    let too_large = |bytes| FileError::TooLarge { path: path.to_owned(), bytes, limit, raised_by };
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
