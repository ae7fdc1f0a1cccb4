//! Parts of the ground that take another level of detail.

use serde::{Deserialize, Serialize};

use crate::record::TimingRecord;

/// A tile of ground that is drawn at another level of detail than in the frame before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LevelChange {
    /// Name of the tile, as the generator explains it: `tile.3.7` in column 3 of row 7. Each once a frame.
    pub tile: String,
    /// Level in the frame before, from 0, the finest.
    pub from: u32,
    /// Level in this frame.
    pub to: u32,
    /// Distance (m) from the eye by which the level is chosen, in this frame.
    pub distance_m: f64,
    /// How far the tile has become the next coarser level in this frame, 0 to 1.
    pub fraction: f64,
    /// South, west, north and east border of the tile on the map (m).
    pub borders_m: [f64; 4],
}

impl TimingRecord {
    /// The changes of level of all frames, each with its frame, in order.
    pub fn level_changes(&self) -> impl Iterator<Item = (u64, &LevelChange)> {
        self.frames.iter().flat_map(|frame| frame.level_changes.iter().map(|change| (frame.frame, change)))
    }
}
