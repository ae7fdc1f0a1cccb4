//! A frame of a run.

use generator::{Counter, FrameCounts};
use serde::{Deserialize, Serialize};

use crate::{FileRecord, stays_inside};

/// Most that a frame counts of anything: sums over all frames of a mission stay far from the end of 64 bits.
const MOST_WORK: u64 = 1 << 40;

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

impl FrameRecord {
    /// What no run can have written of a frame, in words: a file that leads out of the folder, or more work than a frame can be.
    pub fn fault(&self) -> Option<String> {
        if let Some(fault) = fault_of_files(&self.files) {
            return Some(fault);
        }
        let (name, count) = self.counts.named().find(|(_, count)| *count > MOST_WORK)?;
        Some(format!("frame {} counts {count} {name}; expected at most {MOST_WORK}", self.frame))
    }
}

/// What is wrong with the names of `files`, in words: one leads out of the folder of its record.
pub(crate) fn fault_of_files(files: &[FileRecord]) -> Option<String> {
    let outside = files.iter().find(|listed| !stays_inside(&listed.file))?;
    Some(format!("it lists `{}`, expected files of its folder", outside.file))
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
