//! The storage buffer: which records it holds, and which it drops.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::state::HeldRecord;

/// How much a record is needed; the least is dropped first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Need {
    /// Frame that demanded it last.
    pub(crate) frame: u64,
    /// Its place in that demand, from 0 for the most urgent.
    pub(crate) rank: Reverse<u32>,
}

impl Need {
    /// The need of a record, as it is written down.
    pub(crate) fn of(self, record: u32) -> HeldRecord {
        HeldRecord { record, frame: self.frame, rank: self.rank.0 }
    }
}

/// Records held, each with its need.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct StorageBuffer {
    /// Records that fit; any number if `None`.
    capacity: Option<usize>,
    records: BTreeMap<u32, Need>,
}

impl StorageBuffer {
    /// Makes an empty buffer for `capacity` records; any number if `None`.
    pub(crate) fn new(capacity: Option<usize>) -> Self {
        Self { capacity, records: BTreeMap::new() }
    }

    /// How many of `count` records have room at once.
    pub(crate) fn room_for(&self, count: usize) -> usize {
        self.capacity.map_or(count, |capacity| count.min(capacity))
    }

    /// Whether a record is held.
    pub(crate) fn holds(&self, record: u32) -> bool {
        self.records.contains_key(&record)
    }

    /// Returns the number of records that the buffer holds.
    pub(crate) fn len(&self) -> usize {
        self.records.len()
    }

    /// The records held, ascending, each with its need.
    pub(crate) fn records(&self) -> impl Iterator<Item = (u32, Need)> {
        self.records.iter().map(|(&record, &need)| (record, need))
    }

    /// Takes a record in.
    pub(crate) fn put(&mut self, record: u32, need: Need) {
        self.records.insert(record, need);
    }

    /// Notes that a frame demands a record; no effect on one that is not held.
    pub(crate) fn note_need(&mut self, record: u32, need: Need) {
        if let Some(held) = self.records.get_mut(&record) {
            *held = need;
        }
    }

    /// Drops the least needed records until there is room for `ordered` more; returns how many it dropped.
    pub(crate) fn make_room(&mut self, ordered: usize) -> usize {
        let all = self.records.len() + ordered;
        let excess = (all - self.room_for(all)).min(self.records.len());
        if excess > 0 {
            let mut by_need: Vec<_> = self.records.iter().map(|(&record, &need)| (need, record)).collect();
            by_need.sort_unstable();
            for (_, record) in &by_need[..excess] {
                self.records.remove(record);
            }
        }
        excess
    }
}

#[cfg(test)]
mod tests {
    use super::{Need, StorageBuffer};
    use std::cmp::Reverse;

    fn need(frame: u64, rank: u32) -> Need {
        Need { frame, rank: Reverse(rank) }
    }

    #[test]
    fn what_was_not_wanted_for_longest_goes_then_the_least_urgent() {
        let mut buffer = StorageBuffer::new(Some(4));
        for (record, frame, rank) in [(1, 7, 0), (2, 6, 0), (3, 7, 9), (4, 5, 0)] {
            buffer.put(record, need(frame, rank));
        }
        assert_eq!(buffer.make_room(0), 0);
        assert_eq!(buffer.make_room(1), 1);
        assert!(!buffer.holds(4));
        assert_eq!(buffer.make_room(3), 2);
        assert!(buffer.holds(1) && !buffer.holds(2) && !buffer.holds(3));
        assert_eq!(buffer.make_room(9), 1);
        assert_eq!(buffer.len(), 0);
    }

    #[test]
    fn need_is_renewed_only_for_what_is_held() {
        let mut buffer = StorageBuffer::new(Some(2));
        buffer.put(1, need(0, 0));
        buffer.put(2, need(0, 1));
        buffer.note_need(2, need(1, 0));
        buffer.note_need(3, need(1, 1));
        assert_eq!(buffer.len(), 2);
        buffer.make_room(1);
        assert!(buffer.holds(2) && !buffer.holds(1));
    }

    #[test]
    fn a_buffer_without_limit_keeps_all() {
        let mut buffer = StorageBuffer::new(None);
        buffer.put(1, need(0, 0));
        assert_eq!(buffer.make_room(1 << 40), 0);
        assert_eq!(buffer.room_for(1 << 40), 1 << 40);
    }
}
