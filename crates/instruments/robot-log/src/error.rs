//! Why a log or OpenEXR files cannot be written.

use std::path::PathBuf;

use files::{FileError, NpyError};
use generator::FrameError;
use picture::PictureError;
use replay::ReplayError;
use scenario::PathProblems;

use crate::Form;

/// Why a log or OpenEXR files cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    /// The program was built without the libraries that this needs.
    #[error(
        "{}: this build of lunoid has not the feature `{}`; build it with `cargo build --release --features {}`",
        .0.option(), .0.feature(), .0.feature()
    )]
    NotInThisBuild(Form),
    /// The truth has not the arrays that are needed.
    #[error("{option}: the ground truth has no `{lacks}`; expected --truth with {expected}")]
    Lacks {
        /// The option that needs it.
        option: &'static str,
        /// Name of the array that is missing.
        lacks: &'static str,
        /// All names that are needed, joined by commas.
        expected: String,
    },
    /// A frame whose picture or truth the folder has not.
    #[error("{path}: has no {what} of frame {frame}; the same replay again makes it")]
    NoFrame {
        /// Path of the run folder.
        path: PathBuf,
        /// `picture` or `ground truth`.
        what: &'static str,
        /// Number of the frame, counted at the update rate.
        frame: u64,
    },
    /// A file of the truth that holds something else than its record says.
    #[error("{path}: {reason}; remove the folder of the truth to have it made anew")]
    Array {
        /// Path of the file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A frame that begins later than the format can say.
    #[error("frame {frame}: begins more than 136 years after the mission; a robot log has no later time")]
    Late {
        /// Number of the frame, counted at the update rate.
        frame: u64,
    },
    /// A file that is no log of this program has the name of the log.
    #[error("{path}: exists, and is no log that lunoid wrote; name another file, or remove this one")]
    NotOurs {
        /// Path of the file.
        path: PathBuf,
    },
    /// A picture that cannot be read.
    #[error("{path}: {source}; the same replay with --fresh draws the run anew")]
    Picture {
        /// Path of the picture.
        path: PathBuf,
        /// Why it cannot be read.
        source: PictureError,
    },
    /// The display transfer of the scenario.
    #[error("display: {0}")]
    Display(PictureError),
    /// Planes that the format does not take.
    #[error("{path}: cannot be packed: {reason}")]
    Pack {
        /// Path of the file that is to be written.
        path: PathBuf,
        /// What the library says.
        reason: String,
    },
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A run folder that is not what it should be.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// The path cannot be driven.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// The digital side cannot work out a frame.
    #[error(transparent)]
    Frame(#[from] FrameError),
}

impl LogError {
    /// An array at `path` that cannot be read.
    pub(crate) fn array(path: PathBuf) -> impl FnOnce(NpyError) -> Self {
        move |source| Self::Array { path, reason: source.to_string() }
    }
}
