//! The scalar type of the analog signals: a setting of the run.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use std::convert::identity;

use fearless_simd::prelude::{SimdCombine, SimdFloat, SimdFloatElement, SimdNarrow, SimdSplit, SimdWiden};
use fearless_simd::{Simd, f32x8, f64x8};

/// f32 or f64. Only operations that IEEE fixes to the bit; no fused multiply-add (result family "unfused").
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Send
    + Sync
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + SimdFloatElement
    + 'static
{
    /// [`LANES`](crate::LANES) of them, in vectors of a width that the computer has.
    type Vector<L: Simd>: SimdFloat<L, Element = Self>;
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// Nearest value of this type.
    fn from_f64(value: f64) -> Self;
    /// The same value.
    fn to_f64(self) -> f64;
    /// Square root.
    fn sqrt(self) -> Self;
    /// The same values.
    fn widen<L: Simd>(values: Self::Vector<L>) -> f64x8<L>;
    /// Nearest values of this type.
    fn narrow<L: Simd>(values: f64x8<L>) -> Self::Vector<L>;

    /// The larger; `other` if `self` is NaN (one instruction, unlike the library's `max`).
    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

macro_rules! real {
    ($scalar:ty, $vector:ident, $widen:expr, $narrow:expr) => {
        impl Real for $scalar {
            type Vector<L: Simd> = $vector<L>;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            fn from_f64(value: f64) -> Self {
                value as $scalar
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn widen<L: Simd>(values: $vector<L>) -> f64x8<L> {
                $widen(values)
            }
            #[inline(always)]
            fn narrow<L: Simd>(values: f64x8<L>) -> $vector<L> {
                $narrow(values)
            }
        }
    };
}

real!(f32, f32x8, widened, narrowed);
real!(f64, f64x8, identity, identity);

#[inline(always)]
fn widened<L: Simd>(values: f32x8<L>) -> f64x8<L> {
    let (low, high) = values.widen();
    low.combine(high)
}

#[inline(always)]
fn narrowed<L: Simd>(values: f64x8<L>) -> f32x8<L> {
    let (low, high) = values.split();
    low.narrow(high)
}
