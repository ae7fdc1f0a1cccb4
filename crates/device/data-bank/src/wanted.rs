//! The records that one demand touches.

use std::cmp::Reverse;

use crate::buffer::{Need, StorageBuffer};
use crate::layout::Layout;
use crate::supply::Piece;

/// The records of a demand, each once with its rank: its place in the demand.
pub(crate) struct Wanted {
    /// Records with their rank, the most urgent first.
    pub(crate) by_rank: Vec<(u32, u32)>,
    /// Records with their rank, in ascending order of records.
    by_record: Vec<(u32, u32)>,
    /// How many of the most urgent the buffer has room for.
    kept: usize,
    frame: u64,
}

impl Wanted {
    /// The records of `pieces`, the most urgent first, and how many of them `buffer` has room for.
    pub(crate) fn new(frame: u64, pieces: &[Piece], layout: &Layout, buffer: &StorageBuffer) -> Self {
        let records = pieces.iter().flat_map(|&piece| layout.records_of(piece));
        let mut by_record: Vec<(u32, u32)> = records.zip(0..).collect();
        by_record.sort_unstable();
        by_record.dedup_by_key(|&mut (record, _)| record);
        let mut by_rank = by_record.clone();
        by_rank.sort_unstable_by_key(|&(_, rank)| rank);
        let kept = buffer.room_for(by_rank.len());
        Self { by_rank, by_record, kept, frame }
    }

    /// Records that the buffer has room for, each with its rank.
    pub(crate) fn kept(&self) -> &[(u32, u32)] {
        &self.by_rank[..self.kept]
    }

    /// Whether the buffer has room for a record of the demand.
    pub(crate) fn keeps(&self, record: u32) -> bool {
        let first_without_room = self.by_rank.get(self.kept).map_or(u32::MAX, |&(_, rank)| rank);
        let found = self.by_record.binary_search_by_key(&record, |&(record, _)| record);
        found.is_ok_and(|at| self.by_record[at].1 < first_without_room)
    }

    /// How much the demand needs what has this rank.
    pub(crate) fn need(&self, rank: u32) -> Need {
        Need { frame: self.frame, rank: Reverse(rank) }
    }
}
