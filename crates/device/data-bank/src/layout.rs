//! How the data of one kind lie in records.

use crate::supply::Piece;
use landscape::WORDS;

/// What the records of a store hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contents {
    /// The corners of a level, so many to the north and to the east: a record holds a square of them.
    Corners([usize; 2]),
    /// Squares of ground, so many: the data of each are a chain of records.
    Chains(u32),
}

/// From a piece of data to its records.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Layout {
    /// Squares of corners as records, row by row.
    Corners {
        /// Corners of the level to the east.
        columns: u32,
        /// Corners along the side of a record.
        side: u32,
        /// Records to the east.
        records_east: u32,
    },
    /// First records of all squares, then their second ones, and so on.
    Chains {
        /// Squares of the problem area.
        squares: u32,
    },
}

impl Layout {
    /// The layout of `contents` in records of `words` words.
    pub(crate) fn new(contents: Contents, words: u32) -> Self {
        match contents {
            Contents::Corners([_, east]) => {
                let side = (words / WORDS as u32).isqrt().max(1);
                let columns = east.clamp(1, u32::MAX as usize) as u32;
                Self::Corners { columns, side, records_east: columns.div_ceil(side) }
            }
            Contents::Chains(squares) => Self::Chains { squares: squares.max(1) },
        }
    }

    /// Records of a piece, in the order in which they are wanted. A chain that runs over the last number of a record ends there.
    pub(crate) fn records_of(self, piece: Piece) -> impl Iterator<Item = u32> {
        let (first, step, count) = match self {
            Self::Corners { columns, side, records_east } => {
                let (north, east) = (piece.item / columns, piece.item % columns);
                (north / side * records_east + east / side, 1, 1)
            }
            Self::Chains { squares } => (piece.item, squares, piece.records),
        };
        (0..count).map_while(move |link| first.checked_add(link.checked_mul(step)?))
    }
}

#[cfg(test)]
mod tests {
    use super::{Contents, Layout};
    use crate::Piece;
    use std::collections::BTreeMap;

    fn record_of(record_words: u32, corners: [usize; 2]) -> impl Fn(u32) -> u32 {
        let layout = Layout::new(Contents::Corners(corners), record_words);
        move |corner| layout.records_of(Piece::one(corner)).next().unwrap()
    }

    #[test]
    fn single_corners_are_records() {
        let record_of = record_of(9, [5, 7]);
        assert!((0..35).all(|corner| record_of(corner) == corner));
    }

    #[test]
    fn squares_hold_n_by_n_corners_and_fewer_at_the_edge() {
        let record_of = record_of(9 * 16, [10, 9]);
        let mut held = BTreeMap::<u32, u32>::new();
        for corner in 0..90 {
            *held.entry(record_of(corner)).or_default() += 1;
        }
        assert_eq!(held.into_values().collect::<Vec<_>>(), [16, 16, 4, 16, 16, 4, 8, 8, 2]);
        assert_eq!(record_of(3 * 9 + 3), 0);
        assert_eq!(record_of(4 * 9 + 3), 3);
    }

    #[test]
    fn a_record_larger_than_the_level_holds_all_of_it() {
        let record_of = record_of(9 * 64 * 64, [5, 7]);
        assert!((0..35).all(|corner| record_of(corner) == 0));
    }

    #[test]
    fn words_that_fill_no_square_are_carried_along() {
        let side = |words| match Layout::new(Contents::Corners([6, 6]), words) {
            Layout::Corners { side, .. } => side,
            Layout::Chains { .. } => 0,
        };
        assert_eq!([9 * 4 + 35, 0].map(side), [2, 1]);
    }

    #[test]
    fn links_of_a_chain_lie_a_whole_bank_of_squares_apart() {
        let layout = Layout::new(Contents::Chains(100), 64);
        let chain = |item, records| layout.records_of(Piece { item, records }).collect::<Vec<_>>();
        assert_eq!(chain(7, 3), [7, 107, 207]);
        assert_eq!(chain(99, 1), [99]);
        let far = Layout::new(Contents::Chains(1 << 31), 64);
        assert_eq!(far.records_of(Piece { item: 5, records: 9 }).collect::<Vec<_>>(), [5, (1 << 31) + 5]);
    }
}
