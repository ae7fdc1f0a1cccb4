//! Randomness by position: a hash of seed and coordinates, never a stream, so that order and threads
//! cannot change it.

/// 64 well-mixed bits of `seed` and `words` (the finaliser of SplitMix64, applied word by word).
///
/// The values never change between versions: landscapes and noise are named by their seed.
pub fn hash_words(seed: u64, words: &[u64]) -> u64 {
    words.iter().fold(mix(seed), |state, &word| hash_on(state, word))
}

/// The hash of one word more, from that of the words before it ([`hash_words`]).
#[inline]
pub fn hash_on(state: u64, word: u64) -> u64 {
    mix(state ^ mix(word.wrapping_add(GOLDEN)))
}

/// A number in `[0, 1)` with 53 random bits, of `seed` and `words`.
pub fn unit_interval(seed: u64, words: &[u64]) -> f64 {
    (hash_words(seed, words) >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
}

/// Odd constant nearest to 2^64 over the golden ratio: spreads small integers over all bits.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// One step of SplitMix64: adds the golden constant to `word`, then mixes all 64 bits (Steele, Lea and Flood).
#[inline]
pub fn mix(word: u64) -> u64 {
    let word = word.wrapping_add(GOLDEN);
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}

#[cfg(test)]
mod tests {
    use super::{hash_words, mix, unit_interval};

    #[test]
    fn first_outputs_of_splitmix64() {
        // Published stream of SplitMix64 from state 0: successive increments of the golden constant.
        assert_eq!(mix(0), 0xe220_a839_7b1d_cdaf);
        assert_eq!(mix(super::GOLDEN), 0x6e78_9e6a_a1b9_65f4);
    }

    #[test]
    fn mean_and_variance_of_the_unit_interval() {
        let n = 20_000;
        let values: Vec<f64> = (0..n).map(|i| unit_interval(7, &[i])).collect();
        let mean = values.iter().sum::<f64>() / n as f64;
        let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n as f64;
        assert!((mean - 0.5).abs() < 0.01, "mean {mean}");
        assert!((variance - 1.0 / 12.0).abs() < 0.003, "variance {variance}");
    }

    #[test]
    fn every_word_counts() {
        let base = hash_words(1, &[2, 3]);
        assert_ne!(base, hash_words(1, &[3, 2]));
        assert_ne!(base, hash_words(2, &[2, 3]));
        assert_ne!(base, hash_words(1, &[2, 3, 0]));
    }
}
