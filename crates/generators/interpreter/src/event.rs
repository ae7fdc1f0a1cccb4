//! Events of the digital side.

/// A register of a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// Feeds the multiplying D/As.
    Hold,
    /// Waits for a stop of X.
    XFirst,
    /// Waits for a stop of Y.
    YFirst,
    /// Waits for a stop of X and a stop of Y.
    Diagonal,
}

/// A set of nine words that a stop has asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AskedFor {
    /// Yellow, green, black, red.
    pub colour: usize,
    /// Register for which the set is meant.
    pub register: Register,
    /// The stop, counted from 0 in the sweep.
    pub crossing: u32,
}

/// Kind of an event, with all that belongs to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Happening {
    /// A register is full as the sweep begins.
    Home {
        /// Yellow, green, black, red.
        colour: usize,
        /// Register of that colour that is full.
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
        /// Corner of its first word; none for words of 0.
        corner: Option<[i64; 2]>,
    },
    /// A full set is overwritten unused.
    Wasted {
        /// Yellow, green, black, red.
        colour: usize,
        /// Register in which the set was.
        register: Register,
        /// Corner of its first word; none for words of 0.
        corner: Option<[i64; 2]>,
    },
    /// A set is asked for.
    Wanted(AskedFor),
    /// A set is dropped before anyone fetches it.
    Cancelled(AskedFor),
    /// The corner beyond both stops is at hand and moves over to a preload register.
    Diagonal {
        /// Whose, where to, at which stop.
        set: AskedFor,
        /// Corner of the words: north, east.
        corner: [i64; 2],
    },
    /// The first access of a set begins.
    Access {
        /// Whose, where to, asked at which stop.
        set: AskedFor,
        /// Corner of the words: north, east.
        corner: [i64; 2],
    },
    /// The storage buffer has not the corner: its words are 0.
    Absent {
        /// Yellow, green, black, red.
        colour: usize,
        /// Register to which the words go.
        register: Register,
        /// The stop that asked; none as the sweep begins.
        crossing: Option<u32>,
        /// Corner that is absent: north, east.
        corner: [i64; 2],
    },
    /// Words arrive at a register.
    Load {
        /// Yellow, green, black, red.
        colour: usize,
        /// Register to which the words go.
        register: Register,
        /// Corner that they belong to: north, east; none for words of 0.
        corner: Option<[i64; 2]>,
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
    /// Words of a crater or of a shadow boundary come to the part that waits for them, or do not.
    Words {
        /// Part that waits for the words.
        part: Part,
        /// Whether they come in time.
        outcome: Outcome,
        /// Ticks that are left, below 0 late; none where loads take no time, and of words that never come.
        slack: Option<i64>,
    },
    /// The processor begins with the program of a sweep.
    SetUpBegins {
        /// Sweep whose program the processor begins with.
        sweep: u32,
    },
    /// The program of a sweep is ready.
    SetUp {
        /// Sweep whose program is ready.
        sweep: u32,
        /// Ticks until it begins; below 0 it has begun.
        slack: i64,
    },
    /// A sweep begins with the program of another.
    OldSetUp {
        /// Sweep that begins, counted from 0 in the frame.
        sweep: u32,
        /// Sweep whose program is used.
        drawn: u32,
    },
    /// Tables and polyhedra of the next frame are ready, or the frame ends before they are.
    Tables {
        /// Ticks until the frame ends; below 0, so much work is left.
        slack: i64,
    },
    /// A record of terrain arrives from a drum.
    Record(FromDrum),
    /// A square of another kind of data is whole in the storage buffer.
    Square {
        /// 2 features, 3 boundaries of shadow, 4 polyhedra.
        kind: usize,
        /// Drum of its first record, and its south-west region.
        record: FromDrum,
    },
}

/// A record that brings corners which a frame asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FromDrum {
    /// Number of the drum in its bank.
    pub drum: u32,
    /// The first of the corners, or the south-west region of a square.
    pub corner: [i64; 2],
    /// How many words of it the frame asks for.
    pub words: u32,
}

/// A part of a block that waits for words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// A sub-generator of the type of a crater.
    Crater {
        /// Number of the crater in the list.
        crater: u32,
        /// Number of the sub-generator; none if all were taken.
        sub_generator: Option<u32>,
    },
    /// A line generator of the shadow controller.
    Segment {
        /// Its number; none if all were taken, and where loads take no time.
        line_generator: Option<u32>,
    },
}

/// What becomes of words that a part waits for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Outcome {
    /// They are there when they are wanted.
    InTime,
    /// They come after they are wanted.
    Late,
    /// No part is free for them, or they could not set out in time.
    Dropped,
}

impl Happening {
    /// Returns the word for the kind in tables.
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
            Self::Absent { .. } => "absent",
            Self::Load { .. } => "load",
            Self::Late { .. } => "late",
            Self::Words { part, outcome, .. } => outcome.name(part),
            Self::SetUpBegins { .. } => "set-up-begins",
            Self::SetUp { slack: 0.., .. } => "set-up",
            Self::SetUp { .. } => "set-up-late",
            Self::OldSetUp { .. } => "old-set-up",
            Self::Tables { slack: 0.. } => "tables",
            Self::Tables { .. } => "tables-late",
            Self::Record(_) => "record",
            Self::Square { kind: 2, .. } => "feature-record",
            Self::Square { kind: 3, .. } => "shadow-record",
            Self::Square { .. } => "body-record",
        }
    }
}

impl Outcome {
    fn name(self, part: &Part) -> &'static str {
        match (part, self) {
            (Part::Crater { .. }, Self::InTime) => "crater-load",
            (Part::Crater { .. }, Self::Late) => "crater-late",
            (Part::Crater { .. }, Self::Dropped) => "crater-dropped",
            (Part::Segment { .. }, Self::InTime) => "segment-load",
            (Part::Segment { .. }, Self::Late) => "segment-late",
            (Part::Segment { .. }, Self::Dropped) => "segment-dropped",
        }
    }
}

/// One event of the digital side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Event {
    /// Master tick since the start of the mission.
    pub tick: i64,
    /// Level of terrain: 0 fine, 1 coarse; none for what belongs to neither.
    pub level: Option<usize>,
    /// Kind of the event, with all that belongs to it.
    pub what: Happening,
}
