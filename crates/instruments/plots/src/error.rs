//! Why a picture cannot be drawn.

use files::FileError;

/// Why a picture cannot be drawn or written.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// A panel is too small or too large.
    #[error("panel of {found} pixels: expected {least} to {most}")]
    PanelSize {
        /// Size that was asked for (pixels).
        found: u32,
        /// Least size that is allowed (pixels).
        least: u32,
        /// Largest size that is allowed (pixels).
        most: u32,
    },
    /// The number of values is not what goes with them.
    #[error("{what}: {found} values, expected {expected}")]
    Count {
        /// Name of the values.
        what: String,
        /// How many there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// There is nothing to draw.
    #[error("{what}: no finite value, expected at least one")]
    Empty {
        /// Name of what is empty.
        what: String,
    },
    /// A value is out of its range.
    #[error("{what} = {found}: expected {expected}")]
    Value {
        /// Name of the value.
        what: String,
        /// Value that was found.
        found: f64,
        /// Its range, in words.
        expected: &'static str,
    },
    /// The file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
}
