//! What the program refuses.

use photo_camera::voids::VoidError;

/// Why the program cannot draw.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ProgramError {
    /// The listing has no room for it.
    #[error("{what}: {found}; the program as listed holds {most}")]
    Limit {
        /// Subject of the limit.
        what: &'static str,
        /// The count that was found.
        found: usize,
        /// The most that the listing holds.
        most: usize,
    },
    /// Panels reach beyond the frame of the photograph.
    #[error(
        "{posts} of the posts lie beside the photograph; the program as listed reads one frame and no other"
    )]
    BesideFrame {
        /// Number of posts beside the photograph.
        posts: usize,
    },
    /// The photograph is a map, or its camera stands in other axes than the posts.
    #[error("the first photograph has {found}; the posts expect {expected}")]
    Axes {
        /// Axes of the photograph.
        found: &'static str,
        /// Axes that the posts expect.
        expected: &'static str,
    },
    /// The listing has one way to fill a panel with both ends of a span.
    #[error("a span with both its ends is filled by the edge buffer of the listing alone")]
    WrittenFill,
    /// A void cannot be filled.
    #[error(transparent)]
    Void(#[from] VoidError),
}
