//! Drums, their queues, the storage buffers and the I/O processors behind them, from the first frame on (section 17; sheet of the
//! data bank).

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use hardware_model::{Drum, DrumQueue, KindBank};

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

/// A kind of data on some drums, as it is given.
#[derive(Debug, Clone)]
pub struct GivenKind {
    /// 0 fine terrain, 1 coarse terrain, 2 features, 3 boundaries of shadow, 4 polyhedra.
    pub kind: usize,
    /// The drums, with the transfer of a record of the kind.
    pub drums: Vec<DrumFigures>,
    /// What each frame asks for, the most urgent first: a square or one of its records, and how many records from there on. Of terrain nothing: the interpreter knows it.
    pub asked: Vec<Vec<[u32; 2]>>,
}

/// When each corner comes that the storage buffer has not as a frame begins; none if not in this frame.
pub type Arrivals = BTreeMap<[i64; 2], Option<i64>>;

/// How much a record is needed: the last frame that asked for it, and how early in its list.
type Need = (u64, Reverse<usize>);

/// A record: number of the store, number in it.
type Key = (usize, u32);

/// A drum at work.
#[derive(Debug, Clone)]
struct Turning {
    /// The drum, by store.
    figures: Vec<DrumFigures>,
    /// Record that it turns to or reads.
    record: Option<Key>,
    /// When that has been read; none while it turns.
    until: Option<u64>,
    /// Records that wait, with their place in the list of all stores.
    waiting: Vec<(usize, Key)>,
}

/// The records of one kind.
#[derive(Debug, Clone)]
struct Store {
    given: GivenKind,
    lattice: Lattice,
    /// Records that the buffer has room for.
    room: usize,
    /// Ticks in which the I/O processor edits a record.
    edit: u64,
    held: BTreeMap<u32, Need>,
    /// Records that it edits, with the tick at which each is done.
    editing: Vec<(u32, u64)>,
    has_begun: bool,
}

/// How pieces lie in records.
#[derive(Debug, Clone, Copy)]
enum Lattice {
    /// Corners to the east, and along a side of the square that a record holds.
    Corners { columns: u32, side: u32 },
    /// Squares to the north and to the east, regions along a side.
    Squares { counts: [u32; 2], regions: u32 },
}

/// What a frame asks of a store, and what becomes of it.
struct Asked {
    /// Pieces, each with its records: a corner, or a square.
    pieces: Vec<([i64; 2], Vec<u32>)>,
    /// Records in the order in which they are wanted, each once.
    records: Vec<u32>,
    needs: BTreeMap<u32, Need>,
}

/// Everything between some drums and the generators that their data go to.
#[derive(Debug, Clone)]
pub struct Bank {
    stores: Vec<Store>,
    queue: DrumQueue,
    channels: usize,
    drums: Vec<Turning>,
}

impl Store {
    fn before_mission(scene: &SceneData<'_>, given: &GivenKind) -> Self {
        let (banks, kinds) = (&scene.settings.data_banks, &scene.settings.kind_banks);
        let levels = scene.landscape.bank().levels();
        let drum = banks.drum.expect("drums have a design");
        let of_terrain = |level: usize| {
            let words = drum.record_words.max(WORDS);
            let columns = levels[level].corners()[1] as u32;
            let lattice = Lattice::Corners { columns, side: (words / WORDS).isqrt() };
            (lattice, words, banks.buffer_words, kinds.terrain_edit)
        };
        let of_squares = |bank: &KindBank| {
            let regions = bank.record_regions;
            let counts = levels[0].corners().map(|corners| (corners as u32 - 1).div_ceil(regions));
            let lattice = Lattice::Squares { counts, regions };
            (lattice, bank.record_words.max(WORDS), bank.buffer_words, bank.edit)
        };
        let (lattice, words, buffer, edit) = match given.kind {
            2 => of_squares(&kinds.features),
            3 => of_squares(&kinds.shadows),
            4 => of_squares(&kinds.polyhedra),
            level => of_terrain(level),
        };
        Self {
            given: given.clone(),
            lattice,
            room: buffer.map_or(usize::MAX, |held| (held / words) as usize),
            edit: (f64::from(words) * edit).ceil() as u64,
            held: BTreeMap::new(),
            editing: Vec::new(),
            has_begun: false,
        }
    }

