//! One drum: where it stands, what waits for it, what is under its heads.

use std::collections::BTreeSet;

use hardware_model::{Channels, Drum, DrumQueue};
use quantities::unit_interval;

use crate::key::Key;
use crate::span::Span;
use crate::state::{DrumState, Heads};

/// Spread of the speed of drums, one standard deviation (hardware section 2.3).
const SPEED_SPREAD: f64 = 0.005;
/// Longest time of a drum (ticks): sums of two stay within 64 bits.
const LONGEST: u64 = 1 << 62;

/// One drum as the seed drew it; master ticks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DrumUnit {
    /// One revolution, at least 1.
    pub rotation: u64,
    /// Reading one record over its channel.
    pub transfer: u64,
    /// Angle at tick 0, `0..rotation`.
    pub start_angle: u64,
}

impl DrumUnit {
    /// Drum number `unit` of the design `drum`, with records of `words`, laid out for its channel.
    pub(crate) fn drawn(drum: &Drum, channels: &Channels, words: u32, seed: u64, unit: u32) -> Self {
        let draw = |word: u64| unit_interval(seed, &[u64::from(unit), word]);
        // Twelve uniform numbers, each of variance 1/12: near enough to normal, and never beyond six sigma.
        let deviate = (1..=12).map(draw).sum::<f64>() - 6.0;
        let slowness = 1.0 + SPEED_SPREAD * deviate;
        let rotation = ((drum.rotation as f64 * slowness).round() as u64).clamp(1, LONGEST);
        let words = f64::from(words);
        let transfer = (words * drum.word * slowness).max(words * channels.word);
        let transfer = (transfer.ceil() as u64).min(LONGEST);
        let start_angle = ((draw(0) * rotation as f64) as u64).min(rotation - 1);
        Self { rotation, transfer, start_angle }
    }

    /// Angle at a tick, `0..rotation`.
    pub fn angle(&self, tick: u64) -> u64 {
        (tick % self.rotation + self.start_angle) % self.rotation
    }

    /// Angle at which the `index`-th record of this drum begins, `0..rotation`.
    pub fn place(&self, index: u32) -> u64 {
        let along = u128::from(index) * u128::from(self.transfer);
        (along % u128::from(self.rotation)) as u64
    }

    /// When a record that begins at `place` comes under the heads, from `tick` on.
    pub fn passes(&self, place: u64, tick: u64) -> u64 {
        tick.saturating_add((place + self.rotation - self.angle(tick)) % self.rotation)
    }
}

/// A request that waits: place that decides (0 for all under FIFO), rank in the demands, record.
type Waiting = (u64, u32, Key);

/// A key that comes before those of all records.
const FIRST: Key = Key { store: 0, record: 0 };

/// What happens next to a drum, and when; of one tick, what stands first comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Event {
    /// A record has been read.
    Arrival,
    /// A record is under the heads.
    Passage,
}

/// A drum with its queue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DrumAtWork {
    /// The drum with the transfer of a record of each store.
    units: Vec<DrumUnit>,
    discipline: DrumQueue,
    /// Drums that share the records.
    count: u32,
    waiting: BTreeSet<Waiting>,
    heads: Heads,
}

impl DrumAtWork {
    /// An idle drum, one of `count`, as each store sees it.
    pub(crate) fn new(units: Vec<DrumUnit>, discipline: DrumQueue, count: u32) -> Self {
        Self { units, discipline, count, waiting: BTreeSet::new(), heads: Heads::Idle }
    }

    /// The drum with the transfer of a record of store `store`.
    pub(crate) fn unit(&self, store: u32) -> DrumUnit {
        self.units[store as usize]
    }

    /// Forgets the queue at `tick`, and the record that it turns to or reads unless it is `wanted` still. One that had to
    /// pass because the channel was taken is looked at again.
    pub(crate) fn clear(&mut self, tick: u64, wanted: impl Fn(Key) -> bool) {
        self.waiting.clear();
        if self.record().is_some_and(|key| !wanted(key)) {
            self.heads = Heads::Idle;
        }
        if let Heads::Turning { store, record, begun, .. } = self.heads {
            self.heads = self.turning(Key { store, record }, begun, tick);
        }
    }

