//! Curved steps of a group of sweeps, side by side.

use fearless_simd::{Select, Simd, SimdBase, f32x8};

use crate::curve::CHORDS;
use crate::side_by_side::Strokes;

/// The cubic, in each lane, between the middle two of four equally spaced values whose slopes are those of their
/// neighbours.
#[derive(Clone, Copy)]
pub(crate) struct Cubic<V: Simd> {
    values: [f32x8<V>; 4],
}

impl<V: Simd> Cubic<V> {
    #[inline(always)]
    pub fn through(values: [f32x8<V>; 4]) -> Self {
        Self { values }
    }

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

    /// Values at parts of the step, 0..=1.
    #[inline(always)]
    pub fn at(&self, simd: V, u: f32x8<V>) -> f32x8<V> {
        let [a, b, c, d] = self.values;
        let [half, two, three] = [0.5, 2.0, 3.0].map(|value| f32x8::splat(simd, value));
        let (first, last) = (half * (c - a), half * (d - b));
        let chord = c - b;
        b + u * (first + u * (three * chord - two * first - last + u * (first + last - two * chord)))
    }
}

/// Curved strokes as chords from the part `entry` of the step on; the beam never turns back.
#[inline(always)]
pub(crate) fn chords<V: Simd>(
    simd: V,
    position: &Cubic<V>,
    intensity: &Cubic<V>,
    whole: Strokes<f32x8<V>>,
    entry: f32x8<V>,
) -> [Strokes<f32x8<V>>; CHORDS as usize] {
    // A cubic overshoots at a step; no intensity is beyond full scale.
    let [least, most] = [-1.0, 1.0].map(|value| f32x8::splat(simd, value));
    let intensity = |u| within(intensity.at(simd, u), least, most);
    let way = most - entry;
    let (mut from, mut start) = (whole.from, intensity(entry));
    let mut chords = [whole; CHORDS as usize];
    for (number, chord) in (1..).zip(&mut chords) {
        if number < CHORDS {
            let u = entry + way * f32x8::splat(simd, number as f32) / f32x8::splat(simd, CHORDS as f32);
            chord.to = within(position.at(simd, u), whole.to, from);
            chord.end = intensity(u);
        }
        (chord.from, chord.start) = (from, start);
        (from, start) = (chord.to, chord.end);
    }
    chords
}

/// What is not a number stays so.
#[inline(always)]
fn within<V: Simd>(value: f32x8<V>, least: f32x8<V>, most: f32x8<V>) -> f32x8<V> {
    let above = value.simd_lt(least).select(least, value);
    above.simd_gt(most).select(most, above)
}
