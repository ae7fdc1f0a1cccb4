//! The event list of a sweep: everything that the digital side does for it over one level.

/// A register of a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// Feeds the multiplying D/As.
    Hold,
    /// Waits for a stop of X.
    XFirst,
    /// Waits for a stop of Y.
    YFirst,
    /// Waits for both.
    Diagonal,
}

/// A set of nine words that a stop has asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AskedFor {
    /// Yellow, green, black, red.
    pub colour: usize,
    /// Where it goes.
    pub register: Register,
    /// The stop, counted from 0 in the sweep.
    pub crossing: u32,
}

/// What happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Happening {
    /// A register is full as the sweep begins.
    Home {
        /// Yellow, green, black, red.
        colour: usize,
        /// Which.
        register: Register,
        /// Corner of its words: north, east.
        corner: [i64; 2],
    },
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
    /// A full set is overwritten unused.
    Wasted {
        /// Yellow, green, black, red.
        colour: usize,
        /// Where it was.
        register: Register,
        /// Corner that it belonged to.
        corner: [i64; 2],
    },
    /// A set is asked for.
    Wanted(AskedFor),
    /// A set is dropped before anyone fetches it.
    Cancelled(AskedFor),
    /// The corner beyond both stops is at hand and moves over to a preload register.
    Diagonal {
        /// Whose, where to, at which stop.
        set: AskedFor,
        /// The corner.
        corner: [i64; 2],
    },
    /// The first access of a set begins.
    Access {
        /// Whose, where to, asked at which stop.
        set: AskedFor,
        /// The corner.
        corner: [i64; 2],
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
            Self::Home { .. } => "home",
            Self::Stop { .. } => "stop",
            Self::Transfer { .. } => "transfer",
            Self::Wasted { .. } => "wasted",
            Self::Wanted(_) => "wanted",
            Self::Cancelled(_) => "cancelled",
            Self::Diagonal { .. } => "diagonal",
            Self::Access { .. } => "access",
            Self::Load { .. } => "load",
            Self::Late { .. } => "late",
        }
    }
}

impl Happening {
    /// Whether it is known without who brings the words, and when: what the ramps do, and what follows from them at once.
    pub fn is_of_the_ramps(&self) -> bool {
        matches!(self, Self::Stop { .. } | Self::Transfer { .. })
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
