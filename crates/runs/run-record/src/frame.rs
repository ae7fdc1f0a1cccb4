//! A frame of a run.

use generator::{Counter, FrameCounts};
use serde::{Deserialize, Serialize};

use crate::FileRecord;

/// One update: what the generator computed once, shown in one file, or in several at a higher refresh rate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameRecord {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Seconds since the start of the mission.
    pub time_s: f64,
    /// BLAKE3 of the pixels, hexadecimal: independent of how the file packs them.
    pub pixels_blake3: String,
    /// The pictures, in order.
    pub files: Vec<FileRecord>,
    /// Work that it was.
    pub counts: FrameCounts,
}

/// The work of all `frames` of a generator with these `counters`.
pub fn total_work<'a>(
    frames: impl IntoIterator<Item = &'a FrameRecord>,
    counters: &[Counter],
) -> FrameCounts {
    let mut total = FrameCounts::default();
    frames.into_iter().for_each(|frame| total.join(&frame.counts, counters));
    total
}