    /// Puts a record in the queue, unless it is under the heads.
    pub(crate) fn enqueue(&mut self, key: Key, rank: u32) {
        if self.record() != Some(key) {
            let place = match self.discipline {
                DrumQueue::Fifo => 0,
                DrumQueue::ShortestLatency => self.place_of(key),
            };
            self.waiting.insert((place, rank, key));
        }
    }

    /// Heads and queue as they are.
    pub(crate) fn state(&self) -> DrumState {
        DrumState {
            heads: self.heads,
            waiting: self.waiting.iter().map(|&(_, _, key)| (key.store, key.record)).collect(),
        }
    }

    /// Requests open, with the one under the heads.
    pub(crate) fn open(&self) -> usize {
        self.waiting.len() + usize::from(self.record().is_some())
    }

    /// The record that it turns to or reads.
    fn record(&self) -> Option<Key> {
        match self.heads {
            Heads::Idle => None,
            Heads::Turning { store, record, .. } | Heads::Reading { store, record, .. } => {
                Some(Key { store, record })
            }
        }
    }

    /// What happens next, if it is at work.
    pub(crate) fn next_event(&self) -> Option<(u64, Event)> {
        match self.heads {
            Heads::Idle => None,
            Heads::Turning { under, .. } => Some((under, Event::Passage)),
            Heads::Reading { store, under, .. } => Some((self.read_until(store, under), Event::Arrival)),
        }
    }

    /// Until when it keeps its channel, if it does.
    pub(crate) fn carries_until(&self) -> Option<u64> {
        self.next_event().filter(|&(_, event)| event == Event::Arrival).map(|(tick, _)| tick)
    }

    /// The record that passes is read.
    pub(crate) fn read(&mut self) {
        if let Heads::Turning { store, record, begun, under } = self.heads {
            self.heads = Heads::Reading { store, record, begun, under };
        }
    }

    /// The record passes, for the channel is taken until `free`.
    pub(crate) fn let_pass(&mut self, free: u64) {
        if let Heads::Turning { store, record, begun, .. } = self.heads {
            self.heads = self.turning(Key { store, record }, begun, free);
        }
    }

    /// The record that has been read, with its tick.
    pub(crate) fn finish(&mut self) -> Option<(Key, u64)> {
        let Heads::Reading { store, record, under, .. } = self.heads else { return None };
        self.heads = Heads::Idle;
        Some((Key { store, record }, self.read_until(store, under)))
    }

    /// Its present record, with the ticks of `span` at which it began to turn to it, began to read it, and was done or is at the end.
    pub(crate) fn spell(&self, span: Span) -> Option<(Key, [u64; 3])> {
        let ticks = match self.heads {
            Heads::Idle => return None,
            Heads::Turning { begun, .. } => [begun, span.end, span.end],
            Heads::Reading { store, begun, under, .. } => [begun, under, self.read_until(store, under)],
        };
        Some((self.record()?, ticks.map(|tick| span.nearest(tick))))
    }

    /// Turns to the request that the discipline serves from `now` on, if any waits.
    pub(crate) fn take_next(&mut self, now: u64) {
        // All FIFO requests wait at place 0, so that the first at or behind 0 is the first of all.
        let angle = match self.discipline {
            DrumQueue::Fifo => 0,
            DrumQueue::ShortestLatency => self.units[0].angle(now),
        };
        let next = self.waiting.range((angle, 0, FIRST)..).next().or_else(|| self.waiting.first()).copied();
        if let Some(next) = next {
            self.waiting.remove(&next);
            self.heads = self.turning(next.2, now, now);
        }
    }

    /// Turning to a record since `begun`, to read it where it passes from `tick` on.
    fn turning(&self, key: Key, begun: u64, tick: u64) -> Heads {
        let under = self.unit(key.store).passes(self.place_of(key), tick);
        Heads::Turning { store: key.store, record: key.record, begun, under }
    }

    fn read_until(&self, store: u32, under: u64) -> u64 {
        under.saturating_add(self.unit(store).transfer)
    }

    fn place_of(&self, key: Key) -> u64 {
        self.unit(key.store).place(key.record / self.count)
    }
}
