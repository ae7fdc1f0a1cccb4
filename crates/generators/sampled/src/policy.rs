//! What happens where memory or time is short.

/// Which features lose their places where there are not enough, and what is shown where there is not enough time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overload {
    /// Those that are smallest on the screen.
    DropSmallest,
    /// Those that are farthest in the middle of the sub-area.
    DropFarthest,
    /// Those that are smallest; a sub-area that is not read out in time is shown as it was in the frame before.
    Late,
    /// Those that are smallest; a frame that is not read out in its field takes whole fields more.
    Extend,
}

impl Overload {
    /// Words of the run parameter, with what they mean.
    pub const WORDS: [(&str, Self); 4] = [
        ("drop-smallest", Self::DropSmallest),
        ("drop-farthest", Self::DropFarthest),
        ("late", Self::Late),
        ("extend", Self::Extend),
    ];

    /// Its word in scenarios and records.
    pub fn word(self) -> &'static str {
        Self::WORDS[self as usize].0
    }

    /// Whether a picture may show a frame before its own: it is then a function of the sampler too.
    pub fn shows_earlier_frames(self) -> bool {
        matches!(self, Self::Late | Self::Extend)
    }
}
