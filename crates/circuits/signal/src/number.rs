//! One number, or eight side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::prelude::{ExtractToken, Select, SimdBase, SimdFloat, SimdFrom};
use fearless_simd::{Simd, f32x8, f64x8};

use crate::LANES;

/// One number, or eight side by side in vectors. A law that is written over it gives eight places what it gives one, to the bit:
/// nothing is fused and no sum takes another order.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// `value` rounded to this precision, side by side as often as this number is.
    fn like(self, value: f64) -> Self;
    /// Square root.
    fn root(self) -> Self;
    /// The larger; `other` if `self` is NaN (one instruction, unlike the library's `max`).
    fn at_least(self, other: Self) -> Self;
}

macro_rules! number {
    ($scalar:ty, $vector:ident) => {
        impl Number for $scalar {
            #[inline(always)]
            fn like(self, value: f64) -> Self {
                value as $scalar
            }
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn at_least(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
        }

        impl<L: Simd> Number for $vector<L> {
            #[inline(always)]
            fn like(self, value: f64) -> Self {
                Self::simd_from(self.token(), value as $scalar)
            }
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn at_least(self, other: Self) -> Self {
                self.simd_gt(other).select(self, other)
            }
        }
    };
}

number!(f32, f32x8);
number!(f64, f64x8);

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
