//! Sorting words in vectors: a network of comparators asks nothing that could be guessed wrong.

use fearless_simd::prelude::SimdBase;
use fearless_simd::{Level, Simd, dispatch, u64x8};
use signal::{LANES, turn_square};

/// Words that are sorted in as many vectors as each has lanes.
const BLOCK: usize = LANES * LANES;

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

/// Sorts `words`.
pub(crate) fn sort_words(words: &mut Vec<u64>) {
    let count = words.len();
    // What is added goes to the end.
    words.resize(count.next_power_of_two().max(BLOCK), u64::MAX);
    dispatch!(Level::new(), simd => sort_blocks(simd, words));
    words.truncate(count);
}

#[inline(always)]
fn sort_blocks<V: Simd>(simd: V, words: &mut [u64]) {
    for block in words.chunks_exact_mut(BLOCK) {
        let mut rows = [u64x8::splat(simd, 0); LANES];
        load(simd, block, &mut rows);
        sort_rows(&mut rows);
        store(&rows, block);
    }
    let mut sorted = BLOCK;
    while sorted < words.len() {
        sorted *= 2;
        words.chunks_exact_mut(sorted).for_each(|both| merge(simd, both));
    }
}

/// Sorts a block: columns first, which turned are rows, then rows two by two.
#[inline(always)]
fn sort_rows<V: Simd>(rows: &mut [u64x8<V>; LANES]) {
    for [a, b] in EIGHT {
        compare(rows, a, b);
    }
    turn_square(rows);
    merge_rows::<V, 1>(rows);
    merge_rows::<V, 2>(rows);
    merge_rows::<V, 4>(rows);
}

/// Merges rows, of which so many times `SORTED` are sorted (bitonic).
#[inline(always)]
fn merge_rows<V: Simd, const SORTED: usize>(rows: &mut [u64x8<V>; LANES]) {
    for n in 0..LANES {
        if n & SORTED == 0 {
            compare_turned(rows, n, n ^ (2 * SORTED - 1));
        }
    }
    clean::<V, SORTED>(rows);
    clean_lanes(rows);
}

/// Merges the sorted halves of `words`, each of some blocks (bitonic).
#[inline(always)]
fn merge<V: Simd>(simd: V, words: &mut [u64]) {
    let rows = words.len() / LANES;
    for n in 0..rows / 2 {
        with_two(simd, words, [n, rows - 1 - n], |pair| compare_turned(pair, 0, 1));
    }
    let mut apart = rows / 4;
    while apart >= LANES {
        for n in (0..rows).filter(|n| n & apart == 0) {
            with_two(simd, words, [n, n + apart], |pair| compare(pair, 0, 1));
        }
        apart /= 2;
    }
    for block in words.chunks_exact_mut(BLOCK) {
        let mut rows = [u64x8::splat(simd, 0); LANES];
        load(simd, block, &mut rows);
        clean::<V, LANES>(&mut rows);
        clean_lanes(&mut rows);
        store(&rows, block);
    }
}

/// The lesser of two rows, lane by lane, goes to the first place.
#[inline(always)]
fn compare<V: Simd>(rows: &mut [u64x8<V>], a: usize, b: usize) {
    (rows[a], rows[b]) = (rows[a].min(rows[b]), rows[a].max(rows[b]));
}

/// The same with the second row the other way round.
#[inline(always)]
fn compare_turned<V: Simd>(rows: &mut [u64x8<V>], a: usize, b: usize) {
    rows[b] = rows[b].reverse();
    compare(rows, a, b);
    rows[b] = rows[b].reverse();
}

/// Brings bitonic rows, so many times `COUNT` of them, into order but for their lanes.
#[inline(always)]
fn clean<V: Simd, const COUNT: usize>(rows: &mut [u64x8<V>; LANES]) {
    for apart in [4, 2, 1] {
        for n in 0..LANES {
            if apart < COUNT && n & apart == 0 {
                compare(rows, n, n + apart);
            }
        }
    }
}

/// Brings the lanes of bitonic rows into order.
#[inline(always)]
fn clean_lanes<V: Simd>(rows: &mut [u64x8<V>; LANES]) {
    turn_square(rows);
    clean::<V, LANES>(rows);
    turn_square(rows);
}

#[inline(always)]
fn with_two<V: Simd>(simd: V, words: &mut [u64], at: [usize; 2], act: impl FnOnce(&mut [u64x8<V>])) {
    let place = |row: usize| LANES * row..LANES * (row + 1);
    let mut pair = at.map(|row| u64x8::from_slice(simd, &words[place(row)]));
    act(&mut pair);
    for (row, value) in at.into_iter().zip(pair) {
        value.store_slice(&mut words[place(row)]);
    }
}

#[inline(always)]
fn load<V: Simd>(simd: V, block: &[u64], rows: &mut [u64x8<V>; LANES]) {
    for (row, words) in rows.iter_mut().zip(block.chunks_exact(LANES)) {
        *row = u64x8::from_slice(simd, words);
    }
}

#[inline(always)]
fn store<V: Simd>(rows: &[u64x8<V>; LANES], block: &mut [u64]) {
    for (row, words) in rows.iter().zip(block.chunks_exact_mut(LANES)) {
        row.store_slice(words);
    }
}

#[cfg(test)]
mod tests {
    use super::sort_words;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    proptest! {
        /// Any words, equal ones among them, in any number from none to some blocks.
        #[test]
        fn words_are_sorted(words in proptest::collection::vec((any::<bool>(), any::<u64>()), 0..700)) {
            let words: Vec<u64> = words.into_iter().map(|(few, word)| if few { word % 9 } else { word }).collect();
            let mut expected = words.clone();
            expected.sort_unstable();
            let mut sorted = words;
            sort_words(&mut sorted);
            prop_assert_eq!(sorted, expected);
        }
    }
}
