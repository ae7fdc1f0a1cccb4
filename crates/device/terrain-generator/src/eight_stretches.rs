//! A stretch of each sweep of a group: eight polynomials that are expanded and evaluated side by side.

use std::ops::Range;

use fearless_simd::prelude::{SimdBase, SimdFrom, SimdMask};
use fearless_simd::{Simd, f64x8, u32x8};
use signal::{Double, LANES, Lanes, Real, eight, pair};

use crate::region::GroupRegions;
use crate::stretches::{Stretch, Walk};
use crate::{Profile, Segment, Span};

/// What stretches are expanded from, sweep by sweep.
#[derive(Debug, Clone)]
pub(crate) struct EightStretches {
    /// Numbers of the regions.
    regions: [u32; LANES],
    middle: [[f64; LANES]; 2],
    half: [[f64; LANES]; 2],
    half_length: [f64; LANES],
    across: [[f64; LANES]; 2],
    /// Ground range of the middle (m).
    range: [f64; LANES],
    /// First samples, and first samples behind.
    begins: [u32; LANES],
    ends: [u32; LANES],
}

/// Polynomials of stretches in `s = (range - middle) / half_length`, ascending powers; each for two samples side by side.
struct Expanded<D> {
    height: [D; 11],
    along: [D; 10],
    across: [D; 10],
    middle: D,
    inverse_half: D,
}

/// Height and slopes along and across at two samples.
struct HeightAndSlopes<D>([D; 3]);

impl Default for EightStretches {
    fn default() -> Self {
        let (eight, none) = ([0.0; LANES], [0; LANES]);
        Self {
            regions: none,
            middle: [eight; 2],
            half: [eight; 2],
            half_length: eight,
            across: [eight; 2],
            range: eight,
            begins: none,
            ends: none,
        }
    }
}

impl EightStretches {
    /// Sweep `lane` has none.
    #[inline(always)]
    pub(crate) fn leave_out(&mut self, lane: usize) {
        (self.regions[lane], self.begins[lane], self.ends[lane]) = (0, u32::MAX, 0);
    }