    fn asked(&self, scene: &SceneData<'_>, frame: u64) -> Asked {
        let pieces: Vec<([i64; 2], Vec<u32>)> = match self.lattice {
            Lattice::Corners { columns, side } => {
                let record = |[m, n]: [i64; 2]| m as u32 / side * columns.div_ceil(side) + n as u32 / side;
                let corners = demand(scene, self.given.kind, frame).into_iter();
                corners.map(|corner| (corner, vec![record(corner)])).collect()
            }
            Lattice::Squares { counts: [north, east], .. } => {
                let links =
                    |[square, count]: [u32; 2]| (0..count).map(|link| square + link * north * east).collect();
                let squares = self.given.asked[frame as usize].iter();
                squares.map(|&piece| ([i64::from(piece[0]), 0], links(piece))).collect()
            }
        };
        let mut named = BTreeSet::new();
        let mut records: Vec<u32> = pieces.iter().flat_map(|(_, records)| records.clone()).collect();
        records.retain(|&record| named.insert(record));
        let needs = records.iter().enumerate().map(|(place, &record)| (record, (frame, Reverse(place))));
        Asked { needs: needs.collect(), records, pieces }
    }

    /// When each piece comes that is not whole as the frame begins.
    fn missing(&self, asked: &Asked) -> Arrivals {
        let lacks = |(_, records): &&([i64; 2], Vec<u32>)| {
            records.iter().any(|record| !self.held.contains_key(record))
        };
        asked.pieces.iter().filter(lacks).map(|(piece, _)| (*piece, None)).collect()
    }

    /// Drops what is needed least until there is room for `ordered` more records.
    fn make_room(&mut self, ordered: usize) {
        while self.held.len() + ordered > self.room && !self.held.is_empty() {
            let least = self.held.iter().map(|(&record, &need)| (need, record)).min();
            least.map(|(_, record)| self.held.remove(&record));
        }
    }

    fn edits(&self, record: u32) -> bool {
        self.editing.iter().any(|&(edited, _)| edited == record)
    }
}

impl Bank {
    /// Idle drums; the first frame finds what it asks for.
    pub fn before_mission(scene: &SceneData<'_>, kinds: &[GivenKind]) -> Self {
        let banks = &scene.settings.data_banks;
        let Drum { queue, .. } = banks.drum.expect("drums have a design");
        let count = kinds[0].drums.len();
        let idle = |number: usize| Turning {
            figures: kinds.iter().map(|given| given.drums[number]).collect(),
            record: None,
            until: None,
            waiting: Vec::new(),
        };
        Self {
            stores: kinds.iter().map(|given| Store::before_mission(scene, given)).collect(),
            queue,
            channels: banks.channels.count.map_or(count, |channels| (channels as usize).clamp(1, count)),
            drums: (0..count).map(idle).collect(),
        }
    }

    /// One frame: for each kind what it asks for and the buffer has not whole when it begins, with the tick at which it comes.
    pub fn frame(&mut self, scene: &SceneData<'_>, frame: u64) -> Vec<Arrivals> {
        let asked: Vec<Asked> = self.stores.iter().map(|store| store.asked(scene, frame)).collect();
        self.order(&asked);
        let mut missing: Vec<Arrivals> =
            self.stores.iter().zip(&asked).map(|(store, asked)| store.missing(asked)).collect();
        let starts = starts(scene, frame);
        let arrived = self.turn([starts[0] as u64, starts[starts.len() - 1] as u64], &asked);
        for (number, (missing, asked)) in missing.iter_mut().zip(&asked).enumerate() {
            let when = |record: &u32| match arrived.get(&(number, *record)) {
                Some(&tick) => Some(tick as i64),
                None => self.stores[number].held.contains_key(record).then_some(0),
            };
            for (piece, records) in asked.pieces.iter() {
                if let Some(arrival) = missing.get_mut(piece) {
                    let all: Option<Vec<i64>> = records.iter().map(when).collect();
                    *arrival = all.and_then(|ticks| ticks.into_iter().max());
                }
            }
        }
        missing
    }

    /// The records that bring missing pieces of a store in a frame, with their ticks: of terrain each with its corners, of squares the
    /// last of each.
    pub fn records(&self, store: usize, missing: &Arrivals) -> Vec<(i64, FromDrum)> {
        let mut records: BTreeMap<(i64, usize, [i64; 2]), FromDrum> = BTreeMap::new();
        for (&piece, arrival) in missing {
            let Some(tick) = *arrival else { continue };
            let (first, place, group, words) = match self.stores[store].lattice {
                Lattice::Corners { columns, side } => {
                    let [m, n] = piece.map(|along| along as u32);
                    (m / side * columns.div_ceil(side) + n / side, piece, [0; 2], WORDS)
                }
                Lattice::Squares { counts, regions } => {
                    let record = piece[0] as u32;
                    let square = record % (counts[0] * counts[1]);
                    let along = [square / counts[1], square % counts[1]];
                    (record, along.map(|along| i64::from(along * regions)), piece, 0)
                }
            };
            let drum = self.drum_of(first);
            let fresh = FromDrum { drum: drum as u32, corner: place, words: 0 };
            records.entry((tick, drum, group)).or_insert(fresh).words += words;
        }
        records.into_iter().map(|((tick, ..), record)| (tick, record)).collect()
    }

