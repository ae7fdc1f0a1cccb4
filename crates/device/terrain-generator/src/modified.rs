//! Two terrain generators, one a level, switched by ground range (section 8).

use std::ops::Range;

use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch, f64x8};
use hardware_model::BlendWeight;
use landscape::basis::{derivatives, values};
use landscape::{GroupLight, SweepLight};
use signal::{LANES, Lanes, Number, Real, eight};
use sweep_program::SweepProgram;

use crate::{Method, Polynomials, Profile, TerrainGenerator};

#[cfg(test)]
mod tests;

/// The modified terrain generator of the report, set for one frame.
///
/// Up to the switch a lane shows the fine level, beyond it the coarse one. Over the last `blend` metres before the
/// switch the height is `w h_fine + (1 - w) h_coarse` with `w = g00`, 1 to 0, level at both ends (our choice; or the
/// cubic of [`BlendWeight`]): height and slopes are continuous. The slope along the sweep takes `w' (h_fine - h_coarse)` more; the slope across takes
/// none, as if neighbouring sweeps went over at the same range. Both generators read the same ranges and subtract the
/// same datum.
#[derive(Debug, Clone, Copy)]
pub struct ModifiedTerrainGenerator<'a> {
    /// Generator of the near ground, on the fine level.
    pub fine: TerrainGenerator<'a>,
    /// Generator of the far ground, on the coarse level.
    pub coarse: TerrainGenerator<'a>,
    /// Length of the blend before the switch (m); 0: a video switch within one sample.
    pub blend: f64,
    /// Law of the weight over the blend.
    pub weight: BlendWeight,
    /// Whether the slope along the sweep takes the rate of the weight; without it the light of the blend is that of other slopes.
    pub slope_term: bool,
}

/// Heights and slopes of the coarse level under the blend; reused from group to group.
pub type Overlap<S> = Profile<S>;

/// Where one lane goes over.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Switch {
    /// Ground range (m); the sample there is still fine.
    range: f64,
    /// First sample that is not purely fine.
    blended: usize,
    /// First sample that is purely coarse.
    beyond: usize,
}

