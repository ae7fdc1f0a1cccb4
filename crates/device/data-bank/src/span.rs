//! A stretch of time.

/// From one tick to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Span {
    pub(crate) start: u64,
    pub(crate) end: u64,
}

impl Span {
    /// The nearest tick of it.
    pub(crate) fn nearest(self, tick: u64) -> u64 {
        tick.clamp(self.start, self.end)
    }
}
