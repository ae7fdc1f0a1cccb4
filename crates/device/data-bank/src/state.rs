//! What a data bank remembers between two frames, for whoever writes it down.

/// A data bank between two frames. With the figures of its model it decides all frames that follow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BankState {
    /// The stores of its kinds of data, in their order.
    pub stores: Vec<StoreState>,
    /// The drums, by number.
    pub drums: Vec<DrumState>,
}

/// The store of one kind of data between two frames.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StoreState {
    /// Whether the buffer was filled for the first frame.
    pub loaded: bool,
    /// Records in the storage buffer, ascending.
    pub held: Vec<HeldRecord>,
    /// Records on order, ascending.
    pub orders: Vec<OrderedRecord>,
    /// Records that the I/O processor edits, each with the tick at which it is done.
    pub editing: Vec<(u32, u64)>,
}

/// A record in the storage buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HeldRecord {
    /// Number of the record in its store.
    pub record: u32,
    /// Frame that demanded it last.
    pub frame: u64,
    /// Its place in that demand, from 0 for the most urgent.
    pub rank: u32,
}

/// A record on order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OrderedRecord {
    /// Tick of the master clock at which it was ordered first.
    pub requested: u64,
    /// The record, with the demand that asked for it last.
    pub wanted: HeldRecord,
}

/// A drum between two frames.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DrumState {
    /// What its heads are at.
    pub heads: Heads,
    /// Records that wait for it, in the order of its queue: number of the store, number of the record.
    pub waiting: Vec<(u32, u32)>,
}

/// What the heads of a drum are at; times in ticks of the master clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heads {
    /// Nothing: the drum turns idle.
    Idle,
    /// The drum turns to a record.
    Turning {
        /// Number of the store that it is of.
        store: u32,
        /// Number of the record in its store.
        record: u32,
        /// When the drum began to turn to it.
        begun: u64,
        /// When the record comes under the heads.
        under: u64,
    },
    /// The drum reads a record, over its channel.
    Reading {
        /// Number of the store that it is of.
        store: u32,
        /// Number of the record in its store.
        record: u32,
        /// When the drum began to turn to it.
        begun: u64,
        /// When the record came under the heads.
        under: u64,
    },
}