impl ModifiedTerrainGenerator<'_> {
    /// Runs the programs of a group on both levels into `profile`; lane n goes over at ground range `switch[n]` (m),
    /// or at the end of its fine profile if that comes first. A lane whose coarse profile ends before the switch stays
    /// fine. Returns the step at the switch: the largest `|h_fine - h_coarse|` (m) of the group at its last fine
    /// samples; with `blend` 0 that is the jump that is seen.
    ///
    /// Neither generator computes samples that no lane of the group takes from it.
    pub fn run<S: Real>(
        &self,
        fine: &[SweepProgram; LANES],
        coarse: &[SweepProgram; LANES],
        switch: &[f64; LANES],
        light: &[SweepLight; LANES],
        profile: &mut Profile<S>,
        overlap: &mut Overlap<S>,
    ) -> f64 {
        let methods = [&mut Polynomials::default(), &mut Polynomials::default()];
        let step = self.trace_by(methods, fine, coarse, switch, profile, overlap);
        self.fine.reflect(&GroupLight::new(light), 0..self.fine.ranges.len(), profile);
        step
    }

    /// Height and slopes alone, by methods, the fine level's first.
    pub fn trace_by<S: Real, M: Method<S>>(
        &self,
        [by_fine, by_coarse]: [&mut M; 2],
        fine: &[SweepProgram; LANES],
        coarse: &[SweepProgram; LANES],
        switch: &[f64; LANES],
        profile: &mut Profile<S>,
        overlap: &mut Overlap<S>,
    ) -> f64 {
        let switches: [Switch; LANES] =
            std::array::from_fn(|lane| self.switch(&fine[lane], &coarse[lane], switch[lane]));
        let samples = self.fine.ranges.len();
        let last_fine = switches.iter().map(|switch| switch.beyond).max().unwrap_or(samples);
        let first_coarse =
            switches.iter().map(|switch| switch.first_coarse(samples)).min().unwrap_or(samples);
        let shared = first_coarse..last_fine.max(first_coarse);
        profile.resize(samples);
        by_coarse.trace(&self.coarse, coarse, first_coarse..samples, profile);
        set_aside(profile, shared.clone(), overlap);
        by_fine.trace(&self.fine, fine, 0..last_fine, profile);
        let step = step_at_switch(profile, overlap, &switches, shared.start);
        dispatch!(Level::new(), simd => self.join(simd, &switches, shared, overlap, profile));
        step
    }

    fn switch(&self, fine: &SweepProgram, coarse: &SweepProgram, wanted: f64) -> Switch {
        let range = wanted.min(fine.end_range);
        let range = if coarse.end_range <= range { f64::INFINITY } else { range };
        let beyond = self.fine.ranges.partition_point(|&z| z <= range);
        let blended = self.fine.ranges.partition_point(|&z| z <= range - self.blend);
        Switch { range, blended, beyond }
    }

    /// Joins the levels at the samples that both were computed for: those of `span`, with which `overlap` begins.
    #[inline(always)]
    fn join<L: Simd, S: Real>(
        &self,
        simd: L,
        switches: &[Switch; LANES],
        span: Range<usize>,
        overlap: &Overlap<S>,
        profile: &mut Profile<S>,
    ) {
        let begin = eight(simd, &switches.each_ref().map(|switch| switch.range)) - self.blend;
        let beyond = eight(simd, &switches.each_ref().map(|switch| switch.beyond as f64));
        let blended = switches.each_ref().map(|switch| S::from_f64(switch.blended as f64));
        let blended = S::Vector::<L>::from_slice(simd, &blended);
        // A product that is not there is one with a weight that does not change.
        let rises_over = if self.slope_term { self.blend } else { f64::INFINITY };
        let Profile { height, along, across, .. } = profile;
        let fine: [&mut [Lanes<S>]; 3] = [height, along, across];
        let coarse = [&overlap.height, &overlap.along, &overlap.across];
        for (place, sample) in span.enumerate() {
            let number = sample as f64;
            let way = (f64x8::simd_from(simd, self.fine.ranges[sample]) - begin) / self.blend;
            // Weight of the fine level and its rate along the sweep (1/m); beyond the switch it has none.
            let (is_fine, none) =
                (f64x8::simd_from(simd, number).simd_lt(beyond), f64x8::simd_from(simd, 0.0));
            let [weight, rate] = match self.weight {
                BlendWeight::Quintic => [values(way)[0], derivatives(way)[0]],
                BlendWeight::Cubic => [1.0 - way * way * (3.0 - 2.0 * way), way * (way - 1.0) * 6.0],
            };
            let weight = S::narrow(is_fine.select(weight, none));
            let rate = S::narrow(is_fine.select(rate / rises_over, none));
            let is_blended = weight.like(number).simd_ge(blended);
            let [mut near, mut far] = [[weight; 3]; 2];
            for signal in 0..3 {
                near[signal] = S::Vector::from_slice(simd, &fine[signal][sample].0);
                far[signal] = S::Vector::from_slice(simd, &coarse[signal][place].0);
            }
            let mut joined = near;
            for signal in 0..3 {
                joined[signal] = weight * near[signal] + (weight.like(1.0) - weight) * far[signal];
            }
            joined[1] += rate * (near[0] - far[0]);
            for signal in 0..3 {
                let blended = is_blended.select(joined[signal], near[signal]);
                blended.store_slice(&mut fine[signal][sample].0);
            }
        }
    }
}

impl Switch {
    /// Whether the switch falls between two of `samples` samples.
    fn is_met(&self, samples: usize) -> bool {
        (1..samples).contains(&self.beyond)
    }

    /// First sample at which the coarse level is wanted: the last fine one at the latest, where the step is measured.
    fn first_coarse(&self, samples: usize) -> usize {
        if self.is_met(samples) { self.blended.min(self.beyond - 1) } else { self.blended }
    }
}

/// Keeps what `profile` holds at the samples of `span`.
fn set_aside<S: Real>(profile: &Profile<S>, span: Range<usize>, overlap: &mut Overlap<S>) {
    let parts = [
        (&profile.height, &mut overlap.height),
        (&profile.along, &mut overlap.along),
        (&profile.across, &mut overlap.across),
    ];
    for (signal, kept) in parts {
        kept.clear();
        kept.extend_from_slice(&signal[span.clone()]);
    }
}

/// Largest difference in height between the levels at the last fine samples of the lanes (m); `overlap` begins at
/// sample `first`.
fn step_at_switch<S: Real>(
    profile: &Profile<S>,
    overlap: &Overlap<S>,
    switches: &[Switch; LANES],
    first: usize,
) -> f64 {
    let step = |(lane, switch): (usize, &Switch)| {
        let last = switch.beyond - 1;
        (profile.height[last][lane].to_f64() - overlap.height[last - first][lane].to_f64()).abs()
    };
    let met = |switch: &(usize, &Switch)| switch.1.is_met(profile.height.len());
    switches.iter().enumerate().filter(met).map(step).fold(0.0, f64::max)
}
