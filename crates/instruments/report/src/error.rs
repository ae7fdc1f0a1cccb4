//! Why a page cannot be written.

use std::path::PathBuf;

use compare::CompareError;
use files::{FileError, FolderError};
use picture::{PictureError, PictureFileError};
use replay::ReplayError;

/// A page that cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A folder that cannot be made.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// The folder holds no run, or one whose record cannot be read.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// A frame that is no picture.
    #[error(transparent)]
    PictureFile(#[from] PictureFileError),
    /// A frame that cannot be made smaller.
    #[error("{path}: {source}")]
    Strip {
        /// Path of the frame.
        path: PathBuf,
        /// Why the frame cannot be made smaller.
        source: PictureError,
    },
    /// Pictures of two runs that cannot be compared.
    #[error("{path}: {source}")]
    Compare {
        /// Path of the picture.
        path: PathBuf,
        /// Why the pictures cannot be compared.
        source: CompareError,
    },
    /// A file of the run that does not hold what a run writes.
    #[error("{path}: {reason}; the same `lunoid replay` again writes it anew")]
    Content {
        /// Path of the file.
        path: PathBuf,
        /// What was found and what was expected.
        reason: String,
    },
}
