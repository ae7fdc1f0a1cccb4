//! Timing records as files.

use std::path::{Path, PathBuf};

use files::FileError;
use serde::Deserialize;

use crate::check::Fault;
use crate::layout::write_json;
use crate::record::{FORMAT, TimingRecord};

/// Largest file that is read (bytes): hours of frames in which all goes wrong.
const MAX_BYTES: u64 = 1 << 30;

/// A timing record that could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// The system said no.
    #[error(transparent)]
    File(#[from] FileError),
    /// A later lunoid wrote it.
    #[error(
        "{path}: format: found {found}, expected at most {FORMAT}; read it with the lunoid that wrote it, or record it \
         again with `lunoid timing record`"
    )]
    Newer {
        /// The path as given.
        path: PathBuf,
        /// Format number that the file states.
        found: u64,
    },
    /// An earlier lunoid wrote it.
    #[error("{path}: format: found {found}, expected {FORMAT}; record it again with `lunoid timing record`")]
    Older {
        /// The path as given.
        path: PathBuf,
        /// Format number that the file states.
        found: u64,
    },
    /// Not JSON, or not of this shape.
    #[error(
        "{path}:{line}:{column}: {message}; expected a timing record of format {FORMAT}: restore the file, or record it \
         again with `lunoid timing record`"
    )]
    Damaged {
        /// The path as given.
        path: PathBuf,
        /// Line, from 1; 0 if the file is empty.
        line: usize,
        /// Column of the fault, from 1.
        column: usize,
        /// What is found, and what was expected.
        message: String,
    },
    /// Values that cannot stand together.
    #[error("{path}: {fault}; restore the file, or record it again with `lunoid timing record`")]
    Faulty {
        /// The path as given.
        path: PathBuf,
        /// Fault with its place.
        fault: Fault,
    },
}

/// Reads a record.
///
/// # Errors
/// [`RecordError`] if the file cannot be read, is of another format, is no timing record, or does not hold together.
pub fn read(path: impl AsRef<Path>) -> Result<TimingRecord, RecordError> {
    let path = path.as_ref();
    let bytes = files::read_all(path, MAX_BYTES)?;
    let damaged = |error: serde_json::Error| RecordError::damaged(path, &error);
    // A newer format may have keys of any name: its number is read before anything else is judged.
    let Head { format } = serde_json::from_slice(&bytes).map_err(damaged)?;
    if format > u64::from(FORMAT) {
        return Err(RecordError::Newer { path: path.to_owned(), found: format });
    }
    if format < u64::from(FORMAT) {
        return Err(RecordError::Older { path: path.to_owned(), found: format });
    }
    let record: TimingRecord = serde_json::from_slice(&bytes).map_err(damaged)?;
    record.check().map_err(|fault| RecordError::Faulty { path: path.to_owned(), fault })?;
    Ok(record)
}

/// Writes a record, whole or not at all. The bytes depend on the values alone.
///
/// # Errors
/// [`RecordError`] if the record does not hold together, or the file cannot be written.
pub fn write(path: impl AsRef<Path>, record: &TimingRecord) -> Result<(), RecordError> {
    let path = path.as_ref();
    record.check().map_err(|fault| RecordError::Faulty { path: path.to_owned(), fault })?;
    Ok(files::write_atomic(path, |out| write_json(out, record))?)
}

#[derive(Deserialize)]
struct Head {
    format: u64,
}

impl RecordError {
    fn damaged(path: &Path, error: &serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let message = error.to_string();
        // The place stands in front already.
        let place = format!(" at line {line} column {column}");
        let message = message.strip_suffix(&place).unwrap_or(&message).to_owned();
        Self::Damaged { path: path.to_owned(), line, column, message }
    }
}
