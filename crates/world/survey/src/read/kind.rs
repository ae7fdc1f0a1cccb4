//! How a sample of a raw file is stored.

/// How a sample is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kind {
    /// Bytes of a sample: 1, 2, 4 or 8.
    pub bytes: usize,
    /// Whether samples are IEEE floats.
    pub real: bool,
    /// Whether integers have a sign.
    pub signed: bool,
    /// Whether the lowest byte stands first.
    pub little: bool,
}

/// Kinds of stored numbers that matter for what they mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stored {
    /// Whole numbers of 8 bits or fewer, as pictures have them.
    Byte,
    /// Floats of 32 bits: marks of voids are compared as those.
    F32,
    /// Numbers of all other kinds.
    #[default]
    Other,
}

impl Stored {
    /// Of samples of so many bits, which are floats or not.
    pub fn of(bits: u32, is_real: bool) -> Self {
        match bits {
            32 if is_real => Self::F32,
            ..=8 if !is_real => Self::Byte,
            _ => Self::Other,
        }
    }
}

impl Kind {
    /// Floats of so many bytes.
    pub const fn real(bytes: usize, little: bool) -> Self {
        Self { bytes, real: true, signed: true, little }
    }

    /// Integers of so many bytes.
    pub const fn integer(bytes: usize, signed: bool, little: bool) -> Self {
        Self { bytes, real: false, signed, little }
    }

    /// The kind as far as it matters for what the numbers mean.
    pub fn stored(self) -> Stored {
        Stored::of(8 * self.bytes as u32, self.real)
    }

    /// The number that the bytes of a sample hold.
    pub fn number(self, bytes: &[u8]) -> f64 {
        let mut word = [0; 8];
        for (index, &byte) in bytes.iter().enumerate() {
            word[if self.little { index } else { bytes.len() - 1 - index }] = byte;
        }
        self.number_of_bits(u64::from_le_bytes(word))
    }

    /// The number that a word of this kind with these bits holds; integers beyond 2^53 are rounded, which no height is.
    pub fn number_of_bits(self, bits: u64) -> f64 {
        match (self.real, self.bytes, self.signed) {
            (true, 4, _) => f64::from(f32::from_bits(bits as u32)),
            (true, _, _) => f64::from_bits(bits),
            (false, 1, true) => f64::from(bits as u8 as i8),
            (false, 2, true) => f64::from(bits as u16 as i16),
            (false, 4, true) => f64::from(bits as u32 as i32),
            (false, _, true) => bits as i64 as f64,
            (false, _, false) => bits as f64,
        }
    }

    /// Whether a sample of this kind can hold a number.
    pub fn can_hold(self, number: f64) -> bool {
        self.real || integer_can_hold(8 * self.bytes as u32, self.signed, number)
    }
}

/// Whether an integer of so many bits can hold a number.
pub fn integer_can_hold(bits: u32, is_signed: bool, number: f64) -> bool {
    let values = libm::exp2(f64::from(bits));
    let low = if is_signed { -0.5 * values } else { 0.0 };
    number.fract() == 0.0 && (low..low + values).contains(&number)
}

/// A number that names its base: `16#FF7FFFFB#`, `2#1010#`.
pub fn in_base(text: &str) -> Option<u64> {
    let (base, digits) = text.split_once('#')?;
    let base = base.trim().parse().ok().filter(|base| (2..=16).contains(base))?;
    u64::from_str_radix(digits.strip_suffix('#')?.trim(), base).ok()
}

#[cfg(test)]
mod tests {
    use super::{Kind, in_base};

    #[test]
    fn bases_are_named() {
        assert_eq!(in_base("16#FF7FFFFB#"), Some(0xff7f_fffb));
        assert_eq!(in_base("2#1010#"), Some(10));
        for text in ["16#XY#", "99#1#", "16#1", "12", "#1#"] {
            assert_eq!(in_base(text), None, "{text}");
        }
    }

    #[test]
    fn kinds_hold_what_fits() {
        let kind = |bytes, signed| Kind::integer(bytes, signed, true);
        assert!(kind(2, true).can_hold(-32768.0) && !kind(2, false).can_hold(-32768.0));
        assert!(kind(1, false).can_hold(255.0) && !kind(1, false).can_hold(256.0));
        assert!(!kind(4, true).can_hold(0.5));
    }

    #[test]
    fn bytes_are_numbers_in_either_order() {
        let bytes = [0xff, 0xfe, 0, 0, 0, 0, 0, 1];
        for (kind, expected) in [
            (Kind::integer(1, true, true), -1.0),
            (Kind::integer(2, true, false), -2.0),
            (Kind::integer(2, false, true), 65_279.0),
            (Kind::integer(4, true, false), -131_072.0),
            (Kind::integer(8, true, true), 72_057_594_037_993_215.0),
            (Kind::integer(8, true, false), -562_949_953_421_311.0),
            (Kind::integer(8, false, false), 18_446_181_123_756_130_304.0),
        ] {
            assert_eq!(kind.number(&bytes[..kind.bytes]), expected, "{kind:?}");
        }
        assert_eq!(Kind::real(4, false).number(&[0x3f, 0x80, 0, 0]), 1.0);
        assert_eq!(Kind::real(8, true).number(&1.5_f64.to_le_bytes()), 1.5);
    }
}
