//! Why there is no data set.

use std::path::PathBuf;

use diagnostics::ProblemList;
use files::{FileError, FolderError};
use replay::ReplayError;

/// A data set that cannot be made, or not be joined.
#[derive(Debug, thiserror::Error)]
pub enum DatasetError {
    /// Faults of the plan, or of what it names.
    #[error(transparent)]
    Plan(#[from] ProblemList),
    /// What a plan names cannot be read.
    #[error(transparent)]
    Open(#[from] front_door::OpenError),
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A folder that cannot be read or written.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// The journal cannot be read or written.
    #[error(transparent)]
    Journal(#[from] ReplayError),
    /// A sample that cannot be made.
    #[error("sample {sample}: {said}")]
    Sample {
        /// Number of the sample.
        sample: u64,
        /// What is wrong, in words.
        said: String,
    },
    /// No pose was found for a sample.
    #[error(
        "sample {sample}: none of {attempts} poses can be taken ({reasons}); the last one: {last}; make the ranges of [pose] or \
         `block_m` larger, or `reach_m` smaller"
    )]
    NoPose {
        /// Number of the sample.
        sample: u64,
        /// Poses that were drawn.
        attempts: u32,
        /// How many were refused for each reason.
        reasons: String,
        /// Why the last one was refused.
        last: String,
    },
    /// Two samples whose pictures are of different shapes.
    #[error(
        "samples {first} and {second} have pictures of shape {first_shape:?} and {second_shape:?}; expected one shape; leave out \
         the machine or scenario whose pictures differ"
    )]
    Shapes {
        /// Number of one sample.
        first: u64,
        /// Number of the other.
        second: u64,
        /// Shape of the first picture.
        first_shape: Vec<usize>,
        /// Shape of the second picture.
        second_shape: Vec<usize>,
    },
    /// The folder holds something else.
    #[error("{path}: holds `{found}`, which is no file of a data set; name an empty folder")]
    Foreign {
        /// Path of the folder.
        path: PathBuf,
        /// Name of what was found.
        found: String,
    },
    /// The folder holds another data set.
    #[error("{path}: holds another data set: {differences}; name another folder")]
    Other {
        /// Path of the folder.
        path: PathBuf,
        /// What differs, key by key.
        differences: String,
    },
    /// A record, a manifest or a sample is not as it was written.
    #[error("{path}: {reason}")]
    Record {
        /// Path of the file.
        path: PathBuf,
        /// What is wrong, in words.
        reason: String,
    },
    /// Folders of different data sets.
    #[error(
        "{first} and {second} are not of one data set: they differ in {differences}; join what one program made of one plan"
    )]
    OtherSet {
        /// One of the two folders.
        first: PathBuf,
        /// The other of the two folders.
        second: PathBuf,
        /// Every key that differs, the first in front.
        differences: String,
    },
    /// A sample that two folders have differently.
    #[error(
        "sample {sample}: {first} and {second} have it differently, in {differences}; make one of them anew"
    )]
    Overlap {
        /// Number of the sample.
        sample: u64,
        /// One of the two folders.
        first: PathBuf,
        /// The other of the two folders.
        second: PathBuf,
        /// Every key that differs, the first in front.
        differences: String,
    },
    /// A folder that was given twice, or that would be joined into itself.
    #[error("{path}: {reason}")]
    Folders {
        /// Path of the folder.
        path: PathBuf,
        /// What is wrong, in words.
        reason: &'static str,
    },
    /// The samples that were asked for are not those of the plan.
    #[error("no samples {asked}: the plan has samples 0..{of}")]
    NoSamples {
        /// What was asked for.
        asked: String,
        /// Number of all samples.
        of: u64,
    },
    /// The contact sheet cannot be made.
    #[error("contact sheet: {0}")]
    Sheet(#[from] picture::PictureError),
}
