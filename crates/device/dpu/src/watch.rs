//! What the service of the crossings tells: typed events, each with its tick.

use quantities::{SweepTime, Tick};
use sweep_program::{Colour, Fold, Load, Miss, PreloadRegister};

/// Use of one line of the loader in one sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LineUse {
    /// Time of service (master ticks).
    pub busy: u64,
    /// Of these, interrupts: recognition, save, restore, pointers.
    pub interrupts: u64,
    /// Most sets that waited at once.
    pub longest_queue: u32,
}

/// A register of a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// Feeds the multiplying D/As.
    Hold,
    /// Waits for a stop.
    Preload(PreloadRegister),
    /// Waits for a stop of X and a stop of Y.
    Diagonal,
}

impl Register {
    /// Word in listings and records.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hold => "hold",
            Self::Preload(PreloadRegister::XFirst) => "x-first",
            Self::Preload(PreloadRegister::YFirst) => "y-first",
            Self::Diagonal => "diagonal",
        }
    }
}

/// A set of nine words that a fold has asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AskedSet {
    /// The fold, counted from 0 in the sweep.
    pub crossing: u32,
    /// Colour whose words were asked for.
    pub colour: Colour,
    /// Register to which the words go.
    pub register: Register,
}

/// A corner that is looked up in the storage buffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskedCorner {
    /// Tick at which the corner is looked up.
    pub tick: Tick,
    /// The same on the clock of the sweep (samples).
    pub at: SweepTime,
    /// The fold that asked, counted from 0 in the sweep; `None` for home registers.
    pub crossing: Option<u32>,
    /// Colour whose words were asked for.
    pub colour: Colour,
    /// Register to which the words go.
    pub register: Register,
    /// Index in the level.
    pub corner: u32,
    /// When it is in the storage buffer.
    pub arrival: CornerArrival,
}

impl AskedCorner {
    /// Whether the storage buffer has it by then.
    pub fn is_there(&self) -> bool {
        match self.arrival {
            CornerArrival::BeforeFrame => true,
            CornerArrival::At(arrival) => arrival <= self.tick,
            CornerArrival::NotInFrame => false,
        }
    }
}

/// When the data bank has delivered a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CornerArrival {
    /// Before the frame began.
    BeforeFrame,
    /// At this tick within the frame.
    At(Tick),
    /// Not in this frame.
    NotInFrame,
}

/// An event in the service of the crossings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ServiceEvent {
    /// A register is full when the sweep begins.
    Home(AskedCorner),
    /// A ramp meets its stop: fold number `crossing` of the sweep.
    Stop {
        /// Counted from 0 in the sweep.
        crossing: u32,
        /// Ramp and stop of the fold.
        fold: Fold,
    },
    /// Hold of a colour takes a preload register.
    Transfer {
        /// The fold, counted from 0 in the sweep.
        crossing: u32,
        /// Colour that takes the register.
        colour: Colour,
        /// Which one it takes.
        register: PreloadRegister,
        /// Corner of its first word, as index; [`sweep_program::NO_CORNER`] for words of 0.
        corner: u32,
        /// Ticks that the set was there before the fold; below 0 single words come after it. `None` if the set has not
        /// been fetched, or is the one that the sweep begins with.
        slack: Option<i64>,
    },
    /// A full set is overwritten unused.
    Wasted {
        /// Colour whose set is overwritten.
        colour: Colour,
        /// Preload register in which the set was.
        register: PreloadRegister,
        /// Corner of its first word, as for a transfer.
        corner: u32,
    },
    /// A set is asked for.
    Wanted(AskedSet),
    /// A set is dropped before anyone fetches it: its colour has moved on.
    Cancelled(AskedSet),
    /// The corner beyond both stops is at hand and moves over.
    Diagonal(AskedCorner),
    /// The first access of a set begins.
    Access(AskedCorner),
    /// The storage buffer has not the corner: its words are 0. The event before tells who asked.
    Absent(AskedCorner),
    /// Words arrive at a register.
    Load(Load),
    /// A set comes whose fold has passed: ticks that were left, below 0.
    LateSet {
        /// Time that was left (ticks); below 0.
        slack: i64,
    },
    /// Words missed the fold that they were meant for. Told when the sweep is over: only then is known when they came.
    Late {
        /// Words that missed their fold.
        miss: Miss,
        /// Ground range of the sweep at that fold (m).
        range: f64,
    },
}

/// Hears what the service does. Events of one line, and of one tick, come in their order; what waits on other lines is told
/// when it is served, so who needs one order of ticks sorts by them and keeps the order of what falls together.
///
/// Nobody, `()`, is not there once it is compiled.
pub trait Watch {
    /// Whether anyone hears it.
    const LISTENS: bool = true;

    /// Something happens at `tick`.
    fn tell(&mut self, tick: Tick, event: ServiceEvent);

    /// The sweep is over: what each line did.
    fn end(&mut self, _lines: &[LineUse; 4]) {}
}

impl Watch for () {
    const LISTENS: bool = false;

    #[inline(always)]
    fn tell(&mut self, _tick: Tick, _event: ServiceEvent) {}
}
