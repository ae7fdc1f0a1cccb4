//! One event of the digital side.

use std::fmt;

use dpu::Register;
use quantities::{SweepTime, Tick};
use sweep_program::{Colour, Fold, MissCause, WordMask};

use crate::data_kind::DataKind;

/// Unit of the digital side that an event belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DigitalUnit {
    /// The unit that sees the stops and moves the pointers.
    Dpu,
    /// The bank of a colour.
    Loader(Colour),
    /// One processor for all crossings.
    IoProcessor,
    /// The central processor of the digital side.
    Cpu,
    /// A drum: the kind of data after which its bank is called, and its number there.
    Drum(DataKind, u32),
    /// The registers of the terrain generator.
    Registers,
    /// The line over which craters come.
    FeatureGenerator,
    /// The line over which shadow boundaries come.
    ShadowController,
}

/// A part that words are loaded into.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadedPart {
    /// Type of crater, 1 to 3, and number of the sub-generator.
    SubGenerator(u32, u32),
    /// Number of the line generator.
    LineGenerator(u32),
}

impl fmt::Display for LoadedPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SubGenerator(kind, number) => write!(f, "sub-generator.{kind}.{number}"),
            Self::LineGenerator(number) => write!(f, "line-generator.{number}"),
        }
    }
}

impl fmt::Display for DigitalUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dpu => f.write_str("dpu"),
            Self::Loader(colour) => write!(f, "loader.{}", colour.name()),
            Self::IoProcessor => f.write_str("io-processor"),
            Self::Cpu => f.write_str("cpu"),
            Self::Drum(kind, number) => write!(f, "drum.{}.{number}", kind.name()),
            Self::Registers => f.write_str("registers"),
            Self::FeatureGenerator => f.write_str("feature-generator.load"),
            Self::ShadowController => f.write_str("shadow-controller.load"),
        }
    }
}

macro_rules! words {
    ($($(#[$doc:meta])* $variant:ident = $word:literal,)*) => {
        /// Kind of an event on the digital side.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum EventWord {
            $($(#[$doc])* $variant,)*
        }

        impl EventWord {
            /// All, in the order of the guide.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Returns the word for the kind in listings.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $word),* }
            }
        }
    };
}

words! {
    /// A register is full when the sweep begins.
    Home = "home",
    /// A ramp meets its stop.
    Stop = "stop",
    /// A hold register takes its preload register.
    Transfer = "transfer",
    /// Words miss the stop that they are meant for.
    Late = "late",
    /// A full set is overwritten unused.
    Wasted = "wasted",
    /// A set is no longer wanted before anyone fetches it.
    Cancelled = "cancelled",
    /// A set is asked for.
    Wanted = "wanted",
    /// The corner beyond both stops is at hand and moves over.
    Diagonal = "diagonal",
    /// The storage buffer is read: the first access of a set begins.
    Access = "access",
    /// The storage buffer has not the corner: its words are 0.
    Absent = "absent",
    /// Words arrive at a register.
    Load = "load",
    /// A sub-generator has the words of a crater.
    CraterLoad = "crater-load",
    /// It has them when the sweep has met the crater.
    CraterLate = "crater-late",
    /// A crater finds no sub-generator, or its words never come.
    CraterDropped = "crater-dropped",
    /// A line generator has the words of a shadow boundary.
    SegmentLoad = "segment-load",
    /// It has them when the sweep has crossed the boundary.
    SegmentLate = "segment-late",
    /// A shadow boundary finds no line generator, or its words never come.
    SegmentDropped = "segment-dropped",
    /// The processor begins with the program of a sweep.
    SetUpBegins = "set-up-begins",
    /// The program of a sweep is ready in time.
    SetUp = "set-up",
    /// The program of a sweep is ready when the sweep has begun.
    SetUpLate = "set-up-late",
    /// A sweep begins with the program of another.
    OldSetUp = "old-set-up",
    /// Tables and polyhedra of the next frame are ready.
    Tables = "tables",
    /// The frame ends before they are.
    TablesLate = "tables-late",
    /// A record of terrain arrives from a drum.
    Record = "record",
    /// The last record of a square of craters is in the storage buffer.
    FeatureRecord = "feature-record",
    /// The same of the boundaries of shadow in a square.
    ShadowRecord = "shadow-record",
    /// The same of the bodies in a square.
    BodyRecord = "body-record",
}

impl EventWord {
    /// Whether the place of the event is a square of regions, named by its south-west one, and no corner.
    pub fn is_of_square(self) -> bool {
        matches!(self, Self::FeatureRecord | Self::ShadowRecord | Self::BodyRecord)
    }
}

/// One event. What does not belong to it is `None`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DigitalEvent {
    /// Tick of the master clock at which it happens.
    pub tick: Tick,
    /// Kind of the event, as a word.
    pub event: EventWord,
    /// Unit to which the event belongs.
    pub unit: DigitalUnit,
    /// Sweep that it is done for.
    pub sweep: Option<u32>,
    /// Level of terrain: 0 fine, 1 coarse.
    pub level: Option<usize>,
    /// Fold of the sweep, from 0: the stop itself, or the one that asked.
    pub crossing: Option<u32>,
    /// Fold that the event is about: its ramp and its stop.
    pub fold: Option<Fold>,
    /// Colour whose registers take part.
    pub colour: Option<Colour>,
    /// Register of that colour that takes part.
    pub register: Option<Register>,
    /// North and east index of the corner, or of the south-west region of a square.
    pub corner: Option<[i64; 2]>,
    /// Which words of the set, bit 3p + q.
    pub mask: WordMask,
    /// Number of words that take part.
    pub words: u32,
    /// Ticks that were left; below 0 it is late.
    pub slack: Option<i64>,
    /// Why it is late.
    pub cause: Option<MissCause>,
    /// When what is late comes (samples of the sweep); none if never.
    pub comes: Option<SweepTime>,
    /// The sweep whose set-up is used.
    pub other: Option<u32>,
    /// Part that words are loaded into.
    pub part: Option<LoadedPart>,
    /// Crater, by its number in the list of features.
    pub crater: Option<u32>,
    /// Ground range at which the words are wanted (m).
    pub range: Option<f64>,
}

impl DigitalEvent {
    /// An event of which no more is known.
    pub fn new(tick: Tick, event: EventWord, unit: DigitalUnit) -> Self {
        Self {
            tick,
            event,
            unit,
            sweep: None,
            level: None,
            crossing: None,
            fold: None,
            colour: None,
            register: None,
            corner: None,
            mask: WordMask(0),
            words: 0,
            slack: None,
            cause: None,
            comes: None,
            other: None,
            part: None,
            crater: None,
            range: None,
        }
    }
}
