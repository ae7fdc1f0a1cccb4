//! Whole numbers within f64, by additions alone: a group needs no conversions, which not every processor has in vectors.

/// Added to a whole number from 0 on and below it, this leaves that number in the lowest bits of the mantissa.
pub(crate) const WHOLE: f64 = (1_u64 << 52) as f64;

/// The whole number at or below `value`, of either sign and below 2^51; beyond, one of its size.
#[inline(always)]
pub(crate) fn whole(value: f64) -> f64 {
    let nearest = (value + 1.5 * WHOLE) - 1.5 * WHOLE;
    if nearest > value { nearest - 1.0 } else { nearest }
}

/// A whole number from 0 to 2^32 as an index.
#[inline(always)]
pub(crate) fn index(whole: f64) -> usize {
    (whole + WHOLE).to_bits() as u32 as usize
}

#[cfg(test)]
mod tests {
    use super::{index, whole};

    #[test]
    fn as_the_library_has_it() {
        for k in -4000..4000 {
            for off in [0.0, 1e-9, 0.25, 0.5, 0.75, 1.0 - 1e-9] {
                let value = f64::from(k) * 1e5 + off;
                assert_eq!(whole(value), value.floor(), "{value}");
            }
        }
        assert!([0, 1, 77, u32::MAX].iter().all(|&n| index(f64::from(n)) == n as usize));
    }
}
