//! Drums, their queues and the storage buffer of one level, from the first frame on (section 17; sheet of the data bank).

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use hardware_model::{Drum, DrumQueue};

use crate::clock::starts;
use crate::demand::demand;
use crate::event::FromDrum;
use crate::scene::SceneData;

/// Words of a corner.
const WORDS: u32 = 9;

/// A drum as the seed drew it (master ticks).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DrumFigures {
    /// Time of one revolution (ticks).
    pub rotation: u64,
    /// Reading one record over its channel.
    pub transfer: u64,
    /// Angle at tick 0.
    pub start_angle: u64,
}

/// When each corner comes that the storage buffer has not as a frame begins; none if not in this frame.
pub type Arrivals = BTreeMap<[i64; 2], Option<i64>>;

/// How much a record is needed: the last frame that asked for it, and how early in its list.
type Need = (u64, Reverse<usize>);

/// A drum at work.
#[derive(Debug, Clone)]
struct Turning {
    figures: DrumFigures,
    /// Record that it turns to or reads.
    record: Option<u32>,
    /// When that has been read; none while it turns.
    until: Option<u64>,
    /// Records that wait, with their place in the list.
    waiting: Vec<(usize, u32)>,
}

/// Everything between the drums and the loader of a level.
#[derive(Debug, Clone)]
pub struct Bank {
    number: usize,
    /// Corners to the east.
    columns: u32,
    /// Corners along a side of the square that a record holds.
    side: u32,
    /// Records that the buffer has room for.
    room: usize,
    queue: DrumQueue,
    channels: usize,
    drums: Vec<Turning>,
    held: BTreeMap<u32, Need>,
    has_begun: bool,
}

impl Bank {
    /// Idle drums; the first frame finds what it asks for.
    pub fn before_mission(scene: &SceneData<'_>, number: usize, drums: &[DrumFigures]) -> Self {
        let banks = &scene.settings.data_banks;
        let Drum { record_words, queue, .. } = banks.drum.expect("drums have a design");
        let words = record_words.max(WORDS);
        let idle = |&figures| Turning { figures, record: None, until: None, waiting: Vec::new() };
        Self {
            number,
            columns: scene.landscape.bank().levels()[number].corners()[1] as u32,
            side: (words / WORDS).isqrt(),
            room: banks.buffer_words.map_or(usize::MAX, |held| (held / words) as usize),
            queue,
            channels: banks
                .channels
                .count
                .map_or(drums.len(), |count| (count as usize).clamp(1, drums.len())),
            drums: drums.iter().map(idle).collect(),
            held: BTreeMap::new(),
            has_begun: false,
        }
    }

    /// One frame: what it asks for and the buffer has not when it begins, with the tick at which it comes.
    pub fn frame(&mut self, scene: &SceneData<'_>, frame: u64) -> Arrivals {
        let asked = demand(scene, self.number, frame);
        let mut named = BTreeSet::new();
        let mut records: Vec<u32> = asked.iter().map(|&corner| self.record_of(corner)).collect();
        records.retain(|&record| named.insert(record));
        let needs: BTreeMap<u32, Need> =
            records.iter().enumerate().map(|(place, &record)| (record, (frame, Reverse(place)))).collect();
        self.order(&records[..records.len().min(self.room)], &needs);
        let mut missing: Arrivals = asked
            .into_iter()
            .filter(|&corner| !self.held.contains_key(&self.record_of(corner)))
            .map(|corner| (corner, None))
            .collect();
        let starts = starts(scene, frame);
        let arrived = self.turn([starts[0] as u64, starts[starts.len() - 1] as u64], &needs);
        for (&corner, arrival) in &mut missing {
            *arrival = arrived.get(&self.record_of(corner)).map(|&tick| tick as i64);
        }
        missing
    }

    /// The records that bring missing corners in a frame, with their ticks.
    pub fn records(&self, missing: &Arrivals) -> Vec<(i64, FromDrum)> {
        let mut records: BTreeMap<(i64, usize), FromDrum> = BTreeMap::new();
        for (&corner, arrival) in missing {
            let Some(tick) = *arrival else { continue };
            let drum = self.drum_of(self.record_of(corner));
            let record =
                records.entry((tick, drum)).or_insert(FromDrum { drum: drum as u32, corner, words: 0 });
            record.words += WORDS;
        }
        records.into_iter().map(|((tick, _), record)| (tick, record)).collect()
    }

    fn record_of(&self, [m, n]: [i64; 2]) -> u32 {
        m as u32 / self.side * self.columns.div_ceil(self.side) + n as u32 / self.side
    }

