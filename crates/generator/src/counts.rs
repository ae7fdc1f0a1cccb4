//! Work done: counters are results, the same for any number of threads.

/// What a frame took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameCounts {
    /// Sweeps drawn.
    pub sweeps: u64,
    /// Samples of all sweeps, or rays of a generator without sweeps.
    pub samples: u64,
    /// Stored regions that the frame can show: what a data bank must have ready.
    pub regions: u64,
    /// Region crossings.
    pub folds: u64,
    /// Sets of words that arrived at registers.
    pub loads: u64,
    /// Words that came after the fold that needed them.
    pub late_words: u64,
}

impl FrameCounts {
    /// Adds another part's work.
    pub fn add(&mut self, other: &Self) {
        self.sweeps += other.sweeps;
        self.samples += other.samples;
        self.regions += other.regions;
        self.folds += other.folds;
        self.loads += other.loads;
        self.late_words += other.late_words;
    }
}
