//! Whole numbers, in as many bits each as the largest takes: squares hold twice as many craters as there are.

use std::ops::Range;

/// Any number of numbers.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    /// Bits of one after those of the other, the least first; at the end so much more that each can be read as a whole word.
    bytes: Vec<u8>,
    /// Number of bits of each number.
    width: usize,
    count: usize,
}

/// A word holds any number, wherever in its first byte it begins.
const WORD: usize = size_of::<u64>();

impl Numbers {
    /// `count` times 0, with room for numbers up to `largest`.
    pub(crate) fn new(count: usize, largest: u32) -> Self {
        let width = (u32::BITS - largest.leading_zeros()) as usize;
        Self { bytes: vec![0; (count * width).div_ceil(8) + WORD], width, count }
    }

    /// The same as `numbers`.
    pub(crate) fn like(numbers: &[u32]) -> Self {
        let mut all = Self::new(numbers.len(), numbers.iter().copied().max().unwrap_or(0));
        numbers.iter().enumerate().for_each(|(at, &number)| all.set(at, number));
        all
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// Number `at` becomes `number`, which is not larger than the largest.
    pub(crate) fn set(&mut self, at: usize, number: u32) {
        let (first, shift) = self.place(at);
        let word = self.word(first) & !(self.mask() << shift) | u64::from(number) << shift;
        self.bytes[first..first + WORD].copy_from_slice(&word.to_le_bytes());
    }

    /// Returns the number at place `at`, counted from 0.
    #[inline]
    pub(crate) fn get(&self, at: usize) -> u32 {
        let (first, shift) = self.place(at);
        (self.word(first) >> shift & self.mask()) as u32
    }

    /// Those at some places.
    #[inline]
    pub(crate) fn of(&self, places: Range<usize>) -> impl Iterator<Item = u32> {
        places.map(|at| self.get(at))
    }

    /// Byte in which number `at` begins, and bit of it.
    #[inline]
    fn place(&self, at: usize) -> (usize, usize) {
        let bit = at * self.width;
        (bit / 8, bit % 8)
    }

    #[inline]
    fn word(&self, first: usize) -> u64 {
        u64::from_le_bytes(*self.bytes[first..].first_chunk().expect("room for a word behind each"))
    }

    #[inline]
    fn mask(&self) -> u64 {
        (1 << self.width) - 1
    }
}

#[cfg(test)]
mod tests {
    use super::Numbers;
    use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

    proptest! {
        /// Of any width, written in any order and written over.
        #[test]
        fn numbers_come_out_as_they_went_in(
            all in proptest::collection::vec(any::<[u32; 2]>(), 0..40),
            less in 0..=32u32,
            turn in 0..40usize,
        ) {
            let [before, all]: [Vec<u32>; 2] = [0, 1]
                .map(|k| all.iter().map(|pair| pair[k].checked_shr(less).unwrap_or(0)).collect());
            let largest = before.iter().chain(&all).copied().max().unwrap_or(0);
            let mut numbers = Numbers::new(all.len(), largest);
            before.iter().enumerate().for_each(|(at, &number)| numbers.set(at, number));
            for n in 0..all.len() {
                let at = (n + turn) % all.len();
                numbers.set(at, all[at]);
            }
            prop_assert_eq!(numbers.len(), all.len());
            for from in 0..=all.len() {
                prop_assert!(numbers.of(from..all.len()).eq(all[from..].iter().copied()));
            }
            prop_assert!(Numbers::like(&all).of(0..all.len()).eq(all));
        }
    }
}
