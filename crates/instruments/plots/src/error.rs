//! Why a picture cannot be drawn.

use files::FileError;

/// Why a picture cannot be drawn or written.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// A panel is too small or too large.
    #[error("panel of {found} pixels: expected {least} to {most}")]
    PanelSize {
        /// Pixels asked for.
        found: u32,
        /// Least.
        least: u32,
        /// Most.
        most: u32,
    },
    /// The number of values is not what goes with them.
    #[error("{what}: {found} values, expected {expected}")]
    Count {
        /// Which values.
        what: String,
        /// How many there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// There is nothing to draw.
    #[error("{what}: no finite value, expected at least one")]
    Empty {
        /// What is empty.
        what: String,
    },
    /// A value is out of its range.
    #[error("{what} = {found}: expected {expected}")]
    Value {
        /// Which.
        what: String,
        /// The value.
        found: f64,
        /// Its range, in words.
        expected: &'static str,
    },
    /// The file.
    #[error(transparent)]
    File(#[from] FileError),
}
