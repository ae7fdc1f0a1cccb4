//! Words of a digital memory.

/// The A/D converter of a digital memory: it rounds what is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Words {
    /// Intensity of the greatest word.
    full_scale: f32,
    /// The greatest word, all of whose bits are set.
    top: f32,
}

impl Words {
    /// Words of so many `bits`, 1 to 24. The greatest word is the intensity `full_scale`.
    pub fn new(bits: u32, full_scale: f64) -> Self {
        Self { full_scale: full_scale as f32, top: ((1_u32 << bits) - 1) as f32 }
    }

    /// Puts the nearest word in place of each intensity; beyond full scale the greatest, below black 0.
    pub fn store(&self, cells: &mut [f32]) {
        for cell in cells {
            let share = (*cell / self.full_scale).clamp(0.0, 1.0);
            *cell = (share * self.top).round_ties_even() / self.top * self.full_scale;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Words;

    /// Three bits over a white of 0.7 are steps of 0.1.
    #[test]
    fn cells_have_the_nearest_of_so_many_levels() {
        let mut cells = [0.0, 0.049, 0.051, 0.34, 0.36, 0.7, 0.9, -0.2];
        Words::new(3, 0.7).store(&mut cells);
        for (cell, level) in cells.into_iter().zip([0.0, 0.0, 0.1, 0.3, 0.4, 0.7, 0.7, 0.0]) {
            assert!((cell - level).abs() < 1e-6, "{cell} {level}");
        }
    }

    /// A word is within half a step, and is stored as itself, for any number of bits.
    #[test]
    fn words_are_near_and_stay() {
        for bits in 1..=24 {
            let words = Words::new(bits, 1.5);
            let step = 1.5 / f64::from((1_u32 << bits) - 1);
            for k in 0..=1000_u16 {
                let cell = 1.5 * f32::from(k) / 1000.0;
                let mut once = [cell];
                words.store(&mut once);
                assert!(
                    f64::from((once[0] - cell).abs()) <= 0.5 * step + 2e-7,
                    "{bits} bits: {cell} {}",
                    once[0]
                );
                let mut twice = once;
                words.store(&mut twice);
                assert!(f64::from((twice[0] - once[0]).abs()) <= 2e-7, "{bits} bits");
            }
        }
    }
}
