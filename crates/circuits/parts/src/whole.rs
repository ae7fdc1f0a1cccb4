//! Whole numbers within f64, by additions alone: a group needs no conversions, which not every processor has in vectors.

use fearless_simd::prelude::{Select, SimdBase};
use fearless_simd::{Simd, f64x8};

/// Added to a whole number from 0 on and below it, this leaves that number in the lowest bits of the mantissa.
pub(crate) const WHOLE: f64 = (1_u64 << 52) as f64;

/// The whole number at or below `value`, of either sign and below 2^51; beyond, one of its size.
#[inline(always)]
pub(crate) fn whole(value: f64) -> f64 {
    let nearest = (value + 1.5 * WHOLE) - 1.5 * WHOLE;
    if nearest > value { nearest - 1.0 } else { nearest }
}

/// The same of eight.
#[inline(always)]
pub(crate) fn whole_side_by_side<L: Simd>(value: f64x8<L>) -> f64x8<L> {
    let nearest = (value + 1.5 * WHOLE) - 1.5 * WHOLE;
    nearest.simd_gt(value).select(nearest - 1.0, nearest)
}

#[cfg(test)]
mod tests {
    use fearless_simd::prelude::SimdBase;
    use fearless_simd::{Level, dispatch, f64x8};

    use super::{whole, whole_side_by_side};

    #[test]
    fn as_the_library_has_it() {
        for k in -4000..4000 {
            for off in [0.0, 1e-9, 0.25, 0.5, 0.75, 1.0 - 1e-9] {
                let value = f64::from(k) * 1e5 + off;
                assert_eq!(whole(value), value.floor(), "{value}");
                let eight = dispatch!(Level::new(), simd => whole_side_by_side(f64x8::splat(simd, value))[3]);
                assert_eq!(eight, value.floor(), "{value}");
            }
        }
    }
}
