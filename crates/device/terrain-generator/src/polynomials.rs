//! Ideal parts: the array's polynomials along the sweeps of a group.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};
use signal::{LANES, Lanes, Real};
use sweep_program::SweepProgram;

use crate::eight_stretches::EightStretches;
use crate::points::Points;
use crate::region::GroupRegions;
use crate::stretches::Walk;
use crate::{Method, OUT_OF_SIGHT, Profile, TerrainGenerator};

#[cfg(test)]
mod tests;

/// Ideal parts: the array's polynomial along each stretch, expanded from the words in the hold registers. Far ground has a
/// region a sample: stretches of one or two samples go straight through the array (fixed rule: the same for any run).
///
/// Stretches are expanded and evaluated for the eight sweeps of a group side by side.
/// What is kept here are buffers: what they held last never matters.
#[derive(Debug, Clone)]
pub struct Polynomials<S> {
    /// Width of vectors that the computer has.
    pub(crate) vectors: Level,
    /// Ground range of each sample (m).
    ranges: Vec<S>,
    regions: GroupRegions,
    stretches: EightStretches,
    points: Points,
}

impl<S: Real> Default for Polynomials<S> {
    fn default() -> Self {
        Self {
            vectors: Level::new(),
            ranges: Vec::new(),
            regions: GroupRegions::default(),
            stretches: EightStretches::default(),
            points: Points::default(),
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
        self.ranges.resize(generator.ranges.len(), S::ZERO);
        self.regions.forget();
        self.points.begin(span.end);
        dispatch!(self.vectors, simd => self.trace_by(simd, generator, programs, &span, profile));
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
        profile: &mut Profile<S>,
    ) {
        narrow_all(generator.ranges, &mut self.ranges);
        let mut walks = programs.each_ref().map(|program| Walk::new(generator, program, span.start));
        while self.collect(simd, generator, &mut walks, span.end, profile) {
            self.stretches.trace(simd, generator.datum, &self.regions, &self.ranges, profile);
        }
        self.points.work_out(simd, generator, profile);
        drop_out_of_sight(walks.each_ref().map(|walk| walk.last), span, profile);
    }

    /// The next stretch of each sweep that has more than two samples; false if there is none before sample `end`.
    #[inline(always)]
    fn collect<L: Simd>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        walks: &mut [Walk<'_>; LANES],
        end: usize,
        profile: &mut Profile<S>,
    ) -> bool {
        self.regions.make_room();
        let mut any = false;
        for (lane, walk) in walks.iter_mut().enumerate() {
            self.stretches.leave_out(lane);
            while let Some(stretch) = walk.next(generator, end) {
                if stretch.samples.len() > 2 {
                    let region = self.regions.of(&walk.registers, generator.buffer);
                    self.stretches.set(generator.region_size, (lane, walk), stretch, end, region);
                    any = true;
                    break;
                }
                self.points.add(simd, generator, (lane, walk), &stretch, profile);
            }
        }
        any
    }
}

/// Drops what lies beyond the profile of each sweep, which ends before sample `ends[lane]`.
#[inline(always)]
fn drop_out_of_sight<S: Real>(
    ends: [usize; LANES],
    span: &Range<usize>,
    Profile { height, along, across, .. }: &mut Profile<S>,
) {
    let (mut first, mut all) = (span.end, span.start);
    for end in ends {
        (first, all) = (first.min(end).max(span.start), all.max(end).min(span.end));
    }
    for sample in first..all {
        for lane in (0..LANES).filter(|&lane| ends[lane] <= sample) {
            height[sample].0[lane] = S::from_f64(OUT_OF_SIGHT);
            (along[sample].0[lane], across[sample].0[lane]) = (S::ZERO, S::ZERO);
        }
    }
    height[all..span.end].fill(Lanes::splat(S::from_f64(OUT_OF_SIGHT)));
    along[all..span.end].fill(Lanes::default());
    across[all..span.end].fill(Lanes::default());
}

/// Values as a run has its numbers.
#[inline(always)]
fn narrow_all<S: Real>(values: &[f64], out: &mut [S]) {
    for (out, &value) in out.iter_mut().zip(values) {
        *out = S::from_f64(value);
    }
}
