//! Ideal parts: the array's polynomials along the sweeps of a group.

use std::ops::Range;

use fearless_simd::prelude::SimdBase;
use fearless_simd::{Level, Simd, dispatch, f64x8};
use signal::{LANES, Real, eight, pair};
use sweep_program::SweepProgram;

use crate::points::Points;
use crate::region::RecentRegions;
use crate::stretches::{Stretch, Walk};
use crate::sweeps::{Sweeps, WIDE};
use crate::{Method, OUT_OF_SIGHT, Profile, Region, Segment, Span, TerrainGenerator};

#[cfg(test)]
mod tests;

/// Ideal parts: the array's polynomial along each stretch, expanded from the words in the hold registers. Far ground has a
/// region a sample: stretches of one or two samples go straight through the array (fixed rule: the same for any run).
///
/// Stretches are expanded for the eight sweeps of a group side by side; each is then evaluated eight samples at a time.
/// What is kept here are buffers: what they held last never matters.
#[derive(Debug, Clone)]
pub struct Polynomials<S> {
    /// Width of vectors that the computer has.
    pub(crate) vectors: Level,
    /// Ground range of each sample (m), with room for what is evaluated beyond the last.
    ranges: Vec<S>,
    regions: RecentRegions,
    stretches: Stretches,
    points: Points,
    sweeps: Sweeps<S>,
}

/// What stretches are expanded from, sweep by sweep.
#[derive(Debug, Clone)]
struct Stretches {
    regions: [Region; LANES],
    middle: [[f64; LANES]; 2],
    half: [[f64; LANES]; 2],
    half_length: [f64; LANES],
    across: [[f64; LANES]; 2],
    /// Ground range of the middle (m).
    range: [f64; LANES],
    samples: [Range<usize>; LANES],
}

/// Polynomials of stretches in `s = (range - middle) / half_length`, sweep by sweep.
struct Expanded<S> {
    height: [[S; LANES]; 11],
    along: [[S; LANES]; 10],
    across: [[S; LANES]; 10],
    middle: [S; LANES],
    inverse_half: [S; LANES],
}

impl<S: Real> Default for Polynomials<S> {
    fn default() -> Self {
        Self {
            vectors: Level::new(),
            ranges: Vec::new(),
            regions: RecentRegions::default(),
            stretches: Stretches::default(),
            points: Points::default(),
            sweeps: Sweeps::default(),
        }
    }
}

impl<S: Real> Method<S> for Polynomials<S> {
    fn trace(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        profile: &mut Profile<S>,
    ) {
        self.ranges.resize(generator.ranges.len() + WIDE, S::ZERO);
        self.sweeps.resize(generator.ranges.len());
        self.regions.forget();
        dispatch!(self.vectors, simd => self.trace_by(simd, generator, programs, &span));
        self.sweeps.put_side_by_side(self.vectors, span, profile);
    }
}

impl<S: Real> Polynomials<S> {
    #[inline(always)]
    fn trace_by<L: Simd>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: &Range<usize>,
    ) {
        narrow_all(generator.ranges, &mut self.ranges);
        let mut walks = programs.each_ref().map(|program| Walk::new(generator, program, span.start));
        while self.collect(simd, generator, &mut walks, span.end) {
            self.stretches.trace(simd, generator.datum, &self.ranges, &mut self.sweeps);
        }
        self.points.work_out(simd, generator, &mut self.sweeps);
        self.drop_out_of_sight(&walks, span);
    }

    /// The next stretch of each sweep that has more than two samples; false if there is none before sample `end`.
    #[inline(always)]
    fn collect<L: Simd>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        walks: &mut [Walk<'_>; LANES],
        end: usize,
    ) -> bool {
        let mut any = false;
        for (lane, walk) in walks.iter_mut().enumerate() {
            self.stretches.samples[lane] = 0..0;
            while let Some(stretch) = walk.next(generator, end) {
                if stretch.samples.len() > 2 {
                    let region = self.regions.of(&walk.registers, generator.buffer);
                    self.stretches.set(generator.region_size, (lane, walk), stretch, end, region);
                    any = true;
                    break;
                }
                self.points.add(simd, generator, (lane, walk), &stretch, &mut self.sweeps);
            }
        }
        any
    }

    fn drop_out_of_sight(&mut self, walks: &[Walk<'_>; LANES], span: &Range<usize>) {
        for (lane, walk) in walks.iter().enumerate() {
            let beyond = walk.last.clamp(span.start, span.end)..span.end;
            let values = [OUT_OF_SIGHT, 0.0, 0.0].map(S::from_f64);
            for (signal, value) in self.sweeps.of_sweep(lane).into_iter().zip(values) {
                signal[beyond.clone()].fill(value);
            }
        }
    }
}

