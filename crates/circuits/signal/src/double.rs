//! Two groups of lanes as one: sixteen numbers side by side.
//!
//! Two wires of a group that have parts of a kind behind them go through these together: with vectors of sixteen that is one
//! instruction for two. Lane by lane nothing changes, so the bits do not either.

use std::ops::{Add, Mul, Sub};

use fearless_simd::prelude::{Select, SimdBase, SimdCombine, SimdFrom, SimdMask, SimdSplit};
use fearless_simd::{Simd, f32x8, f32x16, f64x8};

use crate::{LANES, Lanes, Real};

/// Two wires of a group at one sample: eight lanes of the first, then eight of the second.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Both<S>(pub [S; 2 * LANES]);

impl<S: Real> Both<S> {
    /// The same value in all lanes of the first wire, another in those of the second.
    pub fn splat(values: [S; 2]) -> Self {
        let mut both = Self::default();
        values.into_iter().enumerate().for_each(|(wire, value)| both.set(wire, Lanes::splat(value)));
        both
    }

    /// One of the two wires, 0 or 1.
    #[inline(always)]
    pub fn wire(&self, wire: usize) -> Lanes<S> {
        let mut lanes = Lanes::default();
        lanes.0.copy_from_slice(&self.0[LANES * wire..LANES * (wire + 1)]);
        lanes
    }

    /// Puts one of the two wires in its place.
    #[inline(always)]
    pub fn set(&mut self, wire: usize, lanes: Lanes<S>) {
        self.0[LANES * wire..LANES * (wire + 1)].copy_from_slice(&lanes.0);
    }
}

impl<S: Real> Default for Both<S> {
    fn default() -> Self {
        Self([S::ZERO; 2 * LANES])
    }
}

/// Two vectors of eight as one, as wide as the computer has them.
pub trait Double<L: Simd, S: Real>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// As they stand in memory.
    fn load(simd: L, both: &Both<S>) -> Self;
    /// Writes the lanes back to memory.
    fn store(self, both: &mut Both<S>);
    /// The same value in all lanes of both.
    fn splat(simd: L, value: S) -> Self;
    /// Joins two halves into one.
    fn of(low: S::Vector<L>, high: S::Vector<L>) -> Self;
    /// Returns the two halves.
    fn halves(self) -> [S::Vector<L>; 2];
    /// Of the lanes whose bit is set in `lanes` those of `these`, of the others those of `others`.
    fn chosen(simd: L, lanes: u64, these: Self, others: Self) -> Self;
    /// Returns the size of each lane: its absolute value.
    fn size(self) -> Self;
    /// The larger of each two sizes.
    fn at_least(self, other: Self) -> Self;
    /// Lanes in which both are equal, a bit each.
    fn matches(self, other: Self) -> u64;
    /// Whether any is larger than its bound.
    fn is_beyond(self, bound: Self) -> bool;
}

impl<L: Simd> Double<L, f32> for f32x16<L> {
    #[inline(always)]
    fn load(simd: L, both: &Both<f32>) -> Self {
        Self::from_slice(simd, &both.0)
    }

    #[inline(always)]
    fn store(self, both: &mut Both<f32>) {
        self.store_slice(&mut both.0);
    }

    #[inline(always)]
    fn splat(simd: L, value: f32) -> Self {
        Self::simd_from(simd, value)
    }

    #[inline(always)]
    fn of(low: f32x8<L>, high: f32x8<L>) -> Self {
        low.combine(high)
    }

    #[inline(always)]
    fn halves(self) -> [f32x8<L>; 2] {
        let (low, high) = self.split();
        [low, high]
    }

    #[inline(always)]
    fn chosen(simd: L, lanes: u64, these: Self, others: Self) -> Self {
        <Self as SimdBase<L>>::Mask::from_bitmask(simd, lanes).select(these, others)
    }

    #[inline(always)]
    fn size(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn matches(self, other: Self) -> u64 {
        self.simd_eq(other).to_bitmask()
    }

    #[inline(always)]
    fn is_beyond(self, bound: Self) -> bool {
        self.simd_gt(bound).any_true()
    }
}

/// No computer has vectors of sixteen f64.
#[derive(Debug, Clone, Copy)]
pub struct Twice<V>([V; 2]);

macro_rules! both_halves {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<V: Copy + $trait<Output = V>> $trait for Twice<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self([self.0[0] $op other.0[0], self.0[1] $op other.0[1]])
            }
        }
    };
}

both_halves!(Add, add, +);
both_halves!(Sub, sub, -);
both_halves!(Mul, mul, *);

impl<L: Simd> Double<L, f64> for Twice<f64x8<L>> {
    #[inline(always)]
    fn load(simd: L, both: &Both<f64>) -> Self {
        let (low, high) = both.0.split_at(LANES);
        Self([f64x8::from_slice(simd, low), f64x8::from_slice(simd, high)])
    }

