//! Why there is no photograph, or none of this ground.

use diagnostics::Problem;
use files::FileError;
use photographs::PhotographFileError;
use picture::PictureError;

/// A photograph that cannot be read, or that does not show the ground.
#[derive(Debug, thiserror::Error)]
pub enum PhotoError {
    /// The picture file cannot be read, or is of another kind than 8 or 16 bits.
    #[error(transparent)]
    Picture(#[from] PhotographFileError),
    /// The grey curve cannot be used.
    #[error(transparent)]
    Curve(#[from] PictureError),
    /// The camera file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The camera file is not what it should be.
    #[error("{}", text(.0))]
    Camera(Box<Problem>),
    /// No ground point lies in the photograph.
    #[error(
        "the photograph has no pixel in common with the ground: it has {columns} columns and {lines} lines, and of \
         {points} ground points {behind} lie behind the camera and the others at {place}; give the camera of this photograph, or \
         an elevation file of its ground"
    )]
    NothingInCommon {
        /// Number of columns of the photograph.
        columns: usize,
        /// Number of lines of the photograph.
        lines: usize,
        /// Number of ground points.
        points: usize,
        /// Number of points behind the camera.
        behind: usize,
        /// Pixels of the points in front, in words.
        place: String,
    },
}

/// A problem of a file in one line: file, title, what to do.
fn text(problem: &Problem) -> String {
    let help = problem.help.as_ref().map_or_else(String::new, |help| format!("; {help}"));
    format!("{}: {}{help}", problem.file, problem.title)
}