    fn drum_of(&self, record: u32) -> usize {
        record as usize % self.drums.len()
    }

    /// Writes all queues anew for the records that the buffer has room for, the most urgent first.
    fn order(&mut self, kept: &[u32], needs: &BTreeMap<u32, Need>) {
        if !self.has_begun {
            self.held = kept.iter().map(|&record| (record, needs[&record])).collect();
            self.has_begun = true;
        }
        for drum in &mut self.drums {
            drum.waiting.clear();
            if drum.record.is_some_and(|record| !kept.contains(&record)) {
                (drum.record, drum.until) = (None, None);
            }
        }
        for (record, need) in needs {
            if let Some(held) = self.held.get_mut(record) {
                *held = *need;
            }
        }
        for (place, &record) in kept.iter().enumerate() {
            let number = self.drum_of(record);
            let drum = &mut self.drums[number];
            if !self.held.contains_key(&record) && drum.record != Some(record) {
                drum.waiting.push((place, record));
            }
        }
        self.make_room();
    }

    /// Drops what is needed least until there is room for all that is on order.
    fn make_room(&mut self) {
        let open = |drum: &Turning| drum.waiting.len() + usize::from(drum.record.is_some());
        let ordered: usize = self.drums.iter().map(open).sum();
        while self.held.len() + ordered > self.room && !self.held.is_empty() {
            let least = self.held.iter().map(|(&record, &need)| (need, record)).min();
            least.map(|(_, record)| self.held.remove(&record));
        }
    }

    /// Lets the drums turn from the first tick to the last; when each record came.
    fn turn(&mut self, [first, last]: [u64; 2], needs: &BTreeMap<u32, Need>) -> BTreeMap<u32, u64> {
        let mut arrived = BTreeMap::new();
        for drum in 0..self.drums.len() {
            if self.drums[drum].record.is_none() {
                self.take_next(drum, first);
            }
        }
        let mut tick = first;
        while tick <= last {
            for number in 0..self.drums.len() {
                if self.drums[number].until == Some(tick) {
                    let record = self.drums[number].record.take().expect("it reads one");
                    self.drums[number].until = None;
                    self.held.insert(record, needs[&record]);
                    arrived.insert(record, tick);
                    if tick < last {
                        self.take_next(number, tick);
                    }
                }
            }
            for number in 0..self.drums.len() {
                if self.passes(number, tick) && self.channel_is_free(number) {
                    self.drums[number].until = Some(tick + self.drums[number].figures.transfer);
                }
            }
            let next = (0..self.drums.len()).filter_map(|number| self.next(number, tick)).min();
            tick = next.unwrap_or(u64::MAX);
        }
        arrived
    }

    /// Turns to the record that waits at the top of the list, or to that which comes under the heads first.
    fn take_next(&mut self, number: usize, tick: u64) {
        let way = |&(place, record): &(usize, u32)| match self.queue {
            DrumQueue::Fifo => (0, place),
            DrumQueue::ShortestLatency => (self.way(number, record, tick), place),
        };
        let waiting = &self.drums[number].waiting;
        let Some(chosen) = (0..waiting.len()).min_by_key(|&k| way(&waiting[k])) else { return };
        let (_, record) = self.drums[number].waiting.remove(chosen);
        self.drums[number].record = Some(record);
    }

    /// Ticks from `tick` on until a record is under the heads of its drum.
    fn way(&self, number: usize, record: u32, tick: u64) -> u64 {
        let DrumFigures { rotation, transfer, start_angle } = self.drums[number].figures;
        let index = u64::from(record) / self.drums.len() as u64;
        let place = (u128::from(index) * u128::from(transfer) % u128::from(rotation)) as u64;
        let angle = (tick % rotation + start_angle) % rotation;
        (place + rotation - angle) % rotation
    }

    fn passes(&self, number: usize, tick: u64) -> bool {
        let Turning { record, until, .. } = self.drums[number];
        until.is_none() && record.is_some_and(|record| self.way(number, record, tick) == 0)
    }

    /// Whether no drum reads over the channel of this one.
    fn channel_is_free(&self, number: usize) -> bool {
        let of_channel = self.drums.iter().skip(number % self.channels).step_by(self.channels);
        of_channel.into_iter().all(|drum| drum.until.is_none())
    }

    /// The next tick after `tick` at which something happens to a drum.
    fn next(&self, number: usize, tick: u64) -> Option<u64> {
        let Turning { record, until, .. } = self.drums[number];
        until.or_else(|| Some(tick + 1 + self.way(number, record?, tick + 1)))
    }
}