    #[inline(always)]
    fn store(self, both: &mut Both<f64>) {
        let (low, high) = both.0.split_at_mut(LANES);
        self.0[0].store_slice(low);
        self.0[1].store_slice(high);
    }

    #[inline(always)]
    fn splat(simd: L, value: f64) -> Self {
        Self([f64x8::simd_from(simd, value); 2])
    }

    #[inline(always)]
    fn of(low: f64x8<L>, high: f64x8<L>) -> Self {
        Self([low, high])
    }

    #[inline(always)]
    fn halves(self) -> [f64x8<L>; 2] {
        self.0
    }

    #[inline(always)]
    fn chosen(simd: L, lanes: u64, these: Self, others: Self) -> Self {
        let mask = |lanes| <f64x8<L> as SimdBase<L>>::Mask::from_bitmask(simd, lanes);
        Self([
            mask(lanes & 0xff).select(these.0[0], others.0[0]),
            mask(lanes >> LANES).select(these.0[1], others.0[1]),
        ])
    }

    #[inline(always)]
    fn size(self) -> Self {
        Self([self.0[0].abs(), self.0[1].abs()])
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        Self([self.0[0].max(other.0[0]), self.0[1].max(other.0[1])])
    }

    #[inline(always)]
    fn matches(self, other: Self) -> u64 {
        let lanes = |half: usize| self.0[half].simd_eq(other.0[half]).to_bitmask();
        lanes(0) | lanes(1) << LANES
    }

    #[inline(always)]
    fn is_beyond(self, bound: Self) -> bool {
        (self.0[0].simd_gt(bound.0[0]) | self.0[1].simd_gt(bound.0[1])).any_true()
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::prelude::SimdBase;
    use fearless_simd::{Level, Simd, dispatch};

    use super::{Both, Double};
    use crate::{LANES, Lanes, Real};

    #[inline(always)]
    fn worked_out<L: Simd, S: Real>(simd: L, [a, b]: [&Both<S>; 2]) -> (Both<S>, [Lanes<S>; 2]) {
        let [a, b] = [S::Double::<L>::load(simd, a), S::Double::<L>::load(simd, b)];
        let mut whole = Both::default();
        (a * b - a + b).store(&mut whole);
        let [low, high] = S::Double::<L>::of(a.halves()[1], b.halves()[0]).halves();
        let mut halves = [Lanes::default(); 2];
        low.store_slice(&mut halves[0].0);
        high.store_slice(&mut halves[1].0);
        (whole, halves)
    }

    /// The larger sizes of each two; whether those of `a` are anywhere beyond themselves, and beyond those of `b`.
    #[inline(always)]
    fn compared<L: Simd, S: Real>(simd: L, [a, b]: [&Both<S>; 2]) -> (Both<S>, [bool; 2]) {
        let [a, b] = [S::Double::<L>::load(simd, a).size(), S::Double::<L>::load(simd, b).size()];
        let mut larger = Both::default();
        a.at_least(b).store(&mut larger);
        (larger, [a.is_beyond(a), a.is_beyond(b)])
    }

    fn are_two_wires<S: Real>() {
        let wire = |from: f64| Lanes::from_fn(|lane| S::from_f64(1.0 / (from + lane as f64)));
        let wires = [[wire(3.0), wire(11.0)], [wire(-40.5), wire(1e9)]];
        let [a, b] = wires.map(|[low, high]| {
            let mut both = Both::default();
            both.set(0, low);
            both.set(1, high);
            both
        });
        for level in [Level::new(), Level::baseline()] {
            let (whole, halves) = dispatch!(level, simd => worked_out(simd, [&a, &b]));
            for wire in 0..2 {
                let [a, b] = [wires[0][wire], wires[1][wire]];
                assert_eq!(whole.wire(wire), a * b - a + b);
            }
            assert_eq!(halves, [wires[0][1], wires[1][0]]);
        }
        let larger = |a: Lanes<S>, b: Lanes<S>| Lanes::from_fn(|lane| a[lane].at_least(b[lane]));
        for level in [Level::new(), Level::baseline()] {
            let (larger_ones, beyond) = dispatch!(level, simd => compared(simd, [&a, &b]));
            for wire in 0..2 {
                let [a, b] =
                    [wires[0][wire], wires[1][wire]].map(|wire| wire.map(|value| (-value).at_least(value)));
                assert_eq!(larger_ones.wire(wire), larger(a, b));
            }
            assert_eq!(beyond, [false, true]);
        }
        let splat = Both::splat([S::ONE, S::ZERO]);
        assert_eq!(splat.0[..LANES], [S::ONE; LANES]);
        assert_eq!(splat.0[LANES..], [S::ZERO; LANES]);
    }

    #[test]
    fn two_wires_at_once_are_two_wires() {
        are_two_wires::<f32>();
        are_two_wires::<f64>();
    }
}
