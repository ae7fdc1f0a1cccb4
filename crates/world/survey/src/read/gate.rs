//! Files of an elevation, opened through the gate of the house (`files`).

use std::fs::File;
use std::io::Read;
use std::path::Path;

use files::{Action, FileError, Kind};

use crate::error::SurveyError;

/// A file of a user's, and its bytes. Readers go to places in it: an open pipe of this process is refused like any other.
pub fn open(path: &Path) -> Result<(File, u64), SurveyError> {
    let file = files::open(path)?;
    let found = file.metadata().map_err(|source| SurveyError::Read { path: path.to_path_buf(), source })?;
    match Kind::of_type(found.file_type()) {
        Kind::File => Ok((file, found.len())),
        kind => Err(FileError::NoFile { path: path.to_path_buf(), action: Action::Read, kind }.into()),
    }
}

/// At most so many bytes from the beginning of a file.
pub fn front(path: &Path, most: u64) -> Result<Vec<u8>, SurveyError> {
    let (file, _) = open(path)?;
    let mut bytes = Vec::new();
    let read = file.take(most).read_to_end(&mut bytes);
    read.map_err(|source| SurveyError::Read { path: path.to_path_buf(), source })?;
    Ok(bytes)
}
