//! One drum: where it stands, what waits for it, what is under its heads.

use std::collections::BTreeSet;

use hardware_model::{Drum, DrumQueue};
use quantities::unit_interval;

/// Spread of the speed of drums, one standard deviation (hardware section 2.3).
const SPEED_SPREAD: f64 = 0.005;
/// Longest time of a drum (ticks): sums of two stay within 64 bits.
const LONGEST: u64 = 1 << 62;

/// One drum as the seed drew it; master ticks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DrumUnit {
    /// One revolution, at least 1.
    pub rotation: u64,
    /// Reading one record.
    pub transfer: u64,
    /// Angle at tick 0, `0..rotation`.
    pub start_angle: u64,
}

impl DrumUnit {
    /// Drum number `unit` of the design `drum`, with records of `words`.
    pub(crate) fn drawn(drum: &Drum, words: u32, seed: u64, unit: u32) -> Self {
        let draw = |word: u64| unit_interval(seed, &[u64::from(unit), word]);
        // Twelve uniform numbers, each of variance 1/12: near enough to normal, and never beyond six sigma.
        let deviate = (1..=12).map(draw).sum::<f64>() - 6.0;
        let slowness = 1.0 + SPEED_SPREAD * deviate;
        let rotation = ((drum.rotation as f64 * slowness).round() as u64).clamp(1, LONGEST);
        let transfer = ((f64::from(words) * drum.word * slowness).ceil() as u64).min(LONGEST);
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

    /// When a record that begins at `place` has been read, if the drum turns to it from `tick` on.
    pub fn arrival(&self, place: u64, tick: u64) -> u64 {
        let wait = (place + self.rotation - self.angle(tick)) % self.rotation;
        tick.saturating_add(wait).saturating_add(self.transfer)
    }
}

/// A request that waits: place that decides (0 for all under FIFO), rank in the demand, record.
type Waiting = (u64, u32, u32);

/// A record under the heads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Reading {
    record: u32,
    begun: u64,
    arrival: u64,
}

/// A drum with its queue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DrumAtWork {
    pub(crate) unit: DrumUnit,
    discipline: DrumQueue,
    /// Drums that share the records.
    count: u32,
    waiting: BTreeSet<Waiting>,
    reading: Option<Reading>,
    /// Since when nothing is under the heads.
    free: u64,
}

impl DrumAtWork {
    /// An idle drum, one of `count`.
    pub(crate) fn new(unit: DrumUnit, discipline: DrumQueue, count: u32) -> Self {
        Self { unit, discipline, count, waiting: BTreeSet::new(), reading: None, free: 0 }
    }

    /// Forgets the queue, and the record under the heads unless it is `wanted` still.
    pub(crate) fn clear(&mut self, wanted: impl Fn(u32) -> bool) {
        self.waiting.clear();
        self.reading = self.reading.filter(|reading| wanted(reading.record));
    }

    /// Puts a record in the queue, unless it is under the heads.
    pub(crate) fn enqueue(&mut self, record: u32, rank: u32) {
        if self.reading.is_none_or(|reading| reading.record != record) {
            let place = match self.discipline {
                DrumQueue::Fifo => 0,
                DrumQueue::ShortestLatency => self.place_of(record),
            };
            self.waiting.insert((place, rank, record));
        }
    }

    /// Requests open, with the one under the heads.
    pub(crate) fn open(&self) -> usize {
        self.waiting.len() + usize::from(self.reading.is_some())
    }

    /// What is under the heads and arrives by `tick`.
    pub(crate) fn arrived_by(&mut self, tick: u64) -> Option<(u32, u64)> {
        let Reading { record, arrival, .. } = self.reading.take_if(|reading| reading.arrival <= tick)?;
        self.free = arrival;
        Some((record, arrival))
    }

    /// Works from `start` to `end`; appends each record that arrives, with its tick. Returns the ticks at work.
    pub(crate) fn work(&mut self, start: u64, end: u64, arrived: &mut Vec<(u32, u64)>) -> u64 {
        let mut busy = 0;
        loop {
            self.reading = self.reading.or_else(|| self.take_next(start.max(self.free), end));
            let Some(reading) = self.reading else { return busy };
            busy += reading.arrival.min(end).saturating_sub(reading.begun.max(start));
            let Some(done) = self.arrived_by(end) else { return busy };
            arrived.push(done);
        }
    }

    /// The request that the discipline serves from `now` on; none once the frame is over.
    fn take_next(&mut self, now: u64, end: u64) -> Option<Reading> {
        if now >= end {
            return None;
        }
        // All FIFO requests wait at place 0, so that the first at or behind 0 is the first of all.
        let angle = match self.discipline {
            DrumQueue::Fifo => 0,
            DrumQueue::ShortestLatency => self.unit.angle(now),
        };
        let next = self.waiting.range((angle, 0, 0)..).next().or_else(|| self.waiting.first()).copied()?;
        self.waiting.remove(&next);
        let record = next.2;
        Some(Reading { record, begun: now, arrival: self.unit.arrival(self.place_of(record), now) })
    }

    fn place_of(&self, record: u32) -> u64 {
        self.unit.place(record / self.count)
    }
}
