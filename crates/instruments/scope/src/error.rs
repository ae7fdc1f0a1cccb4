//! Why signals cannot be recorded or shown.

use std::path::PathBuf;

use generator::FrameError;
use picture::PictureError;
use plots::{Line, PlotError};
use waveform::WaveformError;

use crate::size;

/// Why signals cannot be recorded or shown.
#[derive(Debug, thiserror::Error)]
pub enum ScopeError {
    /// The generator has no signals.
    #[error("machine {0} has no signals; expected a hardware model")]
    NoSignals(String),
    /// A pattern names no signal.
    #[error("--signals {0}: no signal of this name; `lunoid signals` lists them")]
    Unknown(String),
    /// None of the signals that are to be shown runs along the line.
    #[error(
        "--signals: none of them runs along the {line}; a picture needs one beside {place}; `lunoid signals` lists them"
    )]
    NothingAlong {
        /// What a line of the signals is: a sweep or a row.
        line: &'static str,
        /// The signal that says where a sample is.
        place: &'static str,
    },
    /// No two signals that can be drawn over each other.
    #[error(
        "--axis xy: {0}; expected two analog signals by their names, as sweep.x,sweep.y: the first runs across, the second up"
    )]
    NoPair(String),
    /// A row or a scan line is asked for what only a sweep has.
    #[error("{given}: {}", without_time(*line))]
    NoTime {
        /// The option or the place.
        given: String,
        /// What has no time.
        line: Line,
    },
    /// A place lies beyond the samples.
    #[error(
        "{option} {found}{unit}: the samples lie from {low:.3} to {high:.3}{unit}; expected a place there"
    )]
    Beyond {
        /// The option that names it.
        option: &'static str,
        /// Where it lies (`unit`).
        found: f64,
        /// Unit of the three numbers: metres or microseconds.
        unit: &'static str,
        /// The first sample (`unit`).
        low: f64,
        /// The last sample (`unit`).
        high: f64,
    },
    /// A file of waveforms would be large, which nobody asked for.
    #[error(
        "{}: the file would have about {}; give --large to write it, or choose fewer sweeps or signals",
        .out.display(), size(*.bytes)
    )]
    TooLarge {
        /// File that would be written.
        out: PathBuf,
        /// Size of the file (bytes).
        bytes: u64,
    },
    /// The pose cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The picture column cannot be made.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The page cannot be drawn as asked.
    #[error(transparent)]
    Look(PlotError),
    /// The page cannot be written.
    #[error(transparent)]
    Write(PlotError),
    /// The file of waveforms cannot be written.
    #[error(transparent)]
    Waveform(#[from] WaveformError),
}

/// What a line without time has instead.
fn without_time(line: Line) -> &'static str {
    match line {
        Line::ScanLine => "a scan line has no sweep time; expected places that are counted along it, as 120",
        Line::Sweep | Line::Row => {
            "a row has no sweep time; expected places to the right of the line of sight in metres, as -120.5"
        }
    }
}
