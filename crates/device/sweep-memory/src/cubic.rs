//! Whole steps without breaks as curves.

use fearless_simd::{Select, Simd, SimdBase, f32x8};
use signal::Number;

use crate::curve::Curve;

/// The cubic between the middle two of four equally spaced values, whose slopes are those of their neighbours: of one sweep, or
/// of eight side by side.
#[derive(Clone, Copy)]
pub(crate) struct Cubic<T> {
    values: [T; 4],
}

impl<T> Cubic<T> {
    #[inline(always)]
    pub fn through(values: [T; 4]) -> Self {
        Self { values }
    }
}

impl<V: Simd> Cubic<f32x8<V>> {
    /// Largest second difference; not a number or infinite where a value is not finite.
    #[inline(always)]
    pub fn bend(&self, simd: V) -> f32x8<V> {
        let [a, b, c, d] = self.values;
        let [two, infinity] = [2.0, f32::INFINITY].map(|value| f32x8::splat(simd, value));
        let (first, last) = ((a - two * b + c).abs(), (b - two * c + d).abs());
        // A sum that is not finite is none, and greater than nothing.
        let largest = first.simd_gt(last).select(first, last);
        (first + last).simd_lt(infinity).select(largest, infinity)
    }
}

impl<T: Number> Curve<T> for Cubic<T> {
    #[inline(always)]
    fn at(&self, u: T) -> T {
        let [a, b, c, d] = self.values;
        let [half, two, three] = [0.5, 2.0, 3.0].map(|value| u.like(value));
        let (first, last) = (half * (c - a), half * (d - b));
        let chord = c - b;
        b + u * (first + u * (three * chord - two * first - last + u * (first + last - two * chord)))
    }
}
