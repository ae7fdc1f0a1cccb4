//! The scalar type of the analog signals: a setting of the run.

use std::fmt::Debug;
use std::ops::AddAssign;

use fearless_simd::prelude::{ExtractToken, SimdBase, SimdFloat, SimdFloatElement};
use fearless_simd::{Simd, f32x8, f32x16, f64x8};

use crate::double::Twice;
use crate::{Comparable, Double, LANES};

/// f32 or f64. Only operations that IEEE fixes to the bit; no fused multiply-add (result family "unfused").
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Send
    + Sync
    + Comparable<Truth = bool>
    + AddAssign
    + SimdFloatElement
    + 'static
{
    /// [`LANES`](crate::LANES) of them, in vectors of a width that the computer has.
    type Vector<L: Simd>: SimdFloat<L, Element = Self> + Comparable;
    /// Twice [`LANES`](crate::LANES) of them.
    type Double<L: Simd>: Double<L, Self>;
    /// The number 0 of the scalar type.
    const ZERO: Self;
    /// The number 1 of the scalar type.
    const ONE: Self;
    /// Nearest value of this type.
    fn from_f64(value: f64) -> Self;
    /// Returns the same value as an f64.
    fn to_f64(self) -> f64;

    /// The same values. A loop, as below: what the library has for it is called, not inlined.
    #[inline(always)]
    fn widen<L: Simd>(values: Self::Vector<L>) -> f64x8<L> {
        let mut widened = [0.0; LANES];
        for lane in 0..LANES {
            widened[lane] = values[lane].to_f64();
        }
        f64x8::from_slice(values.token(), &widened)
    }

    /// Nearest values of this type.
    #[inline(always)]
    fn narrow<L: Simd>(values: f64x8<L>) -> Self::Vector<L> {
        let mut narrowed = [Self::ZERO; LANES];
        for lane in 0..LANES {
            narrowed[lane] = Self::from_f64(values[lane]);
        }
        Self::Vector::from_slice(values.token(), &narrowed)
    }
}

macro_rules! real {
    ($scalar:ty, $vector:ident, $double:ty) => {
        impl Real for $scalar {
            type Vector<L: Simd> = $vector<L>;
            type Double<L: Simd> = $double;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            fn from_f64(value: f64) -> Self {
                value as $scalar
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
}

real!(f32, f32x8, f32x16<L>);
real!(f64, f64x8, Twice<f64x8<L>>);
