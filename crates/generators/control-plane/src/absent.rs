//! What the storage buffers lack in a frame beside corners.

use std::collections::BTreeMap;

use data_bank::FrameSupply;
use quantities::Tick;

use crate::squares::SquareGrid;

/// Pieces that are not whole in the storage buffer as a frame begins: squares, or single records of their chains.
#[derive(Debug, Clone, PartialEq)]
pub struct Absent {
    grid: SquareGrid,
    /// When each is whole; none if not in this frame.
    pieces: BTreeMap<u32, Option<Tick>>,
}

/// A crater that the storage buffer has not as a frame begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AbsentCrater {
    /// Its number in the list of features.
    pub crater: u32,
    /// When it is there; none if not in this frame.
    pub comes: Option<Tick>,
}

impl Absent {
    /// What `supply` has not brought; none if nothing is missing.
    pub(crate) fn of(grid: SquareGrid, supply: &FrameSupply) -> Option<Self> {
        let pieces: BTreeMap<_, _> =
            supply.missing.iter().map(|missing| (missing.item, missing.arrival)).collect();
        (!pieces.is_empty()).then_some(Self { grid, pieces })
    }

    /// When the last of some records comes: nothing if all are there as the frame begins, and no tick if one does not come in this
    /// frame.
    pub(crate) fn last_of(&self, records: impl Iterator<Item = u32>) -> Option<Option<Tick>> {
        let lacking = records.filter_map(|record| self.pieces.get(&record).copied());
        lacking.reduce(|all, one| all.zip(one).map(|(all, one)| all.max(one)))
    }

    /// The same of the square of a place (north, east; m).
    pub fn comes(&self, anchor: [f64; 2]) -> Option<Option<Tick>> {
        self.pieces.get(&self.grid.square_of(anchor)).copied()
    }

    /// Whether the square of a place is not in the buffer by `tick`.
    pub fn lacks(&self, anchor: [f64; 2], tick: Tick) -> bool {
        self.comes(anchor).is_some_and(|comes| comes.is_none_or(|comes| comes > tick))
    }

    /// Ticks at which anything comes, ascending, each once.
    pub fn arrivals(&self) -> Vec<Tick> {
        let mut arrivals: Vec<Tick> = self.pieces.values().flatten().copied().collect();
        arrivals.sort_unstable();
        arrivals.dedup();
        arrivals
    }
}
