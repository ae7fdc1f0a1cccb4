//! How the corners of a level lie in records.

use hardware_model::Drum;
use landscape::WORDS;

/// Squares of corners as records, row by row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Corners of the level to the east.
    columns: u32,
    /// Corners along the side of a record.
    side: u32,
    /// Records to the east.
    records_east: u32,
    /// Words of a record, on the drum and in the buffer.
    pub(crate) words: u32,
}

impl Layout {
    /// The largest squares that records of the drum hold, over a level of `corners` (north, east).
    pub(crate) fn new(drum: &Drum, corners: [usize; 2]) -> Self {
        let words = drum.record_words.max(WORDS as u32);
        let side = (words / WORDS as u32).isqrt();
        let columns = corners[1].clamp(1, u32::MAX as usize) as u32;
        Self { columns, side, records_east: columns.div_ceil(side), words }
    }

    /// The record that holds a corner.
    pub(crate) fn record_of(&self, corner: u32) -> u32 {
        let (north, east) = (corner / self.columns, corner % self.columns);
        north / self.side * self.records_east + east / self.side
    }
}

#[cfg(test)]
mod tests {
    use super::Layout;
    use hardware_model::{Drum, DrumQueue};
    use std::collections::BTreeMap;

    fn layout(record_words: u32, corners: [usize; 2]) -> Layout {
        let drum = Drum { rotation: 100, word: 1.0, record_words, queue: DrumQueue::Fifo, count: 1 };
        Layout::new(&drum, corners)
    }

    #[test]
    fn single_corners_are_records() {
        let layout = layout(9, [5, 7]);
        assert!((0..35).all(|corner| layout.record_of(corner) == corner));
    }

    #[test]
    fn squares_hold_n_by_n_corners_and_fewer_at_the_edge() {
        let layout = layout(9 * 16, [10, 9]);
        let mut held = BTreeMap::<u32, u32>::new();
        for corner in 0..90 {
            *held.entry(layout.record_of(corner)).or_default() += 1;
        }
        assert_eq!(held.into_values().collect::<Vec<_>>(), [16, 16, 4, 16, 16, 4, 8, 8, 2]);
        assert_eq!(layout.record_of(3 * 9 + 3), 0);
        assert_eq!(layout.record_of(4 * 9 + 3), 3);
    }

    #[test]
    fn a_record_larger_than_the_level_holds_all_of_it() {
        let layout = layout(9 * 64 * 64, [5, 7]);
        assert!((0..35).all(|corner| layout.record_of(corner) == 0));
    }

    #[test]
    fn words_that_fill_no_square_are_carried_along() {
        assert_eq!(layout(9 * 4 + 35, [6, 6]).side, 2);
        assert_eq!(layout(0, [6, 6]).side, 1);
    }
}
