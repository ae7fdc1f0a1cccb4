//! Why a page cannot be written.

use std::path::PathBuf;

use compare::CompareError;
use files::FileError;
use picture::{PictureError, PictureFileError};
use replay::ReplayError;

/// A page that cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The folder holds no run, or one whose record cannot be read.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// A frame that is no picture.
    #[error(transparent)]
    PictureFile(#[from] PictureFileError),
    /// A frame that cannot be made smaller.
    #[error("{path}: {source}")]
    Strip {
        /// The frame.
        path: PathBuf,
        /// What is wrong.
        source: PictureError,
    },
    /// Pictures of two runs that cannot be compared.
    #[error("{path}: {source}")]
    Compare {
        /// The picture.
        path: PathBuf,
        /// What is wrong.
        source: CompareError,
    },
    /// A file of the run that does not hold what a run writes.
    #[error("{path}: {reason}; the same `lunoid replay` again writes it anew")]
    Content {
        /// The file.
        path: PathBuf,
        /// What was found and what was expected.
        reason: String,
    },
}
