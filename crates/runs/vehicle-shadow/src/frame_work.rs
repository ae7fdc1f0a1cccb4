//! What became of one frame.

use serde::{Deserialize, Serialize};

use crate::blanking::Blanking;
use crate::work::{Work, WorkTimes};

/// What became of one frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameWork {
    /// Number of the frame.
    pub frame: u64,
    /// Seconds since the start of the mission.
    pub time_s: f64,
    /// Name of the file.
    pub file: String,
    /// Hash of the new picture's pixels.
    pub pixels_blake3: String,
    /// Counts of the work done.
    #[serde(flatten)]
    pub work: Work,
    /// Times of gear of 1969.
    #[serde(flatten)]
    pub times: WorkTimes,
    /// Where the video is blanked.
    #[serde(flatten)]
    pub blanking: Blanking,
}
