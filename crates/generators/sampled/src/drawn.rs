//! The picture of a frame, with what found no place in its lists.

use scene_sampler::Picture;

use crate::overload::LostEntry;

/// A picture as if everything were in time. The beam's spots are not yet in it.
pub struct Drawn {
    pub picture: Picture,
    /// Entries that found no place in the lists, by sub-area.
    pub lost: Vec<LostEntry>,
}
