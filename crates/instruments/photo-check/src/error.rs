//! Why a ground cannot be held against a photograph.

use photo_camera::voids::VoidError;

/// Why a ground cannot be held against a photograph.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GroundError {
    /// The grid is too small to have slopes.
    #[error("the elevation file has {lines} lines of {columns} posts: expected 2 or more each way")]
    Small {
        /// Number of lines of the grid.
        lines: usize,
        /// Number of posts in a line.
        columns: usize,
    },
    /// The places of the posts do not go with the photograph.
    #[error("the elevation file has its places {found}, and {photo} needs them {expected}; {remedy}")]
    Axes {
        /// How the file gives its places.
        found: &'static str,
        /// What the photograph is placed by.
        photo: &'static str,
        /// How the places would have to be given.
        expected: &'static str,
        /// What to do about it.
        remedy: &'static str,
    },
    /// The voids cannot be filled.
    #[error("{0}")]
    Voids(#[from] VoidError),
}
