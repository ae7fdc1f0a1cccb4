//! Why a mission cannot be rehearsed, or its deadlines not be shown.

use ::plots::PlotError;
use compare::CompareError;
use front_door::OpenError;
use generator::{FrameError, PrepareError};
use picture::PictureError;
use scenario::PathProblems;

/// Why a mission cannot be rehearsed, or its deadlines not be shown.
#[derive(Debug, thiserror::Error)]
pub enum DeadlineError {
    /// The stage cannot be made.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The generator cannot draw the stage.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The vehicle cannot take the path.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// A pose cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The frames of the generator take no time.
    #[error(
        "--machine {0}: its frames take no time with these run parameters; its data sheet says with which they do"
    )]
    NoTime(String),
    /// More missed deadlines than a record keeps.
    #[error(
        "{misses} missed deadlines in {frames} frames: expected at most {most}; choose fewer --frames or --sweeps"
    )]
    TooManyMisses {
        /// Missed deadlines so far.
        misses: usize,
        /// Frames in which they were missed.
        frames: usize,
        /// Most that are kept.
        most: usize,
    },
    /// A timeline is to begin beyond the end of its sweep.
    #[error("--range-m {near},{far}: sweep {sweep} goes to {end:.1} m; expected a nearer range")]
    BeyondSweep {
        /// Where it is to begin (m).
        near: f64,
        /// Where it is to end (m).
        far: f64,
        /// Number of the sweep, from 0.
        sweep: u32,
        /// Ground range to which the sweep goes (m).
        end: f64,
    },
    /// Two pictures are not of one size.
    #[error(
        "the baseline's pictures have {} x {} pixels, these {} x {}; pictures of one size are compared alone",
        .baseline[0], .baseline[1], .found[0], .found[1]
    )]
    OtherSize {
        /// Columns and lines of the baseline.
        baseline: [usize; 2],
        /// Columns and lines that were found.
        found: [usize; 2],
    },
    /// No fan of sweeps covers the pose.
    #[error("no fan of sweeps covers the pose")]
    NoFan,
    /// A picture cannot be made of intensities.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// Two pictures cannot be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// What was asked for cannot be drawn.
    #[error(transparent)]
    Asked(PlotError),
    /// A record cannot be drawn.
    #[error(transparent)]
    Plot(PlotError),
    /// A plot cannot be written.
    #[error(transparent)]
    Write(PlotError),
}
