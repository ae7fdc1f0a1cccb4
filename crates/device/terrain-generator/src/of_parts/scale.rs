//! What full scale means on each wire of the array.

use landscape::{CornerWords, Level};

/// Largest magnitudes of g00, g01, g02 over a region: 1, 16/81 at z = 1/3, 0.01728 at z = 2/5.
pub const PEAKS: [f64; 3] = [1.0, 16.0 / 81.0, 0.017_28];

/// Largest magnitudes of their derivatives: 15/8 at the middle, 1 at the end, 0.06779 at z = (8 - sqrt 24) / 20.
pub const SLOPE_PEAKS: [f64; 3] = [1.875, 1.0, 0.06778775382679628];

/// Full scales of one level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Height of the lunoid at which the height is 0 on the wire (m): the middle of the stored heights.
    pub datum: f64,
    /// Height at full scale (m): a power of two.
    pub height: f64,
    /// Slope words at full scale (m a region): a power of two.
    pub slope: f64,
}

impl Scale {
    /// The smallest full scales that hold every word of a level.
    pub fn of(level: &Level) -> Self {
        let heights = || level.words().iter().map(|words| words[0]);
        let (low, high) =
            heights().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
        let datum = 0.5 * (low + high);
        let (mut height, mut slope) = (0.0_f64, 0.0_f64);
        for words in level.words() {
            for (index, word) in words.iter().enumerate() {
                let (p, q) = (index / 3, index % 3);
                let word = if index == 0 { word - datum } else { *word };
                height = height.max(word.abs() * PEAKS[p] * PEAKS[q]);
                let steepest = (SLOPE_PEAKS[p] * PEAKS[q]).max(PEAKS[p] * SLOPE_PEAKS[q]);
                slope = slope.max(word.abs() * steepest);
            }
        }
        Self { datum, height: power_of_two(height), slope: power_of_two(slope) }
    }

    /// A word of order `index` (`3 p + q`) as a share of full scale.
    pub fn share(&self, words: &CornerWords, index: usize) -> f64 {
        let word = if index == 0 { words[0] - self.datum } else { words[index] };
        word * PEAKS[index / 3] * PEAKS[index % 3] / self.height
    }

    /// The word of order `index` that is this share of full scale.
    pub fn word(&self, share: f64, index: usize) -> f64 {
        let word = share * self.height / (PEAKS[index / 3] * PEAKS[index % 3]);
        if index == 0 { word + self.datum } else { word }
    }
}

/// The power of two at or above `value`; 1 for ground without relief.
fn power_of_two(value: f64) -> f64 {
    if value > 0.0 { libm::exp2(libm::ceil(libm::log2(value))) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::{PEAKS, SLOPE_PEAKS};
    use landscape::basis::{derivatives, values};

    #[test]
    fn peaks_are_the_largest_values() {
        let (mut peaks, mut slopes) = ([0.0_f64; 3], [0.0_f64; 3]);
        for step in 0..=1_000_000 {
            let z = f64::from(step) * 1e-6;
            for p in 0..3 {
                peaks[p] = peaks[p].max(values(z)[p].abs());
                slopes[p] = slopes[p].max(derivatives(z)[p].abs());
            }
        }
        for p in 0..3 {
            assert!(
                (peaks[p] - PEAKS[p]).abs() < 1e-9 && (slopes[p] - SLOPE_PEAKS[p]).abs() < 1e-9,
                "{p}: {peaks:?} {slopes:?}"
            );
        }
    }
}
