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

/// The records of a demand, each once with its rank: the place of its first corner in the demand.
struct Wanted {
    /// Most urgent first.
    by_rank: Vec<(u32, u32)>,
    /// Ascending records.
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
            wanted.kept().iter().for_each(|&(record, rank)| self.buffer.put(record, wanted.need(rank)));
            self.loaded = true;
        }
    }

    /// Writes the list of requests anew and makes room for what it asks for.
    fn order(&mut self, wanted: &Wanted, start: u64, supply: &mut FrameSupply) {
        supply.cancelled = self.cancel(wanted);
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
    fn cancel(&mut self, wanted: &Wanted) -> u64 {
        let open = self.orders.len();
        self.orders.retain(|&record, _| wanted.keeps(record));
        self.drums.iter_mut().for_each(|drum| drum.clear(|record| wanted.keeps(record)));
        (open - self.orders.len()) as u64
    }

    /// Puts a record in the queue of its drum; an order of frames before keeps its tick.
    fn request(&mut self, record: u32, rank: u32, order: Order) {
        self.orders.entry(record).or_insert(order).need = order.need;
        let drum = record as usize % self.drums.len();
        self.drums[drum].enqueue(record, rank);
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
