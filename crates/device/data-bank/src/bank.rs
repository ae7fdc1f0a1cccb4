//! The data bank of one level: from the demand of a frame to what it has to do without.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use hardware_model::{Channels, Drum};
use quantities::Tick;

use crate::buffer::{Need, StorageBuffer};
use crate::channel::{self, ChannelWork};
use crate::drum::{DrumAtWork, DrumUnit};
use crate::layout::Layout;
use crate::span::Span;
use crate::state::{BankState, OrderedRecord};
use crate::{Demand, FrameSupply, Missing};

/// Drums, queues and storage buffer of one level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataBank {
    layout: Layout,
    drums: Vec<DrumAtWork>,
    /// Channels that the drums share in turn; at most one each.
    channels: usize,
    buffer: StorageBuffer,
    orders: BTreeMap<u32, Order>,
    /// Whether the buffer was filled for the first frame.
    loaded: bool,
}

/// A record on order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Order {
    requested: u64,
    need: Need,
}

/// The records of a demand, each once with its rank: the place of its first corner in the demand.
struct Wanted {
    /// Records with their rank, the most urgent first.
    by_rank: Vec<(u32, u32)>,
    /// Records with their rank, in ascending order of records.
    by_record: Vec<(u32, u32)>,
    /// How many of the most urgent the buffer has room for.
    kept: usize,
    frame: u64,
}

impl Wanted {
    fn new(demand: &Demand, layout: &Layout, buffer: &StorageBuffer) -> Self {
        let records = demand.corners.iter().map(|&corner| layout.record_of(corner));
        let mut by_record: Vec<(u32, u32)> = records.zip(0..).collect();
        by_record.sort_unstable();
        by_record.dedup_by_key(|&mut (record, _)| record);
        let mut by_rank = by_record.clone();
        by_rank.sort_unstable_by_key(|&(_, rank)| rank);
        let kept = buffer.room_for(by_rank.len());
        Self { by_rank, by_record, kept, frame: demand.frame }
    }

    /// Records that the buffer has room for, each with its rank.
    fn kept(&self) -> &[(u32, u32)] {
        &self.by_rank[..self.kept]
    }

    fn keeps(&self, record: u32) -> bool {
        let first_without_room = self.by_rank.get(self.kept).map_or(u32::MAX, |&(_, rank)| rank);
        let found = self.by_record.binary_search_by_key(&record, |&(record, _)| record);
        found.is_ok_and(|at| self.by_record[at].1 < first_without_room)
    }

    fn need(&self, rank: u32) -> Need {
        Need { frame: self.frame, rank: Reverse(rank) }
    }
}

impl DataBank {
    /// Drums of the design `drum` on `channels` behind a buffer of `buffer_words` words (any number if `None`), for a level of
    /// `corners` (north, east). `seed` draws start angle and speed of each drum. A buffer smaller than one record
    /// holds none.
    pub fn new(
        drum: Drum,
        channels: Channels,
        buffer_words: Option<u32>,
        corners: [usize; 2],
        seed: u64,
    ) -> Self {
        let layout = Layout::new(&drum, corners);
        let count = drum.count.max(1);
        let drums = (0..count)
            .map(|unit| DrumUnit::drawn(&drum, &channels, layout.words, seed, unit))
            .map(|unit| DrumAtWork::new(unit, drum.queue, count));
        Self {
            layout,
            drums: drums.collect(),
            channels: channels.count.unwrap_or(count).clamp(1, count) as usize,
            buffer: StorageBuffer::new(buffer_words.map(|words| (words / layout.words) as usize)),
            orders: BTreeMap::new(),
            loaded: false,
        }
    }

    /// The drums as the seed drew them.
    pub fn drums(&self) -> impl ExactSizeIterator<Item = DrumUnit> {
        self.drums.iter().map(|drum| drum.unit)
    }

    /// What the bank remembers between the frames that it has followed and the next one.
    pub fn state(&self) -> BankState {
        let ordered = |(&record, order): (&u32, &Order)| OrderedRecord {
            requested: order.requested,
            wanted: order.need.of(record),
        };
        BankState {
            loaded: self.loaded,
            held: self.buffer.records().map(|(record, need)| need.of(record)).collect(),
            orders: self.orders.iter().map(ordered).collect(),
            drums: self.drums.iter().map(DrumAtWork::state).collect(),
        }
    }

    /// What it takes to fill the buffer with the first demand of a mission, which a bank that has not begun yet finds there
    /// as the mission begins. The drums turn as in its first frame.
    pub fn first_load(&self, demand: &Demand) -> FrameSupply {
        let mut empty = Self { loaded: true, ..self.clone() };
        empty.frame(&Demand { end: Tick(u64::MAX), ..demand.clone() })
    }

    /// Follows the data bank through one frame. The first call is the first frame of the mission.
    pub fn frame(&mut self, demand: &Demand) -> FrameSupply {
        let mut supply = FrameSupply::default();
        self.finish_before(demand.start.0, &mut supply);
        let wanted = Wanted::new(demand, &self.layout, &self.buffer);
        self.load_before_mission(&wanted);
        self.order(&wanted, demand.start.0, &mut supply);
        let mut missing = self.missing(demand);
        let arrivals = self.work(demand, &mut supply);
        for missing in &mut missing {
            let record = self.layout.record_of(missing.corner);
            missing.arrival = arrivals.get(&record).copied().map(Tick);
        }
        FrameSupply { missing, pending: self.orders.len() as u64, ..supply }
    }

