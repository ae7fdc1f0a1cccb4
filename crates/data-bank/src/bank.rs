//! The data bank of one level: from the demand of a frame to what it has to do without.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use hardware_model::Drum;
use quantities::Tick;

use crate::buffer::{Need, StorageBuffer};
use crate::drum::{DrumAtWork, DrumUnit};
use crate::layout::Layout;
use crate::{Demand, FrameSupply, Missing};

/// Drums, queues and storage buffer of one level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataBank {
    layout: Layout,
    drums: Vec<DrumAtWork>,
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

/// The records of a demand.
struct Wanted {
    /// Each once, most urgent first.
    records: Vec<u32>,
    /// Place of each in `records`.
    ranks: BTreeMap<u32, u32>,
    /// How many of them the buffer has room for.
    kept: usize,
    frame: u64,
}

impl Wanted {
    fn new(demand: &Demand, layout: &Layout, buffer: &StorageBuffer) -> Self {
        let (mut records, mut ranks) = (Vec::new(), BTreeMap::new());
        let mut last = None;
        for &corner in &demand.corners {
            let record = layout.record_of(corner);
            // Neighbours in the demand often share a record.
            if last.replace(record) != Some(record) && !ranks.contains_key(&record) {
                ranks.insert(record, records.len() as u32);
                records.push(record);
            }
        }
        let kept = buffer.room_for(records.len());
        Self { records, ranks, kept, frame: demand.frame }
    }

    /// Records that the buffer has room for, each with its rank.
    fn kept(&self) -> impl Iterator<Item = (u32, u32)> {
        self.records[..self.kept].iter().copied().zip(0..)
    }

    fn keeps(&self, record: u32) -> bool {
        self.ranks.get(&record).is_some_and(|&rank| (rank as usize) < self.kept)
    }

    fn need(&self, rank: u32) -> Need {
        Need { frame: self.frame, rank: Reverse(rank) }
    }
}

impl DataBank {
    /// Drums of the design `drum` behind a buffer of `buffer_words` words (any number if `None`), for a level of
    /// `corners` (north, east). `seed` draws start angle and speed of each drum. A buffer smaller than one record
    /// holds none.
    pub fn new(drum: Drum, buffer_words: Option<u32>, corners: [usize; 2], seed: u64) -> Self {
        let layout = Layout::new(&drum, corners);
        let count = drum.count.max(1);
        let drums = (0..count)
            .map(|unit| DrumUnit::drawn(&drum, layout.words, seed, unit))
            .map(|unit| DrumAtWork::new(unit, drum.queue, count));
        Self {
            layout,
            drums: drums.collect(),
            buffer: StorageBuffer::new(buffer_words.map(|words| (words / layout.words) as usize)),
            orders: BTreeMap::new(),
            loaded: false,
        }
    }

    /// The drums as the seed drew them.
    pub fn drums(&self) -> impl ExactSizeIterator<Item = DrumUnit> {
        self.drums.iter().map(|drum| drum.unit)
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

    /// Lets records arrive that were under the heads while no frame ran.
    fn finish_before(&mut self, start: u64, supply: &mut FrameSupply) {
        let arrived: Vec<_> = self.drums.iter_mut().filter_map(|drum| drum.arrived_by(start)).collect();
        self.take_in(&arrived, supply);
    }

    /// Fills the buffer for the first frame.
    fn load_before_mission(&mut self, wanted: &Wanted) {
        if !self.loaded {
            wanted.kept().for_each(|(record, rank)| self.buffer.put(record, wanted.need(rank)));
            self.loaded = true;
        }
    }

    /// Writes the list of requests anew and makes room for what it asks for.
    fn order(&mut self, wanted: &Wanted, start: u64, supply: &mut FrameSupply) {
        let open = self.orders.len();
        self.orders.retain(|&record, _| wanted.keeps(record));
        self.drums.iter_mut().for_each(|drum| drum.clear(|record| wanted.keeps(record)));
        let kept_open = self.orders.len();
        for (&record, rank) in wanted.records.iter().zip(0..) {
            self.buffer.note_need(record, wanted.need(rank));
        }
        for (record, rank) in wanted.kept().filter(|&(record, _)| !self.buffer.holds(record)) {
            let need = wanted.need(rank);
            self.orders.entry(record).or_insert(Order { requested: start, need }).need = need;
            let drum = record as usize % self.drums.len();
            self.drums[drum].enqueue(record, rank);
        }
        supply.evicted = self.buffer.make_room(self.orders.len()) as u64;
        supply.cancelled = (open - kept_open) as u64;
        supply.requests = (self.orders.len() - kept_open) as u64;
        self.count(wanted, supply);
    }

    /// The figures of the frame's start.
    fn count(&self, wanted: &Wanted, supply: &mut FrameSupply) {
        let present = wanted.records.iter().filter(|&&record| self.buffer.holds(record)).count();
        let queues = self.drums.iter().map(DrumAtWork::open);
        supply.wanted = wanted.records.len() as u64;
        supply.present = present as u64;
        supply.no_room = (wanted.records.len() - present - self.orders.len()) as u64;
        supply.longest_queue = queues.max().unwrap_or(0) as u32;
        supply.words_held = (self.buffer.len() + self.orders.len()) as u64 * u64::from(self.layout.words);
    }

    /// Demanded corners that the buffer does not hold now.
    fn missing(&self, demand: &Demand) -> Vec<Missing> {
        let absent = |corner: &u32| !self.buffer.holds(self.layout.record_of(*corner));
        let mut corners: Vec<u32> = demand.corners.iter().copied().filter(absent).collect();
        corners.sort_unstable();
        corners.dedup();
        corners.into_iter().map(|corner| Missing { corner, arrival: None }).collect()
    }

    /// Lets the drums work through the frame; the arrival of each record that came.
    fn work(&mut self, demand: &Demand, supply: &mut FrameSupply) -> BTreeMap<u32, u64> {
        let mut arrived = Vec::new();
        for drum in &mut self.drums {
            supply.busy.push(drum.work(demand.start.0, demand.end.0, &mut arrived));
        }
        self.take_in(&arrived, supply);
        arrived.into_iter().collect()
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
