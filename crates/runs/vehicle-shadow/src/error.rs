//! Why a picture sequence cannot have a shadow.

use std::io;
use std::path::PathBuf;

use diagnostics::ProblemList;
use files::{FileError, FolderError};
use generator::FrameError;
use photographs::PhotographFileError;
use picture::PictureFileError;

use crate::suns::LowSun;

/// A sequence that cannot be read, or into which the shadow cannot be put.
#[derive(Debug, thiserror::Error)]
pub enum AugmentError {
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A frame that is no picture.
    #[error(transparent)]
    Photograph(#[from] PhotographFileError),
    /// A new picture that cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureFileError),
    /// The folder of the new pictures cannot be written into: it is in use, or it or something in it is a link.
    #[error(transparent)]
    Claim(#[from] FolderError),
    /// The folder of the new pictures holds files of somebody else.
    #[error(
        "{path}: holds `{found}`, which `lunoid augment` did not make; choose another --out, or keep it beside the new \
         pictures with --fresh (only what the command made is ever removed)"
    )]
    Foreign {
        /// Path of the folder.
        path: PathBuf,
        /// The first file found.
        found: String,
    },
    /// A file of somebody else has the name of a new one.
    #[error(
        "{path}: holds `{found}`, which `lunoid augment` did not make and would replace; choose another --out"
    )]
    WouldReplace {
        /// Path of the folder.
        path: PathBuf,
        /// Name of the file that would be replaced.
        found: String,
    },
    /// The folder holds pictures that were made from something else.
    #[error(
        "{path}: holds pictures of another augmentation, from which this one differs: {differences}; choose another --out, or \
         remove them with --fresh"
    )]
    Other {
        /// Path of the folder.
        path: PathBuf,
        /// Every key that differs, in words.
        differences: String,
    },
    /// A folder that cannot be listed.
    #[error("{path}: cannot {doing}: {source}")]
    Folder {
        /// Path of the folder.
        path: PathBuf,
        /// What was tried, as words after `cannot`.
        doing: &'static str,
        /// What the system says.
        source: io::Error,
    },
    /// A file of poses or of a camera that says something else than it should.
    #[error("{path}{}: {what}; expected {expected}", line.map(|line| format!(", line {line}")).unwrap_or_default())]
    Content {
        /// Path of the file.
        path: PathBuf,
        /// Line from 1, where one is to blame.
        line: Option<u64>,
        /// What was found there, in words.
        what: String,
        /// What should stand there.
        expected: String,
    },
    /// A table of poses with faults.
    #[error(transparent)]
    Poses(#[from] ProblemList),
    /// The pictures do not say from where they were taken.
    #[error(
        "{path}: no camera.json beside the poses: expected the camera's field of view; name its file by --camera, or \
         give --field WIDTH,HEIGHT in degrees"
    )]
    NoCamera {
        /// The file that is missing.
        path: PathBuf,
    },
    /// A folder without pictures.
    #[error(
        "{path}: no picture here: expected PNG files (or JPEG, TIFF) whose names end in their frame's number, as frame-000012.png"
    )]
    NoFrames {
        /// Path of the folder.
        path: PathBuf,
    },
    /// Two pictures of one frame.
    #[error("{first} and {second}: both are frame {frame}; expected one picture a frame; take one out")]
    TwoFrames {
        /// Number of the frame.
        frame: u64,
        /// Path of the first picture.
        first: PathBuf,
        /// Path of the second picture.
        second: PathBuf,
    },
    /// The poses have frames without pictures.
    #[error("{folder}: no picture of {}, which {poses} has; expected one for each pose", named(frames))]
    MissingFrames {
        /// Folder of the pictures.
        folder: PathBuf,
        /// File of the poses.
        poses: PathBuf,
        /// Frames that are missing, ascending.
        frames: Vec<u64>,
    },
    /// The folder has pictures without poses.
    #[error("{poses}: no pose of {}, which {folder} has; expected one for each picture", named(frames))]
    MissingPoses {
        /// Folder of the pictures.
        folder: PathBuf,
        /// File of the poses.
        poses: PathBuf,
        /// Frames that are missing, ascending.
        frames: Vec<u64>,
    },
    /// A picture of another size.
    #[error(
        "{path}: {} columns and {} lines, expected {} and {} as {of}; give each size a sequence of its own",
        found[0], found[1], expected[0], expected[1]
    )]
    Size {
        /// Path of the picture.
        path: PathBuf,
        /// Columns and lines found.
        found: [usize; 2],
        /// Columns and lines expected.
        expected: [usize; 2],
        /// Name of what has the expected size.
        of: String,
    },
    /// The pictures would be written over.
    #[error("{path}: the new pictures would replace the old ones; choose another folder")]
    SameFolder {
        /// Path of the folder.
        path: PathBuf,
    },
    /// The sun has no shadow.
    #[error("frame {frame}: {source}")]
    Sun {
        /// Number of the frame.
        frame: u64,
        /// Why the sun casts no shadow.
        source: LowSun,
    },
    /// The pose is not over the ground.
    #[error("{0}; do these pictures show the ground of this scenario?")]
    Pose(#[from] FrameError),
    /// Tracks without ground data.
    #[error(
        "tracks need ground data: a picture alone gives no heights, so a track behind a rise cannot be hidden, nor one \
         on a slope be laid (report IV.A); name the scenario of the ground by --ground"
    )]
    TracksWithoutGround,
    /// Ground with things that this shadow has no law for.
    #[error(
        "the scenario of the ground has {0}; expected ground, and closed objects that stand still under the scenario's sun; take \
         them out, or name another scenario by --ground"
    )]
    Guests(String),
    /// Poses along which no tracks can be laid.
    #[error("tracks along the poses: {0}")]
    Tracks(String),
}

/// "frames 3, 4, 7 and 12 others".
fn named(frames: &[u64]) -> String {
    const MOST: usize = 5;
    let words: Vec<String> = frames.iter().take(MOST).map(u64::to_string).collect();
    let more = frames.len().saturating_sub(MOST);
    let others = if more > 0 { format!(" and {more} others") } else { String::new() };
    format!("frame{} {}{others}", if frames.len() == 1 { "" } else { "s" }, words.join(", "))
}
