//! Why a run cannot begin or go on.

use std::io;
use std::ops::Range;
use std::path::PathBuf;

use files::{FileError, FolderError, NpyError};
use generator::{FrameError, PrepareError};
use picture::{PictureError, PictureFileError};
use scenario::PathProblems;

/// A run that cannot begin or go on.
#[derive(Debug, thiserror::Error)]
pub enum ReplayError {
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A frame on disk that is no picture.
    #[error(transparent)]
    PictureFile(#[from] PictureFileError),
    /// A folder that cannot be written into: it is in use, it is a link, or something in it is.
    #[error(transparent)]
    Claim(#[from] FolderError),
    /// A file of the run that cannot be kept.
    #[error("{path}: cannot {doing}: {source}")]
    Folder {
        /// The folder or the file in it.
        path: PathBuf,
        /// What was tried, as words after `cannot`.
        doing: &'static str,
        /// What the system says.
        source: io::Error,
    },
    /// The folder holds files that are not of a run.
    #[error(
        "{path}: holds `{found}`, which is not of a run; choose another --out, or keep it beside the run with \
         --fresh (only files of runs are ever removed)"
    )]
    Foreign {
        /// Path of the run folder.
        path: PathBuf,
        /// The first file found.
        found: String,
    },
    /// A file of somebody else has the name that a run would write.
    #[error("{path}: holds `{found}`, which no run wrote and a run would replace; choose another --out")]
    WouldReplace {
        /// Path of the run folder.
        path: PathBuf,
        /// Name of the file that would be replaced.
        found: String,
    },
    /// The folder holds a run of something else.
    #[error(
        "{path}: holds another run, from which this one differs: {differences}; choose another --out, or remove that run \
         with --fresh"
    )]
    OtherRun {
        /// Path of the run folder.
        path: PathBuf,
        /// Every key that differs, in words.
        differences: String,
    },
    /// Frames that the mission does not have.
    #[error(
        "{path}: holds frame {frame}, and the mission has frames 0..{frames}: the mission was cut to fewer frames since, or this \
         file was changed; choose another --out, or draw the run anew with --fresh"
    )]
    Beyond {
        /// Path of the record or the journal.
        path: PathBuf,
        /// The last frame that it lists.
        frame: u64,
        /// Frames of the mission.
        frames: u64,
    },
    /// A pose from which nothing follows.
    #[error(
        "frame {frame} (t = {time} s): the path goes at {speed} m/s there, expected at most {most} m/s; move its points nearer to \
         each other, or their times further apart"
    )]
    Speed {
        /// Number of the frame, counted at the update rate.
        frame: u64,
        /// Time of the frame (s).
        time: f64,
        /// Speed of the vehicle (m/s).
        speed: f64,
        /// Greatest speed that is drawn (m/s).
        most: f64,
    },
    /// A record that cannot be read.
    #[error(
        "{path}: not the record of a run ({reason}); if it is damaged, the same replay with --fresh draws the run anew"
    )]
    Record {
        /// Path of the record.
        path: PathBuf,
        /// Why it cannot be read.
        reason: String,
    },
    /// Files of a run whose record is gone.
    #[error(
        "{path}: there is no such file, but other files of a run are there; the same replay with --fresh draws the run \
         anew"
    )]
    NoRecord {
        /// Path of the missing record.
        path: PathBuf,
    },
    /// A run that has a journal and no record yet.
    #[error("{path}: this run is not finished; the same replay again draws the rest")]
    Unfinished {
        /// Path of the run folder.
        path: PathBuf,
    },
    /// The folder holds truth of other kinds.
    #[error(
        "{path}: holds ground truth of other kinds, or made from something else, than {asked} of this run; ask for \
         those that it holds (truth.json lists them), or remove that folder to have it made anew"
    )]
    OtherTruth {
        /// The folder of the truth.
        path: PathBuf,
        /// What was asked for.
        asked: String,
    },
    /// A record of truth that cannot be read.
    #[error(
        "{path}: not the record of ground truth ({reason}); remove its folder to have the truth made anew"
    )]
    TruthRecord {
        /// Path of the record.
        path: PathBuf,
        /// Why it cannot be read.
        reason: String,
    },
    /// A plane with a value that is no number.
    #[error(
        "frame {frame}: ground truth `{item}` holds a value that is no number; please report the scenario"
    )]
    TruthNotANumber {
        /// Number of the frame, counted at the update rate.
        frame: u64,
        /// Name of the kind of ground truth.
        item: &'static str,
    },
    /// Planes that do not make an array.
    #[error("frame {frame}: ground truth: {source}")]
    TruthArray {
        /// Number of the frame, counted at the update rate.
        frame: u64,
        /// Why the planes do not make an array.
        source: NpyError,
    },
    /// The frames asked for do not touch those that are there.
    #[error(
        "{path}: holds frames {}..{}, frames {}..{} do not touch them; choose another --out, or --fresh",
        held.start, held.end, asked.start, asked.end
    )]
    Gap {
        /// Path of the run folder.
        path: PathBuf,
        /// Frames that the folder holds.
        held: Range<u64>,
        /// Frames that were asked for.
        asked: Range<u64>,
    },
    /// The folder of a joined run holds frames that the joined run does not have.
    #[error(
        "{path}: holds frame {frame}, and the joined run has frames {}..{}; choose another --out, or remove that run",
        range.start, range.end
    )]
    OtherFrames {
        /// Path of the run folder.
        path: PathBuf,
        /// A frame of the folder that the joined run does not have.
        frame: u64,
        /// Frames of the joined run.
        range: Range<u64>,
    },
    /// A file of wall times that does not have the time of every frame.
    #[error("{path}: {reason}; draw that run anew with --fresh, all frames in one session")]
    Costs {
        /// Path of the file.
        path: PathBuf,
        /// What is missing, in words.
        reason: String,
    },
    /// A file of a run that is gone, or is not what its record says.
    #[error(
        "{path}: gone, or its bytes are not those that the record of its run lists; the same replay into that folder makes the file anew"
    )]
    Changed {
        /// Path of the file.
        path: PathBuf,
    },
    /// More sweeps to be checked than there are.
    #[error("--check {asked}: the run has {available} sweeps; expected no more of them")]
    TooManyChecks {
        /// Number of sweeps asked for.
        asked: u32,
        /// Sweeps of the run.
        available: u64,
    },
    /// No frame was asked for.
    #[error("frames {}..{}: expected at least one frame", .0.start, .0.end)]
    NoFrames(Range<u64>),
    /// The path cannot be driven.
    #[error(transparent)]
    Poses(#[from] PathProblems),
    /// The generator cannot draw the stage.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// Frames in colour of a generator that has none.
    #[error(
        "{generator} draws no colour: expected a generator that fills the planes red, green and blue; draw grey frames \
         with it"
    )]
    NoColour {
        /// Name of the generator.
        generator: &'static str,
    },
    /// The generator cannot draw a frame.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The display transfer of the scenario.
    #[error("display: {0}")]
    Display(PictureError),
    /// A frame that is no picture.
    #[error("frame {frame}: {source}")]
    Picture {
        /// Number of the frame, counted at the update rate.
        frame: u64,
        /// Why the frame is no picture.
        source: PictureError,
    },
    /// The contact sheet or a film.
    #[error("{path}: {source}")]
    Film {
        /// Path of the contact sheet or film.
        path: PathBuf,
        /// Why the picture cannot be made.
        source: PictureError,
    },
}
