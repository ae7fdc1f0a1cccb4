//! Why there is no briefing.

use photo_drape::DrapeError;
use picture::PictureError;

/// A flight that cannot be told beside a map.
#[derive(Debug, thiserror::Error)]
pub enum BriefingError {
    /// The photographs cannot be laid over the ground, or the ground has no posts.
    #[error("the map cannot be drawn: {0}")]
    Map(#[from] DrapeError),
    /// A picture has no pixels, a code beyond white, or another size than the map.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A page is asked for a frame that the course does not have.
    #[error("frame {frame}: expected below {frames}, the frames of the course")]
    Frame {
        /// Number of the frame.
        frame: usize,
        /// How many frames the course has.
        frames: usize,
    },
}