impl Stretches {
    /// Sets one stretch over `region`, which is `size` wide (m); samples from `until` on are not wanted.
    #[inline(always)]
    fn set(
        &mut self,
        size: f64,
        (lane, walk): (usize, &Walk<'_>),
        Stretch { samples, ends: [begin, end] }: Stretch,
        until: usize,
        region: &Region,
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
        self.regions[lane] = *region;
        self.samples[lane] = samples.start..samples.end.min(until);
    }

    #[inline(always)]
    fn trace<L: Simd, S: Real>(&self, simd: L, datum: f64, ranges: &[S], sweeps: &mut Sweeps<S>) {
        let expanded = self.expand(simd, datum);
        for (lane, samples) in self.samples.iter().enumerate() {
            expanded.evaluate(lane, samples.clone(), ranges, sweeps.of_sweep(lane));
        }
    }

    /// Polynomials of all stretches; `datum` is subtracted from the height (m).
    #[inline(always)]
    fn expand<L: Simd, S: Real>(&self, simd: L, datum: f64) -> Expanded<S> {
        let half_length = eight(simd, &self.half_length);
        let span = Span {
            middle: pair(simd, &self.middle),
            half: pair(simd, &self.half),
            half_length,
            across: pair(simd, &self.across),
        };
        let mut segment = Segment::expand(&Region::side_by_side(simd, &self.regions), &span);
        segment.height[0] -= datum;
        Expanded {
            height: segment.height.map(narrow),
            along: segment.along.map(narrow),
            across: segment.across.map(narrow),
            middle: self.range.map(S::from_f64),
            inverse_half: narrow(1.0 / half_length),
        }
    }
}

impl Default for Stretches {
    fn default() -> Self {
        let (eight, none) = ([0.0; LANES], 0..0);
        Self {
            regions: [Region::default(); LANES],
            middle: [eight; 2],
            half: [eight; 2],
            half_length: eight,
            across: [eight; 2],
            range: eight,
            samples: std::array::from_fn(|_| none.clone()),
        }
    }
}

impl<S: Real> Expanded<S> {
    /// Height and slopes at the samples of one stretch, and at some behind it that are written over later: sixteen at a time while
    /// there are more than eight.
    #[inline(always)]
    fn evaluate(&self, lane: usize, samples: Range<usize>, ranges: &[S], mut signals: [&mut [S]; 3]) {
        let mut first = samples.start;
        while first + LANES < samples.end {
            self.evaluate_some::<WIDE>(lane, first, ranges, &mut signals);
            first += WIDE;
        }
        if first < samples.end {
            self.evaluate_some::<LANES>(lane, first, ranges, &mut signals);
        }
    }

    /// The same at `N` samples from `first` on.
    #[inline(always)]
    fn evaluate_some<const N: usize>(
        &self,
        lane: usize,
        first: usize,
        ranges: &[S],
        [height, along, across]: &mut [&mut [S]; 3],
    ) {
        let (middle, inverse_half) = (self.middle[lane], self.inverse_half[lane]);
        let (some, mut s) = (first..first + N, [S::ZERO; N]);
        for (s, &range) in s.iter_mut().zip(&ranges[some.clone()]) {
            *s = (range - middle) * inverse_half;
        }
        height[some.clone()].copy_from_slice(&horner(&self.height, lane, &s));
        along[some.clone()].copy_from_slice(&horner(&self.along, lane, &s));
        across[some].copy_from_slice(&horner(&self.across, lane, &s));
    }
}

/// A polynomial of sweep `lane` at several places; arrays, as no vector of `S` is known to be as wide as the computer's.
#[inline(always)]
fn horner<S: Real, const N: usize, const C: usize>(
    coefficients: &[[S; LANES]; C],
    lane: usize,
    s: &[S; N],
) -> [S; N] {
    let mut sum = [coefficients[C - 1][lane]; N];
    for k in (0..C - 1).rev() {
        let coefficient = coefficients[k][lane];
        for n in 0..N {
            sum[n] = sum[n] * s[n] + coefficient;
        }
    }
    sum
}

/// Values as a run has its numbers.
#[inline(always)]
fn narrow_all<S: Real>(values: &[f64], out: &mut [S]) {
    for (out, &value) in out.iter_mut().zip(values) {
        *out = S::from_f64(value);
    }
}

/// Eight values as a run has its numbers.
#[inline(always)]
fn narrow<L: Simd, S: Real>(values: f64x8<L>) -> [S; LANES] {
    let mut narrowed = [S::ZERO; LANES];
    S::narrow(values).store_slice(&mut narrowed);
    narrowed
}
