//! The event list of a sweep: stops, transfers, words that arrive, words that are late.

/// A register of a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// Feeds the multiplying D/As.
    Hold,
    /// Waits for a stop of X.
    XFirst,
    /// Waits for a stop of Y.
    YFirst,
}

/// What happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Happening {
    /// A ramp meets a stop: axis (0 is X), and whether it is the stop at 1.
    Stop {
        /// 0 for X, 1 for Y.
        axis: usize,
        /// Whether it is the stop at 1.
        at_one: bool,
        /// Stops of the sweep before this one.
        crossing: u32,
    },
    /// Hold of a colour takes a preload register.
    Transfer {
        /// Yellow, green, black, red.
        colour: usize,
        /// The one that is taken.
        register: Register,
        /// Stops of the sweep before this one.
        crossing: u32,
    },
    /// Words arrive at a register.
    Load {
        /// Yellow, green, black, red.
        colour: usize,
        /// Where they go.
        register: Register,
        /// Corner that they belong to: north, east.
        corner: [i64; 2],
        /// Which, bit 3 p + q.
        words: u16,
    },
    /// Words miss the stop that they are meant for.
    Late {
        /// Yellow, green, black, red.
        colour: usize,
        /// The register that is transferred without them.
        register: Register,
        /// Stops of the sweep before this one.
        crossing: u32,
        /// Which, bit 3 p + q.
        words: u16,
    },
}

impl Happening {
    /// Word in tables.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Stop { .. } => "stop",
            Self::Transfer { .. } => "transfer",
            Self::Load { .. } => "load",
            Self::Late { .. } => "late",
        }
    }
}

/// One event.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Event {
    /// Master tick since the start of the mission.
    pub tick: i64,
    /// Level of terrain: 0 fine, 1 coarse.
    pub level: usize,
    /// What happens.
    pub what: Happening,
}
