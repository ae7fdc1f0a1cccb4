//! What can go wrong while waveforms are written.

use std::io;
use std::path::{Path, PathBuf};

use files::{Action, FileError};

/// Why waveforms cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum WaveformError {
    /// The file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A format that no sink writes.
    #[error("`{found}` is no format of waveforms: expected {}", crate::Format::words())]
    Format {
        /// Name of a format that was asked for.
        found: String,
    },
    /// A sweep that does not follow from the header and the sweeps before.
    #[error("{path}: sweep {sweep}: found {found}, expected {expected}")]
    Sweep {
        /// File that is written.
        path: PathBuf,
        /// Number of the sweep that was given.
        sweep: u32,
        /// What was given, in words.
        found: String,
        /// What should have been.
        expected: String,
    },
    /// A value that no file should hold.
    #[error(
        "{path}: {signal} of sweep {sweep} is {value} at value {index}: expected a finite number; this is a fault \
         of the machine, please report it"
    )]
    NotFinite {
        /// File that is written.
        path: PathBuf,
        /// Name of the signal.
        signal: &'static str,
        /// Number of the sweep.
        sweep: u32,
        /// Which of its values, or of its instants.
        index: usize,
        /// Value, which is not finite.
        value: f64,
    },
    /// The end came before the last sweep.
    #[error("{path}: {found} of {expected} sweeps were given")]
    Unfinished {
        /// File that is written.
        path: PathBuf,
        /// Number of sweeps given.
        found: u32,
        /// Sweeps that the header tells.
        expected: u32,
    },
}

/// The failure of the system that `source` is, told as all files tell it.
pub(crate) fn file_error(path: &Path, action: Action, source: io::Error) -> FileError {
    use io::ErrorKind as Kind;
    let owned = path.to_owned();
    match source.kind() {
        Kind::NotFound | Kind::NotADirectory => {
            let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
            let folder = folder.unwrap_or(Path::new(".")).to_owned();
            FileError::MissingFolder { path: owned, folder, action }
        }
        Kind::IsADirectory => FileError::IsFolder { path: owned, action },
        Kind::PermissionDenied | Kind::ReadOnlyFilesystem => {
            FileError::Denied { path: owned, action, source }
        }
        Kind::StorageFull | Kind::QuotaExceeded => FileError::NoSpace { path: owned, action, source },
        _ => FileError::Io { path: owned, action, source },
    }
}
