//! How a sample of a PDS3 image is stored.

use super::statements::{IMAGE, Label};
use crate::error::SurveyError;

/// How a sample is stored.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// Bytes of a sample: 1, 2, 4 or 8.
    pub bytes: usize,
    /// Whether samples are IEEE floats.
    pub real: bool,
    signed: bool,
    little: bool,
}

impl Kind {
    /// From the keywords SAMPLE_TYPE, SAMPLE_BITS and SAMPLE_BIT_MASK.
    pub fn of(label: &Label) -> Result<Self, SurveyError> {
        let kind = label.find(IMAGE, "SAMPLE_TYPE").ok_or_else(|| label.missing("SAMPLE_TYPE"))?;
        let bits = label.count(IMAGE, "SAMPLE_BITS")?.ok_or_else(|| label.missing("SAMPLE_BITS"))?;
        let name = label.text(IMAGE, "SAMPLE_TYPE")?.unwrap_or_default().to_ascii_uppercase();
        let base = name.replacen("UNSIGNED_", "", 1);
        let signed = base == name;
        let (real, little) = match base.as_str() {
            "PC_REAL" if signed => (true, true),
            "IEEE_REAL" | "REAL" | "FLOAT" | "MAC_REAL" | "SUN_REAL" if signed => (true, false),
            "LSB_INTEGER" | "PC_INTEGER" | "VAX_INTEGER" => (false, true),
            "INTEGER" | "MSB_INTEGER" | "MAC_INTEGER" | "SUN_INTEGER" => (false, false),
            _ => {
                let expected = "LSB_INTEGER, MSB_INTEGER (also unsigned), PC_REAL or IEEE_REAL";
                return Err(label.wrong(kind, expected));
            }
        };
        let fits = if real { [32, 64].contains(&bits) } else { [8, 16, 32].contains(&bits) };
        if !fits {
            let statement = label.find(IMAGE, "SAMPLE_BITS").unwrap_or(kind);
            return Err(label.wrong(statement, "8, 16 or 32 for integers, 32 or 64 for reals"));
        }
        let kind = Self { bytes: bits as usize / 8, real, signed, little };
        kind.check_mask(label)?;
        Ok(kind)
    }

    /// A mask must let all bits through: what other bits hold is not said.
    fn check_mask(self, label: &Label) -> Result<(), SurveyError> {
        let Some(mask) = label.text(IMAGE, "SAMPLE_BIT_MASK")? else { return Ok(()) };
        let all = u64::MAX >> (64 - 8 * self.bytes);
        match label.find(IMAGE, "SAMPLE_BIT_MASK") {
            Some(statement) if in_base(mask).or_else(|| mask.parse().ok()) != Some(all) => {
                Err(label.wrong(statement, &format!("2#{}#, all bits", "1".repeat(8 * self.bytes))))
            }
            _ => Ok(()),
        }
    }

    /// The number that the bytes of a sample hold.
    pub fn number(self, bytes: &[u8]) -> f64 {
        let mut word = [0; 8];
        for (index, &byte) in bytes.iter().enumerate() {
            word[if self.little { index } else { bytes.len() - 1 - index }] = byte;
        }
        self.number_of_bits(u64::from_le_bytes(word))
    }

    /// The number that a word of this kind with these bits holds.
    pub fn number_of_bits(self, bits: u64) -> f64 {
        match (self.real, self.bytes, self.signed) {
            (true, 4, _) => f64::from(f32::from_bits(bits as u32)),
            (true, _, _) => f64::from_bits(bits),
            (false, 1, true) => f64::from(bits as u8 as i8),
            (false, 2, true) => f64::from(bits as u16 as i16),
            (false, _, true) => f64::from(bits as u32 as i32),
            (false, _, false) => bits as f64,
        }
    }

    /// Whether a sample of this kind can hold a number.
    pub fn can_hold(self, number: f64) -> bool {
        let values = libm::exp2((8 * self.bytes) as f64);
        let low = if self.signed { -0.5 * values } else { 0.0 };
        self.real || number.fract() == 0.0 && (low..low + values).contains(&number)
    }
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
        let kind = |bytes, signed| Kind { bytes, real: false, signed, little: true };
        assert!(kind(2, true).can_hold(-32768.0) && !kind(2, false).can_hold(-32768.0));
        assert!(kind(1, false).can_hold(255.0) && !kind(1, false).can_hold(256.0));
        assert!(!kind(4, true).can_hold(0.5));
    }
}
