//! Late words of one place, as a question asks for them.

/// Names words that were late in one sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LateWords {
    /// Number of the frame, from 0.
    pub frame: u64,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// What waited for the words.
    pub of: LateOf,
}

/// What of a sweep waits for words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LateOf {
    /// A fold of the ramps, whose registers missed them.
    Crossing {
        /// Level of terrain, from 0, the finest.
        level: usize,
        /// Fold of that level's ramps that found the words missing, counted from 0 in the sweep.
        crossing: u32,
    },
    /// A crater, by its number in the list of features.
    Crater(u32),
    /// A shadow boundary, by the number of its load in the sweep, from 0.
    Boundary(u32),
}

impl LateOf {
    /// The crater, if it is one.
    pub(crate) fn crater(self) -> Option<u32> {
        if let Self::Crater(number) = self { Some(number) } else { None }
    }

    /// The load of a shadow boundary, if it is one.
    pub(crate) fn boundary(self) -> Option<u32> {
        if let Self::Boundary(number) = self { Some(number) } else { None }
    }
}
