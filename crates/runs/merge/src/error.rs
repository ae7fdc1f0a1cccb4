//! Why folders cannot be joined.

use std::ops::Range;
use std::path::PathBuf;

use replay::ReplayError;

/// Folders that cannot be joined.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// A folder that cannot be read or written.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// A timing record that cannot be read or written.
    #[error(transparent)]
    Timing(#[from] timing::RecordError),
    /// The same folder was given twice.
    #[error("{path}: given twice; give each folder once")]
    Twice {
        /// Path of the folder.
        path: PathBuf,
    },
    /// The joined run would be written into a folder that is joined.
    #[error("{path}: this folder is to be joined; expected another folder for the joined run")]
    IntoItself {
        /// Path of the folder.
        path: PathBuf,
    },
    /// Records of different runs.
    #[error(
        "{first} and {second} are not of one run: they differ in {differences}; join what one program drew from the same files"
    )]
    OtherRun {
        /// One of the two records.
        first: PathBuf,
        /// The other of the two records.
        second: PathBuf,
        /// Every key that differs, the first in front.
        differences: String,
    },
    /// A frame that two folders have differently.
    #[error(
        "frame {frame}: {first} and {second} have it differently, in {differences}; draw one of them anew with --fresh"
    )]
    Overlap {
        /// Number of the frame, counted at the update rate.
        frame: u64,
        /// One of the two records.
        first: PathBuf,
        /// The other of the two records.
        second: PathBuf,
        /// Every key that differs, the first in front.
        differences: String,
    },
    /// None of the folders has a finished run.
    #[error("{path}: none of the folders holds a finished run or truth of one; draw the shards first")]
    NothingFinished {
        /// Path of the first folder.
        path: PathBuf,
    },
    /// A folder has frames outside the range asked for.
    #[error("{path}: holds frames {}..{}, outside the frames {}..{} asked for; give a range that holds them, or leave --frames out",
        held.start, held.end, asked.start, asked.end)]
    Outside {
        /// Path of the record.
        path: PathBuf,
        /// Frames of the folder.
        held: Range<u64>,
        /// Frames of the joined run that were asked for.
        asked: Range<u64>,
    },
    /// A table whose rows are not those of the frames.
    #[error("{path}: {reason}; the same replay into that folder makes the file anew")]
    Table {
        /// Path of the table.
        path: PathBuf,
        /// What is wrong with the table, in words.
        reason: String,
    },
    /// A generator that this program does not know.
    #[error("{path}: generator {name:?} is not one of this program; join with the program that drew the run")]
    Generator {
        /// Path of the record.
        path: PathBuf,
        /// Name of the generator.
        name: String,
    },
}
