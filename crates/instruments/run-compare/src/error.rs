//! Why runs or pictures cannot be compared.

use std::path::PathBuf;

use compare::CompareError;
use front_door::OpenError;
use generator::{FrameError, PrepareError};
use photographs::PhotographFileError;
use picture::{PictureError, PictureFileError};
use replay::ReplayError;
use scenario::PathProblems;

/// Why runs or pictures cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum RunCompareError {
    /// There is nothing of the name.
    #[error("{}: no such file or folder; check the spelling", .0.display())]
    Missing(PathBuf),
    /// Edges are to be left out of pictures that know no frame.
    #[error("--ridges and --edges need run folders, which know the frame of each picture")]
    NoFrames,
    /// A picture is to be compared with a run.
    #[error(
        "{} and {}: one is a folder and one a file; expected two pictures or two run folders",
        .0[0].display(), .0[1].display()
    )]
    Mixed([PathBuf; 2]),
    /// The runs have no frame in common.
    #[error("{} and {}: no frame is in both runs; expected at least one", .0[0].display(), .0[1].display())]
    NoCommonFrame([PathBuf; 2]),
    /// A run is not of the scenario whose edges are left out.
    #[error(
        "{}: {key} = {found}, but the scenario of {option} has {expected}; name the scenario of the run",
        .folder.display()
    )]
    OtherScenario {
        /// Folder of the run.
        folder: PathBuf,
        /// What differs, as a key of the record.
        key: String,
        /// Its value in the run.
        found: String,
        /// The option that names the scenario.
        option: &'static str,
        /// Its value in the scenario.
        expected: String,
    },
    /// Two pictures do not go together.
    #[error("{} against {}: {error}", .picture.display(), .reference.display())]
    Unlike {
        /// The picture under test.
        picture: PathBuf,
        /// The picture that it is held against.
        reference: PathBuf,
        /// Why the pictures cannot be compared.
        error: CompareError,
    },
    /// The display law in the record of a run is none.
    #[error("{}: run.json, view.display: {error}", .folder.display())]
    Display {
        /// Folder of the run.
        folder: PathBuf,
        /// Why the display law is invalid.
        error: PictureError,
    },
    /// Pictures or planes cannot be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// A run cannot be read.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// A frame cannot be read.
    #[error(transparent)]
    Picture(#[from] PictureFileError),
    /// A picture cannot be read.
    #[error(transparent)]
    Photograph(#[from] PhotographFileError),
    /// The scenario cannot be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The scenario cannot be drawn.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The path cannot be driven.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// A frame cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
}