    fn drum_of(&self, record: u32) -> usize {
        record as usize % self.drums.len()
    }

    /// Writes all queues anew for the records that the buffers have room for, the most urgent first, the kinds in turn.
    fn order(&mut self, asked: &[Asked]) {
        let rooms: Vec<usize> = self.stores.iter().map(|store| store.room).collect();
        let kept = |number: usize| &asked[number].records[..asked[number].records.len().min(rooms[number])];
        for drum in &mut self.drums {
            drum.waiting.clear();
            if drum.record.is_some_and(|(store, record)| !kept(store).contains(&record)) {
                (drum.record, drum.until) = (None, None);
            }
        }
        for number in 0..self.stores.len() {
            let store = &mut self.stores[number];
            let kept = kept(number);
            if !store.has_begun {
                store.held = kept.iter().map(|&record| (record, asked[number].needs[&record])).collect();
                store.has_begun = true;
            }
            for (record, need) in &asked[number].needs {
                if let Some(held) = store.held.get_mut(record) {
                    *held = *need;
                }
            }
            let ordered: Vec<(usize, u32)> = kept
                .iter()
                .enumerate()
                .filter(|(_, record)| !store.held.contains_key(record))
                .map(|(place, &record)| (place, record))
                .collect();
            for &(place, record) in &ordered {
                let drum = self.drum_of(record);
                let is_under_way = self.drums[drum].record == Some((number, record));
                if !is_under_way && !self.stores[number].edits(record) {
                    let place = place * self.stores.len() + number;
                    self.drums[drum].waiting.push((place, (number, record)));
                }
            }
            self.stores[number].make_room(ordered.len());
        }
    }

    /// Lets the drums turn from the first tick to the last; when each record came.
    fn turn(&mut self, [first, last]: [u64; 2], asked: &[Asked]) -> BTreeMap<Key, u64> {
        let mut read: Vec<(u64, Key)> = Vec::new();
        for drum in 0..self.drums.len() {
            if self.drums[drum].record.is_none() {
                self.take_next(drum, first);
            }
        }
        let mut tick = first;
        while tick <= last {
            for number in 0..self.drums.len() {
                if self.drums[number].until == Some(tick) {
                    read.push((tick, self.drums[number].record.take().expect("it reads one")));
                    self.drums[number].until = None;
                    if tick < last {
                        self.take_next(number, tick);
                    }
                }
            }
            for number in 0..self.drums.len() {
                if self.passes(number, tick) && self.channel_is_free(number) {
                    let drum = &mut self.drums[number];
                    let store = drum.record.map_or(0, |(store, _)| store);
                    drum.until = Some(tick + drum.figures[store].transfer);
                }
            }
            let next = (0..self.drums.len()).filter_map(|number| self.next(number, tick)).min();
            tick = next.unwrap_or(u64::MAX);
        }
        read.sort_by_key(|&(tick, key)| (tick, key));
        self.edit(&read, last, asked)
    }

    /// Edits what was read, one record of a kind after another; when each was done that is by `last`.
    fn edit(&mut self, read: &[(u64, Key)], last: u64, asked: &[Asked]) -> BTreeMap<Key, u64> {
        for &(tick, (number, record)) in read {
            let store = &mut self.stores[number];
            let free = store.editing.last().map_or(0, |&(_, done)| done);
            store.editing.push((record, tick.max(free) + store.edit));
        }
        let mut arrived = BTreeMap::new();
        for (number, store) in self.stores.iter_mut().enumerate() {
            let room = asked[number].records.len().min(store.room);
            let kept = &asked[number].records[..room];
            let (done, left): (Vec<_>, Vec<_>) = store.editing.iter().partition(|&&(_, done)| done <= last);
            store.editing = left;
            for (record, tick) in done {
                // What nobody has on order any more is not taken.
                if kept.contains(&record) && !store.held.contains_key(&record) {
                    store.held.insert(record, asked[number].needs[&record]);
                    arrived.insert((number, record), tick);
                }
            }
        }
        arrived
    }

    /// Turns to the record that waits at the top of the list, or to that which comes under the heads first.
    fn take_next(&mut self, number: usize, tick: u64) {
        let way = |&(place, record): &(usize, Key)| match self.queue {
            DrumQueue::Fifo => (0, place),
            DrumQueue::ShortestLatency => (self.way(number, record, tick), place),
        };
        let waiting = &self.drums[number].waiting;
        let Some(chosen) = (0..waiting.len()).min_by_key(|&k| way(&waiting[k])) else { return };
        let (_, record) = self.drums[number].waiting.remove(chosen);
        self.drums[number].record = Some(record);
    }

    /// Ticks from `tick` on until a record is under the heads of its drum.
    fn way(&self, number: usize, (store, record): Key, tick: u64) -> u64 {
        let DrumFigures { rotation, transfer, start_angle } = self.drums[number].figures[store];
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
