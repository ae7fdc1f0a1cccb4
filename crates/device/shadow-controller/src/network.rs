//! Sorting words in columns, side by side: a network of comparators asks nothing that could be guessed wrong.

use fearless_simd::prelude::SimdBase;
use fearless_simd::{Simd, u64x8};
use signal::LANES;

/// A word of each column.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub(crate) struct Row(pub(crate) [u64; LANES]);

/// Rows that are sorted where they are loaded to.
pub(crate) const BLOCK: usize = 8;

/// Batcher's network for eight.
const EIGHT: [[usize; 2]; 19] = [
    [0, 1],
    [2, 3],
    [4, 5],
    [6, 7],
    [0, 2],
    [1, 3],
    [4, 6],
    [5, 7],
    [1, 2],
    [5, 6],
    [0, 4],
    [1, 5],
    [2, 6],
    [3, 7],
    [2, 4],
    [3, 5],
    [1, 2],
    [3, 4],
    [5, 6],
];

/// Sorts each column of `rows`, whole blocks of them.
#[inline(always)]
pub(crate) fn sort_columns<V: Simd>(simd: V, rows: &mut [Row]) {
    for block in rows.chunks_exact_mut(BLOCK) {
        sort_block(simd, block);
    }
    let mut sorted = BLOCK;
    while sorted < rows.len() {
        merge(simd, rows, sorted);
        sorted *= 2;
    }
}

#[inline(always)]
fn sort_block<V: Simd>(simd: V, block: &mut [Row]) {
    let mut rows = [u64x8::splat(simd, 0); BLOCK];
    for n in 0..BLOCK {
        rows[n] = u64x8::load_array_ref(simd, &block[n].0);
    }
    for &[a, b] in &EIGHT {
        (rows[a], rows[b]) = (rows[a].min(rows[b]), rows[a].max(rows[b]));
    }
    for n in 0..BLOCK {
        rows[n].store_array(&mut block[n].0);
    }
}

/// Merges rows of which so many are `sorted`, two times as many each time (Batcher's odd-even merge).
#[inline(always)]
fn merge<V: Simd>(simd: V, rows: &mut [Row], sorted: usize) {
    let mut apart = sorted;
    while apart > 0 {
        let first = apart % sorted;
        for begin in (first..rows.len().saturating_sub(apart)).step_by(2 * apart) {
            // Those behind the last of a merge are the next one's.
            if !(begin + apart).is_multiple_of(2 * sorted) {
                compare_apart(simd, &mut rows[begin..], apart);
            }
        }
        apart /= 2;
    }
}

/// The lesser of two words go to the first `apart` rows, the greater to those behind them, as far as there are any.
#[inline(always)]
fn compare_apart<V: Simd>(simd: V, rows: &mut [Row], apart: usize) {
    let (low, high) = rows.split_at_mut(apart);
    for (low, high) in low.iter_mut().zip(high) {
        let [a, b] = [&*low, high].map(|row| u64x8::load_array_ref(simd, &row.0));
        a.min(b).store_array(&mut low.0);
        a.max(b).store_array(&mut high.0);
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};
    use proptest::prelude::{any, prop_assert_eq, proptest};
    use signal::LANES;

    use super::{BLOCK, Row, sort_columns};

    proptest! {
        /// Any words, equal ones among them, in any number of blocks.
        #[test]
        fn columns_are_sorted(
            blocks in 0..20usize,
            words in proptest::collection::vec((any::<bool>(), any::<u64>()), 20 * BLOCK * LANES),
        ) {
            let word = |n: usize| { let (few, word) = words[n]; if few { word % 9 } else { word } };
            let mut rows: Vec<Row> = (0..blocks * BLOCK)
                .map(|row| Row(std::array::from_fn(|lane| word(row * LANES + lane))))
                .collect();
            let column = |rows: &[Row], lane: usize| rows.iter().map(|row| row.0[lane]).collect::<Vec<_>>();
            let mut expected: Vec<_> = (0..LANES).map(|lane| column(&rows, lane)).collect();
            expected.iter_mut().for_each(|column| column.sort_unstable());
            dispatch!(Level::new(), simd => sort_columns(simd, &mut rows));
            for (lane, expected) in expected.iter().enumerate() {
                prop_assert_eq!(&column(&rows, lane), expected);
            }
        }
    }
}
