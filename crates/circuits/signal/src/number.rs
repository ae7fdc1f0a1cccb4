//! One number, or eight side by side.

use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use fearless_simd::prelude::{ExtractToken, Select, SimdBase, SimdFloat, SimdFrom, SimdMask};
use fearless_simd::{Simd, f32x8, f32x16, f64x8, mask32x8, mask32x16, mask64x8};

use crate::LANES;

/// One number, or eight or sixteen side by side in vectors. A law that is written over it gives each place what it gives one
/// alone, to the bit: nothing is fused and no sum takes another order.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// `value` rounded to this precision, side by side as often as this number is.
    fn like(self, value: f64) -> Self;
    /// The square root of each number.
    fn root(self) -> Self;
    /// The larger; `other` if `self` is NaN (one instruction, unlike the library's `max`).
    fn at_least(self, other: Self) -> Self;
}

/// A number that laws compare with others, and choose by what a comparison says.
pub trait Comparable: Number {
    /// What a comparison says.
    type Truth: Truth<Self>;
    /// The smaller; `other` if `self` is NaN.
    fn at_most(self, other: Self) -> Self;
    /// Whether it is less than `other`; false if either is NaN.
    fn is_below(self, other: Self) -> Self::Truth;
    /// Whether it is `other` or more; false if either is NaN.
    fn is_at_least(self, other: Self) -> Self::Truth;

    /// Whether it is more than `other`; false if either is NaN.
    #[inline(always)]
    fn is_above(self, other: Self) -> Self::Truth {
        other.is_below(self)
    }

    /// Between two bounds; NaN stays NaN.
    #[inline(always)]
    fn within(self, least: Self, most: Self) -> Self {
        most.at_most(least.at_least(self))
    }
}

/// What a comparison of numbers says: once, or side by side as often as they are.
pub trait Truth<T>: Copy + BitAnd<Output = Self> {
    /// Where it is true `these`, elsewhere `others`.
    fn choose(self, these: T, others: T) -> T;
    /// Whether it is true everywhere.
    fn is_everywhere(self) -> bool;
}

impl<T> Truth<T> for bool {
    #[inline(always)]
    fn choose(self, these: T, others: T) -> T {
        if self { these } else { others }
    }
    #[inline(always)]
    fn is_everywhere(self) -> bool {
        self
    }
}

macro_rules! number {
    ($scalar:ty) => {
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

        impl Comparable for $scalar {
            type Truth = bool;
            #[inline(always)]
            fn at_most(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn is_below(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn is_at_least(self, other: Self) -> bool {
                self >= other
            }
        }
    };
}

macro_rules! numbers {
    ($scalar:ty, $vector:ident, $mask:ident) => {
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

        impl<L: Simd> Comparable for $vector<L> {
            type Truth = $mask<L>;
            #[inline(always)]
            fn at_most(self, other: Self) -> Self {
                self.simd_lt(other).select(self, other)
            }
            #[inline(always)]
            fn is_below(self, other: Self) -> Self::Truth {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn is_at_least(self, other: Self) -> Self::Truth {
                self.simd_ge(other)
            }
        }

        impl<L: Simd> Truth<$vector<L>> for $mask<L> {
            #[inline(always)]
            fn choose(self, these: $vector<L>, others: $vector<L>) -> $vector<L> {
                self.select(these, others)
            }
            #[inline(always)]
            fn is_everywhere(self) -> bool {
                self.all_true()
            }
        }
    };
}

number!(f32);
number!(f64);
numbers!(f32, f32x8, mask32x8);
numbers!(f32, f32x16, mask32x16);
numbers!(f64, f64x8, mask64x8);

/// Eight values as one number.
#[inline(always)]
pub fn eight<L: Simd>(simd: L, values: &[f64; LANES]) -> f64x8<L> {
    f64x8::from_slice(simd, values)
}

/// Sixteen values as two vectors of eight.
#[inline(always)]
pub fn pair<L: Simd>(simd: L, values: &[[f64; LANES]; 2]) -> [f64x8<L>; 2] {
    [eight(simd, &values[0]), eight(simd, &values[1])]
}

#[cfg(test)]
mod tests {
    use fearless_simd::prelude::SimdBase;
    use fearless_simd::{Level, dispatch, f32x8};

    use super::{Comparable, Truth};

    /// What is asked of two numbers, as numbers.
    #[inline(always)]
    fn asked<T: Comparable>(a: T, b: T) -> [T; 6] {
        let number = |truth: T::Truth| truth.choose(a.like(1.0), a.like(0.0));
        let [below, above, at_least] = [a.is_below(b), a.is_above(b), a.is_at_least(b)].map(number);
        [below, above, at_least, a.at_least(b), a.at_most(b), a.within(b, b.like(1.0))]
    }

    #[test]
    fn eight_numbers_are_asked_as_one_is() {
        let a = [0.0, -0.0, 1.0, -2.5, f32::NAN, 3.0, f32::INFINITY, 0.25];
        for turn in 0..a.len() {
            let mut b = a;
            b.rotate_left(turn);
            for vectors in [Level::new(), Level::baseline()] {
                let together = dispatch!(vectors, simd => {
                    let [a, b] = [a, b].map(|values| f32x8::load_array(simd, values));
                    asked(a, b).map(|values| values.to_array())
                });
                for lane in 0..a.len() {
                    let alone = asked(a[lane], b[lane]).map(f32::to_bits);
                    assert_eq!(
                        together.map(|values| values[lane].to_bits()),
                        alone,
                        "{} {}",
                        a[lane],
                        b[lane]
                    );
                }
            }
        }
    }
}
