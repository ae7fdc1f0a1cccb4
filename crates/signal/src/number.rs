//! One number, or eight side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::prelude::{ExtractToken, SimdBase, SimdFrom};
use fearless_simd::{Simd, f64x8};

use crate::LANES;

/// One f64, or eight side by side in vectors. A law that is written over it gives eight places what it gives one, to the bit:
/// nothing is fused and no sum takes another order.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// `value`, side by side as often as this number is.
    fn like(self, value: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        value
    }
}

impl<L: Simd> Number for f64x8<L> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::simd_from(self.token(), value)
    }
}

/// Eight values as one number.
#[inline(always)]
pub fn eight<L: Simd>(simd: L, values: &[f64; LANES]) -> f64x8<L> {
    f64x8::from_slice(simd, values)
}

/// Twice eight values.
#[inline(always)]
pub fn pair<L: Simd>(simd: L, values: &[[f64; LANES]; 2]) -> [f64x8<L>; 2] {
    [eight(simd, &values[0]), eight(simd, &values[1])]
}
