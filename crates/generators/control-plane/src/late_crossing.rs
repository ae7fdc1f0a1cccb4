//! One fold that found words missing, as a question asks for it.

/// Names the words that one fold found missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LateCrossing {
    /// Number of the frame, from 0.
    pub frame: u64,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// Level of terrain, from 0, the finest.
    pub level: usize,
    /// Fold of that level's ramps that found the words missing, counted from 0 in the sweep.
    pub crossing: u32,
}