    /// What arrives between two frames, in which no request is served.
    fn finish_before(&mut self, start: u64, supply: &mut FrameSupply) {
        for work in self.follow(Span { start, end: start }, false) {
            self.take_in(&work.arrived, supply);
        }
    }

    /// Fills the buffer for the first frame.
    fn load_before_mission(&mut self, wanted: &Wanted) {
        if !self.loaded {
            wanted.kept().iter().for_each(|&(record, rank)| self.buffer.put(record, wanted.need(rank)));
            self.loaded = true;
        }
    }

    /// Writes the list of requests anew and makes room for what it asks for.
    fn order(&mut self, wanted: &Wanted, start: u64, supply: &mut FrameSupply) {
        supply.cancelled = self.cancel(wanted, start);
        let kept_open = self.orders.len();
        for &(record, rank) in &wanted.by_rank {
            self.buffer.note_need(record, wanted.need(rank));
        }
        for &(record, rank) in wanted.kept() {
            if !self.buffer.holds(record) {
                self.request(record, rank, Order { requested: start, need: wanted.need(rank) });
            }
        }
        supply.evicted = self.buffer.make_room(self.orders.len()) as u64;
        supply.requests = (self.orders.len() - kept_open) as u64;
        self.count(wanted, supply);
    }

    /// Gives up what the frame has no use or no room for, and empties the queues; how many orders were given up.
    fn cancel(&mut self, wanted: &Wanted, start: u64) -> u64 {
        let open = self.orders.len();
        self.orders.retain(|&record, _| wanted.keeps(record));
        self.drums.iter_mut().for_each(|drum| drum.clear(start, |record| wanted.keeps(record)));
        (open - self.orders.len()) as u64
    }

    /// Puts a record in the queue of its drum; an order of frames before keeps its tick.
    fn request(&mut self, record: u32, rank: u32, order: Order) {
        self.orders.entry(record).or_insert(order).need = order.need;
        let drum = self.drum_of(record);
        self.drums[drum].enqueue(record, rank);
    }

    fn drum_of(&self, record: u32) -> usize {
        record as usize % self.drums.len()
    }

    /// The figures of the frame's start.
    fn count(&self, wanted: &Wanted, supply: &mut FrameSupply) {
        let present = wanted.by_rank.iter().filter(|&&(record, _)| self.buffer.holds(record)).count();
        let queues = self.drums.iter().map(DrumAtWork::open);
        supply.wanted = wanted.by_rank.len() as u64;
        supply.present = present as u64;
        supply.no_room = (wanted.by_rank.len() - present - self.orders.len()) as u64;
        supply.longest_queue = queues.max().unwrap_or(0) as u32;
        supply.words_held = (self.buffer.len() + self.orders.len()) as u64 * u64::from(self.layout.words);
    }

    /// Demanded corners that the buffer does not hold now.
    fn missing(&self, demand: &Demand) -> Vec<Missing> {
        let absent = |corner: &u32| !self.buffer.holds(self.layout.record_of(*corner));
        let mut corners: Vec<u32> = demand.corners.iter().copied().filter(absent).collect();
        corners.sort_unstable();
        corners.dedup();
        let drum = |corner| self.drum_of(self.layout.record_of(corner)) as u32;
        corners.into_iter().map(|corner| Missing { corner, drum: drum(corner), arrival: None }).collect()
    }

    /// Lets the drums work through the frame; the arrival of each record that came.
    fn work(&mut self, demand: &Demand, supply: &mut FrameSupply) -> BTreeMap<u32, u64> {
        let mut arrivals = BTreeMap::new();
        supply.busy = vec![0; self.drums.len()];
        let span = Span { start: demand.start.0, end: demand.end.0 };
        for (channel, work) in self.follow(span, true).into_iter().enumerate() {
            supply.carried.push(work.carried);
            let drums = supply.busy.iter_mut().skip(channel).step_by(self.channels);
            drums.zip(&work.busy).for_each(|(busy, &found)| *busy = found);
            self.take_in(&work.arrived, supply);
            arrivals.extend(work.arrived);
        }
        arrivals
    }

    /// Follows every channel through `span`.
    fn follow(&mut self, span: Span, serves: bool) -> Vec<ChannelWork> {
        let of_channel = |channel| {
            let drums = self.drums.iter_mut().skip(channel).step_by(self.channels);
            channel::work(&mut drums.collect::<Vec<_>>(), span, serves)
        };
        (0..self.channels).map(of_channel).collect()
    }

    /// Takes delivered records into the buffer.
    fn take_in(&mut self, arrived: &[(u32, u64)], supply: &mut FrameSupply) {
        for &(record, arrival) in arrived {
            if let Some(order) = self.orders.remove(&record) {
                self.buffer.put(record, order.need);
                supply.note_delivery(arrival.saturating_sub(order.requested));
            }
        }
    }
}
