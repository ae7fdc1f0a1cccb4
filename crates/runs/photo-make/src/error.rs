//! Why no photograph is made.

use diagnostics::Problem;
use files::{FileError, FolderError};
use generator::{FrameError, PrepareError};
use photo_camera::CameraError;
use picture::{PictureError, PictureFileError};

/// Why no photograph is made.
#[derive(Debug, thiserror::Error)]
pub enum MakeError {
    /// A figure of the wishes is out of its range.
    #[error("{what} is {found}: expected {expected}")]
    Wish {
        /// Name of the figure with its unit.
        what: &'static str,
        /// The value that was found.
        found: f64,
        /// The range in words.
        expected: &'static str,
    },
    /// The centre does not lie on the ground.
    #[error(
        "the centre at {north} m north, {east} m east lies beside the ground, which reaches from {south_edge} to {north_edge} m \
         north and from {west_edge} to {east_edge} m east; choose a centre inside"
    )]
    Centre {
        /// North of the centre (m).
        north: f64,
        /// East of the centre (m).
        east: f64,
        /// South edge of the ground (m).
        south_edge: f64,
        /// North edge of the ground (m).
        north_edge: f64,
        /// West edge of the ground (m).
        west_edge: f64,
        /// East edge of the ground (m).
        east_edge: f64,
    },
    /// The camera stands in the ground.
    #[error(
        "the camera stands {below:.3} m under the ground, at a height of {height:.3} m; give a greater height, a smaller field \
         of view or a steeper pitch"
    )]
    UnderGround {
        /// How far below the ground (m).
        below: f64,
        /// Height of the camera in the landscape's axes (m).
        height: f64,
    },
    /// No pixel shows ground.
    #[error("no pixel of {columns} x {lines} shows the ground; choose another centre or pitch")]
    NoGround {
        /// Number of columns of the picture.
        columns: u32,
        /// Number of lines of the picture.
        lines: u32,
    },
    /// The generator cannot draw the stage.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The generator cannot draw the pose.
    #[error(transparent)]
    Frame(FrameError),
    /// The figures make no camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The light makes no picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The camera file that was written cannot be read back.
    #[error("the camera file cannot be read back: {}", .0.title)]
    ReadBack(Box<Problem>),
}

/// Why the files of a photograph are not written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The folder cannot be made, or another process writes into it.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The picture cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureFileError),
}
