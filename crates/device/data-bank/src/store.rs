//! The store of one kind of data: its records on the drums, its storage buffer, its I/O processor.

use std::collections::BTreeMap;

use quantities::Tick;

use crate::buffer::{Need, StorageBuffer};
use crate::editor::Editor;
use crate::layout::{Contents, Layout};
use crate::span::Span;
use crate::state::{OrderedRecord, StoreState};
use crate::supply::Piece;
use crate::wanted::Wanted;
use crate::{FrameSupply, Missing};

/// What is kept of one kind of data, and behind which buffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StoreDesign {
    /// What the records hold.
    pub contents: Contents,
    /// Words of a record, on the drum and in the buffer; at least those of one corner.
    pub record_words: u32,
    /// Words of the storage buffer; any number if `None`. A buffer smaller than one record holds none.
    pub buffer_words: Option<u32>,
    /// Master ticks that the I/O processor takes to edit one word.
    pub edit: f64,
}

/// Records of one kind: which are held, which are on order, which are edited.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Store {
    layout: Layout,
    pub(crate) words: u32,
    buffer: StorageBuffer,
    orders: BTreeMap<u32, Order>,
    editor: Editor,
    /// Whether the buffer was filled for the first frame.
    pub(crate) loaded: bool,
}

/// A record on order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Order {
    requested: u64,
    need: Need,
}

impl Store {
    /// An empty store of the design `design`.
    pub(crate) fn new(design: &StoreDesign) -> Self {
        let words = design.record_words.max(landscape::WORDS as u32);
        let edit = (f64::from(words) * design.edit).ceil() as u64;
        Self {
            layout: Layout::new(design.contents, words),
            words,
            buffer: StorageBuffer::new(design.buffer_words.map(|held| (held / words) as usize)),
            orders: BTreeMap::new(),
            editor: Editor::new(edit),
            loaded: false,
        }
    }

    /// The records that a demand touches.
    pub(crate) fn wanted(&self, frame: u64, pieces: &[Piece]) -> Wanted {
        Wanted::new(frame, pieces, &self.layout, &self.buffer)
    }

    /// Fills the buffer for the first frame.
    pub(crate) fn load_before_mission(&mut self, wanted: &Wanted) {
        if !self.loaded {
            wanted.kept().iter().for_each(|&(record, rank)| self.buffer.put(record, wanted.need(rank)));
            self.loaded = true;
        }
    }

    /// Gives up what a demand has no use or no room for; how many orders were given up.
    pub(crate) fn cancel(&mut self, wanted: &Wanted) -> u64 {
        let open = self.orders.len();
        self.orders.retain(|&record, _| wanted.keeps(record));
        (open - self.orders.len()) as u64
    }

    /// Orders at tick `start` what is wanted and not held, and makes room for it. The records that the drums have to bring,
    /// each with its turn among those that the buffer has room for.
    pub(crate) fn order(&mut self, wanted: &Wanted, start: u64, supply: &mut FrameSupply) -> Vec<(u32, u32)> {
        let kept_open = self.orders.len();
        for &(record, rank) in &wanted.by_rank {
            self.buffer.note_need(record, wanted.need(rank));
        }
        let mut asked = Vec::new();
        for (&(record, rank), turn) in wanted.kept().iter().zip(0..) {
            if !self.buffer.holds(record) {
                // An order of frames before keeps its tick.
                let order = Order { requested: start, need: wanted.need(rank) };
                self.orders.entry(record).or_insert(order).need = order.need;
                asked.push((record, turn));
            }
        }
        supply.evicted = self.buffer.make_room(self.orders.len()) as u64;
        supply.requests = (self.orders.len() - kept_open) as u64;
        asked.retain(|&(record, _)| !self.editor.has(record));
        asked
    }

    /// Writes the figures of the frame's start.
    pub(crate) fn count(&self, wanted: &Wanted, supply: &mut FrameSupply) {
        let present = wanted.by_rank.iter().filter(|&&(record, _)| self.buffer.holds(record)).count();
        supply.wanted = wanted.by_rank.len() as u64;
        supply.present = present as u64;
        supply.no_room = (wanted.by_rank.len() - present - self.orders.len()) as u64;
        supply.words_held = (self.buffer.len() + self.orders.len()) as u64 * u64::from(self.words);
    }

    /// Demanded pieces that the buffer does not hold whole, ascending, each with its records. Counts all in `supply`.
    pub(crate) fn absent(&self, pieces: &[Piece], supply: &mut FrameSupply) -> Vec<(Piece, Vec<u32>)> {
        let mut pieces = pieces.to_vec();
        pieces.sort_unstable_by_key(|piece| piece.item);
        pieces.dedup_by_key(|piece| piece.item);
        supply.pieces = pieces.len() as u64;
        let lacks = |records: &Vec<u32>| records.iter().any(|&record| !self.buffer.holds(record));
        pieces
            .into_iter()
            .map(|piece| (piece, self.layout.records_of(piece).collect::<Vec<u32>>()))
            .filter(|(_, records)| lacks(records))
            .collect()
    }

    /// When an item is whole, given what came in the frame; none if it is not by then.
    pub(crate) fn missing(
        &self,
        piece: Piece,
        records: &[u32],
        drum: u32,
        arrivals: &BTreeMap<u32, u64>,
    ) -> Missing {
        let came = |&record: &u32| match arrivals.get(&record) {
            Some(&tick) => Some(tick),
            None => self.buffer.holds(record).then_some(0),
        };
        let all: Option<Vec<u64>> = records.iter().map(came).collect();
        let arrival = all.and_then(|ticks| ticks.into_iter().max()).map(Tick);
        Missing { item: piece.item, drum, arrival }
    }

    /// Hands what channels brought, ascending, to the I/O processor, and takes what it has done by the end of `span` into the
    /// buffer: each such record with its tick.
    pub(crate) fn take_in(
        &mut self,
        arrived: &[(u32, u64)],
        span: Span,
        supply: &mut FrameSupply,
    ) -> BTreeMap<u32, u64> {
        self.editor.take(arrived);
        let edits = self.editor.spells(span);
        supply.edited += edits.iter().map(|spell| spell.until - spell.begun).sum::<u64>();
        supply.edits.extend(edits);
        let mut taken = BTreeMap::new();
        for (record, arrival) in self.editor.done_by(span.end) {
            if let Some(order) = self.orders.remove(&record) {
                self.buffer.put(record, order.need);
                supply.note_delivery(arrival.saturating_sub(order.requested));
                taken.insert(record, arrival);
            }
        }
        taken
    }

    /// Requests that are open.
    pub(crate) fn open(&self) -> u64 {
        self.orders.len() as u64
    }

    /// What the store remembers between two frames.
    pub(crate) fn state(&self) -> StoreState {
        let ordered = |(&record, order): (&u32, &Order)| OrderedRecord {
            requested: order.requested,
            wanted: order.need.of(record),
        };
        StoreState {
            loaded: self.loaded,
            held: self.buffer.records().map(|(record, need)| need.of(record)).collect(),
            orders: self.orders.iter().map(ordered).collect(),
            editing: self.editor.work().collect(),
        }
    }
}
