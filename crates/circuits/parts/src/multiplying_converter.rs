//! Multiplying D/A converter: a coefficient word times an analog signal.
//!
//! ```text
//! signal u ──────────────▶ × ─▶ lag ─▶ y
//! register N, b bits ────▶ ┘
//! ```
//!
//! **Law** (sections 3.5 and 6). `y = (1 + e) N lsb u`, then a lag ([`crate::LagStep`]; across a switching instant
//! [`crate::SplitLag`] with both coefficients times the signal there), plus feedthrough ([`crate::Feedthrough`]).
//! `lsb = F / 2^(b-1)`: b counts the sign, F is the full scale of the coefficient. N acts from the switching time
//! after its strobe on ([`MultiplyingConverter::acts_at`]); bits that switch apart make a pulse of area
//! `A_g 2^(k - b) u` ([`MultiplyingConverter::carry`]).
//! **State and timing.** None of its own.
//! **Our choices.** Nearest word; beyond full scale the end words. Carries are those of offset binary, whose major
//! carry is the change of sign.

use quantities::SweepTime;

use crate::converter::carry_weight;
use crate::delay::Delay;
use crate::whole::whole;

/// Words of a converter and what they stand for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultiplyingConverter {
    bits: u32,
    /// Words of either sign.
    half: f64,
    lsb: f64,
    gain: f64,
    switching: Delay,
}

impl MultiplyingConverter {
    /// `bits` with sign, 1..=24 (held within); `full_scale` of the coefficient in its own unit; `gain_error` a share;
    /// the step `h` and the time `switching` from strobe to effect in seconds.
    pub fn new(h: f64, bits: u32, full_scale: f64, gain_error: f64, switching: f64) -> Self {
        let bits = bits.clamp(1, 24);
        let half = f64::from(1_u32 << (bits - 1));
        let lsb = full_scale / half;
        Self { bits, half, lsb, gain: 1.0 + gain_error, switching: Delay::new(h, switching) }
    }

    /// The word for `coefficient`.
    #[inline]
    pub fn word(&self, coefficient: f64) -> i32 {
        let steps = if self.lsb == 0.0 { 0.0 } else { coefficient / self.lsb };
        whole(steps + 0.5).clamp(-self.half, self.half - 1.0) as i32
    }

    /// What `word` multiplies by, gain error included.
    #[inline]
    pub fn coefficient(&self, word: i32) -> f64 {
        self.gain * (f64::from(word) * self.lsb)
    }

    /// What a register loaded with `coefficient` multiplies by.
    pub fn quantised(&self, coefficient: f64) -> f64 {
        self.coefficient(self.word(coefficient))
    }

    /// When a word strobed at `strobe` acts.
    pub fn acts_at(&self, strobe: SweepTime) -> SweepTime {
        self.switching.after(strobe)
    }

    /// Share of the major carry's pulse at a change of word: `2^(k - b)`, 0 without a change.
    #[inline]
    pub fn carry(&self, from: i32, to: i32) -> f64 {
        let offset = |word: i32| (word + self.half as i32) as u32;
        carry_weight(offset(from), offset(to), self.bits)
    }
}

#[cfg(test)]
mod tests {
    use quantities::SweepTime;

    use super::MultiplyingConverter;

    #[test]
    fn words_and_their_coefficients() {
        let converter = MultiplyingConverter::new(50e-9, 12, 4.0, 0.0, 80e-9);
        let lsb = 4.0 / 2048.0;
        for i in -1000..1000 {
            let c = f64::from(i) * 0.003_97;
            assert!((converter.quantised(c) - c).abs() <= lsb / 2.0 + 1e-15, "{c}");
        }
        assert_eq!(converter.word(9.0), 2047);
        assert_eq!(converter.word(-9.0), -2048);
        assert_eq!(converter.coefficient(-2048), -4.0);
        assert_eq!(converter.acts_at(SweepTime(2.0)), SweepTime(3.6));
    }

    #[test]
    fn gain_error_acts_on_the_coefficient() {
        let converter = MultiplyingConverter::new(50e-9, 12, 1.0, 0.02, 0.0);
        assert!((converter.quantised(0.5) - 0.51).abs() < 1e-15);
    }

    #[test]
    fn the_major_carry_is_the_change_of_sign() {
        let converter = MultiplyingConverter::new(50e-9, 12, 1.0, 0.0, 0.0);
        assert_eq!(converter.carry(-1, 0), 1.0);
        assert_eq!(converter.carry(4, 5), 2.0 / 4096.0);
        assert_eq!(converter.carry(5, 5), 0.0);
    }

    #[test]
    fn one_bit_and_no_scale() {
        let sign = MultiplyingConverter::new(50e-9, 1, 1.0, 0.0, 0.0);
        assert_eq!((sign.quantised(0.7), sign.quantised(-0.7)), (0.0, -1.0));
        assert_eq!(MultiplyingConverter::new(50e-9, 12, 0.0, 0.0, 0.0).quantised(0.7), 0.0);
    }
}
