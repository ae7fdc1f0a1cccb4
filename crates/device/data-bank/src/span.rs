//! A stretch of time.

/// From one tick to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Span {
    pub(crate) start: u64,
    pub(crate) end: u64,
}

impl Span {
    /// Ticks of it from `from` to `until`.
    pub(crate) fn part(self, from: u64, until: u64) -> u64 {
        until.min(self.end).saturating_sub(from.max(self.start))
    }
}
