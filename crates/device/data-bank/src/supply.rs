//! What a frame asks of a data bank, and what it gets.

use quantities::Tick;

/// What the sweeps of a frame, and of the frames soon after it, can meet.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Demand {
    /// Frame of the mission, from 0.
    pub frame: u64,
    /// When the demand is known and acted on.
    pub start: Tick,
    /// End of the frame: the start of the next demand.
    pub end: Tick,
    /// What each store is asked for, most urgent first. A piece may be named twice.
    pub wants: Vec<Vec<Piece>>,
}

/// A piece of data that is wanted whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Piece {
    /// Index of the corner into the words of its level, or number of the square of ground.
    pub item: u32,
    /// Records of its chain, at least 1; a corner has one.
    pub records: u32,
}

impl Piece {
    /// A piece that lies in one record.
    pub fn one(item: u32) -> Self {
        Self { item, records: 1 }
    }
}

/// A demanded piece that the storage buffer does not hold whole as the frame begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Missing {
    /// Index of the corner into the words of its level, or number of the square of ground.
    pub item: u32,
    /// Drum that has its first record.
    pub drum: u32,
    /// When its last words are in the buffer; `None` if not before the frame ends.
    pub arrival: Option<Tick>,
}

/// A spell of a drum at one record; what lies before or behind the frame is cut off (master ticks).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DrumSpell {
    /// Number of the drum among those of the bank.
    pub drum: u32,
    /// Number of the record in its store.
    pub record: u32,
    /// From when on it turned to the record.
    pub begun: u64,
    /// From when on it read the record over its channel; the end of the spell where it did not.
    pub under: u64,
    /// When it had read the record, or had to leave it.
    pub until: u64,
}

/// A spell of an I/O processor at one record; what lies before or behind the frame is cut off (master ticks).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EditSpell {
    /// Number of the record in its store.
    pub record: u32,
    /// From when on it edited the record.
    pub begun: u64,
    /// When it had edited the record.
    pub until: u64,
}

/// What a data bank did in one frame for one store. Counts are of records.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FrameSupply {
    /// Demanded pieces that are not there at the start, ascending.
    pub missing: Vec<Missing>,
    /// Pieces that the demand names, each once.
    pub pieces: u64,
    /// Records that the demand touches: those present, on order from frames before, requested now, without room.
    pub wanted: u64,
    /// Of these, held in the buffer at the start.
    pub present: u64,
    /// Of these, neither held nor ordered, because nearer ones fill the buffer.
    pub no_room: u64,
    /// Requests made in this frame.
    pub requests: u64,
    /// Requests fulfilled in this frame.
    pub delivered: u64,
    /// Requests of frames before that the frame no longer wants.
    pub cancelled: u64,
    /// Records dropped from the buffer to make room.
    pub evicted: u64,
    /// Requests that are still open as the frame ends.
    pub pending: u64,
    /// Master ticks of the frame that each drum spent turning to records of the store and reading them.
    pub busy: Vec<u64>,
    /// Master ticks of the frame in which each channel carried a record of the store.
    pub carried: Vec<u64>,
    /// Master ticks of the frame in which the I/O processor edited records.
    pub edited: u64,
    /// What the drums were at, drum by drum in order of time.
    pub spells: Vec<DrumSpell>,
    /// What the I/O processor was at, in order of time.
    pub edits: Vec<EditSpell>,
    /// Longest queue of a drum, with the record under its heads and those of other stores.
    pub longest_queue: u32,
    /// Longest time from request to arrival, of the records delivered (ticks).
    pub latency_max: u64,
    /// Sum of these times (ticks): their mean is this over `delivered`.
    pub latency_sum: u64,
    /// Words of the buffer that are filled or kept for records on order.
    pub words_held: u64,
}

impl FrameSupply {
    /// Notes what a drum on channel `channel` was at.
    pub(crate) fn note_spell(&mut self, channel: usize, spell: DrumSpell) {
        let DrumSpell { drum, begun, under, until, .. } = spell;
        self.busy[drum as usize] += until - begun;
        self.carried[channel] += until - under;
        if begun < until {
            self.spells.push(spell);
        }
    }

    /// Notes a record that was delivered `latency` ticks after its request.
    pub(crate) fn note_delivery(&mut self, latency: u64) {
        self.delivered += 1;
        self.latency_max = self.latency_max.max(latency);
        self.latency_sum = self.latency_sum.saturating_add(latency);
    }
}