    /// Sets one stretch over region number `region`, which is `size` wide (m); samples from `until` on are not wanted.
    #[inline(always)]
    pub(crate) fn set(
        &mut self,
        size: f64,
        (lane, walk): (usize, &Walk<'_>),
        Stretch { samples, ends: [begin, end] }: Stretch,
        until: usize,
        region: u32,
    ) {
        let (middle, half_length) = (0.5 * (begin + end), 0.5 * (end - begin));
        let (polarity, [cos, sin]) = (walk.registers.polarity(), walk.direction());
        let ramps = walk.ramps(middle / size);
        let across = [-sin * polarity[0] / size, cos * polarity[1] / size];
        for axis in 0..2 {
            self.middle[axis][lane] = ramps[axis].0;
            self.half[axis][lane] = ramps[axis].1 * half_length / size;
            self.across[axis][lane] = across[axis];
        }
        (self.half_length[lane], self.range[lane]) = (half_length, middle);
        self.regions[lane] = region;
        (self.begins[lane], self.ends[lane]) = (samples.start as u32, samples.end.min(until) as u32);
    }

    /// Height above `datum` (m) and slopes of each sweep at its samples; nothing else of `profile` is touched.
    #[inline(always)]
    pub(crate) fn trace<L: Simd, S: Real>(
        &self,
        simd: L,
        datum: f64,
        regions: &GroupRegions,
        ranges: &[S],
        profile: &mut Profile<S>,
    ) {
        let expanded = self.expand::<L, S>(simd, datum, regions);
        let [any, all] = self.spans();
        self.trace_some(simd, any.start..all.start, &expanded, ranges, profile);
        for first in all.clone().step_by(2) {
            expanded.at::<L, S>(simd, first, ranges).put(first, profile);
        }
        self.trace_some(simd, all.end..any.end, &expanded, ranges, profile);
    }

    /// Samples that any sweep has, and those that all have, an even number.
    #[inline(always)]
    fn spans(&self) -> [Range<usize>; 2] {
        let (mut any, mut all) = ([u32::MAX, 0], [0, u32::MAX]);
        for (&begin, &end) in self.begins.iter().zip(&self.ends) {
            any = [any[0].min(begin), any[1].max(end)];
            all = [all[0].max(begin), all[1].min(end)];
        }
        let [any, all] = [any, all].map(|[begin, end]| begin as usize..end as usize);
        let all = if all.is_empty() { any.end..any.end } else { all.start..all.end - all.len() % 2 };
        [any, all]
    }

    /// At samples that some sweeps have.
    #[inline(always)]
    fn trace_some<L: Simd, S: Real>(
        &self,
        simd: L,
        samples: Range<usize>,
        expanded: &Expanded<S::Double<L>>,
        ranges: &[S],
        profile: &mut Profile<S>,
    ) {
        for first in samples.step_by(2) {
            // A pair lies within the profile; which of its samples are meant, the sweeps tell.
            let first = first.min(ranges.len() - 2);
            let lanes = self.sweeps_at(simd, first) | self.sweeps_at(simd, first + 1) << LANES;
            expanded.at::<L, S>(simd, first, ranges).put_some(simd, lanes, first, profile);
        }
    }

    /// Which sweeps have a sample: a bit each.
    #[inline(always)]
    fn sweeps_at<L: Simd>(&self, simd: L, sample: usize) -> u64 {
        let sample = u32x8::simd_from(simd, sample as u32);
        let [begins, ends] = [&self.begins, &self.ends].map(|bounds| u32x8::from_slice(simd, bounds));
        (begins.simd_le(sample) & sample.simd_lt(ends)).to_bitmask()
    }

    /// Polynomials of all stretches; `datum` is subtracted from the height (m).
    #[inline(always)]
    fn expand<L: Simd, S: Real>(
        &self,
        simd: L,
        datum: f64,
        regions: &GroupRegions,
    ) -> Expanded<S::Double<L>> {
        let half_length = eight(simd, &self.half_length);
        let span = Span {
            middle: pair(simd, &self.middle),
            half: pair(simd, &self.half),
            half_length,
            across: pair(simd, &self.across),
        };
        let mut segment = Segment::expand(&regions.side_by_side(simd, &self.regions), &span);
        segment.height[0] -= datum;
        let zero = S::Double::<L>::splat(simd, S::ZERO);
        let mut expanded = Expanded {
            height: [zero; 11],
            along: [zero; 10],
            across: [zero; 10],
            middle: twice::<L, S>(eight(simd, &self.range)),
            inverse_half: twice::<L, S>(1.0 / half_length),
        };
        // Loops: what `map` of an array is handed is called.
        for k in 0..11 {
            expanded.height[k] = twice::<L, S>(segment.height[k]);
        }
        for k in 0..10 {
            expanded.along[k] = twice::<L, S>(segment.along[k]);
            expanded.across[k] = twice::<L, S>(segment.across[k]);
        }
        expanded
    }
}

impl<D: Copy> Expanded<D> {
    /// Ground of all sweeps at sample `first` and the next.
    #[inline(always)]
    fn at<L: Simd, S: Real<Double<L> = D>>(&self, simd: L, first: usize, ranges: &[S]) -> HeightAndSlopes<D>
    where
        D: Double<L, S>,
    {
        let near = S::Vector::<L>::simd_from(simd, ranges[first]);
        let far = S::Vector::<L>::simd_from(simd, ranges[first + 1]);
        let s = (D::of(near, far) - self.middle) * self.inverse_half;
        let [mut height, mut along, mut across] =
            [self.height[10] * s + self.height[9], self.along[9], self.across[9]];
        for k in (0..9).rev() {
            height = height * s + self.height[k];
            along = along * s + self.along[k];
            across = across * s + self.across[k];
        }
        HeightAndSlopes([height, along, across])
    }
}

impl<D: Copy> HeightAndSlopes<D> {
    /// Writes both samples to height and slopes.
    #[inline(always)]
    fn put<L: Simd, S: Real<Double<L> = D>>(
        self,
        first: usize,
        Profile { height, along, across, .. }: &mut Profile<S>,
    ) where
        D: Double<L, S>,
    {
        put::<L, S>(self.0[0], first, height);
        put::<L, S>(self.0[1], first, along);
        put::<L, S>(self.0[2], first, across);
    }

    /// Puts those whose bit is set in `lanes`: eight of the first sample, eight of the next.
    #[inline(always)]
    fn put_some<L: Simd, S: Real<Double<L> = D>>(
        self,
        simd: L,
        lanes: u64,
        first: usize,
        Profile { height, along, across, .. }: &mut Profile<S>,
    ) where
        D: Double<L, S>,
    {
        put_some(simd, lanes, self.0[0], first, height);
        put_some(simd, lanes, self.0[1], first, along);
        put_some(simd, lanes, self.0[2], first, across);
    }
}

#[inline(always)]
fn put<L: Simd, S: Real>(values: S::Double<L>, first: usize, signal: &mut [Lanes<S>]) {
    let halves = values.halves();
    halves[0].store_slice(&mut signal[first].0);
    halves[1].store_slice(&mut signal[first + 1].0);
}

#[inline(always)]
fn put_some<L: Simd, S: Real>(
    simd: L,
    lanes: u64,
    values: S::Double<L>,
    first: usize,
    signal: &mut [Lanes<S>],
) {
    let near = S::Vector::<L>::from_slice(simd, &signal[first].0);
    let far = S::Vector::<L>::from_slice(simd, &signal[first + 1].0);
    let before = S::Double::<L>::of(near, far);
    put::<L, S>(S::Double::<L>::chosen(simd, lanes, values, before), first, signal);
}

/// Values of eight sweeps for two samples, as a run has its numbers.
#[inline(always)]
fn twice<L: Simd, S: Real>(values: f64x8<L>) -> S::Double<L> {
    let values = S::narrow(values);
    S::Double::<L>::of(values, values)
}
