//! Why a page cannot be made.

use std::ops::Range;

use files::FileError;
use generator::{FrameError, PrepareError};
use replay::ReplayError;
use report::ReportError;
use scenario::PathProblems;
use scope::ScopeError;

/// Why a page cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// A request that the run cannot meet.
    #[error(transparent)]
    Request(#[from] RequestError),
    /// The record of the run cannot be read.
    #[error(transparent)]
    Run(#[from] ReplayError),
    /// The page, or what stands beside it, cannot be read or written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The path cannot be driven.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// The generator cannot draw the stage.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// A pose cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// A sweep cannot be shown.
    #[error(transparent)]
    Scope(#[from] ScopeError),
    /// A plot cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
}

/// Why sweeps that are asked for cannot be recorded.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RequestError {
    /// The generator has no signals.
    #[error(
        "{request}: {generator} has no signals that a page could show; expected a hardware model, or another generator that has signals"
    )]
    NoSignals {
        /// The option with its value.
        request: String,
        /// Name of the generator.
        generator: &'static str,
    },
    /// The run does not have the frame.
    #[error("{request}: the run has frames {}..{}; expected one of them", .frames.start, .frames.end)]
    NoFrame {
        /// The option with its value.
        request: String,
        /// Frames of the run.
        frames: Range<u64>,
    },
    /// The frame does not have the sweeps.
    #[error("{request}: a frame has sweeps 0..{sweeps}; expected a range inside")]
    NoSweeps {
        /// The option with its value.
        request: String,
        /// Sweeps of a frame.
        sweeps: u32,
    },
    /// A pattern names no signal.
    #[error("{request}:{pattern}: no signal of this name; `lunoid signals` lists them")]
    Unknown {
        /// The option with its value.
        request: String,
        /// Pattern that matches no signal.
        pattern: String,
    },
    /// More sweeps than a page takes.
    #[error("--probe: {found} sweeps; expected at most {most}")]
    TooMany {
        /// Number of sweeps asked for.
        found: u64,
        /// Most that a page takes.
        most: u64,
    },
}
