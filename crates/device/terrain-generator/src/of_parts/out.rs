//! From the sums of a group to height and slopes.

use parts::GroupNoise;
use signal::{LANES, Lanes, Real};

use super::run::Run;
use super::scale::Scale;
use super::state::ArrayState;
use crate::generator::Profile;

/// The last wires of a group, and what they are scaled by.
pub(super) struct Out {
    /// Of the three sums.
    noise: [GroupNoise; 3],
    sigma: f64,
    /// Height and slope at full scale (m, m a region).
    height: f64,
    slope: f64,
    region_size: f64,
    /// The datum with what each sweep is trimmed by (m), and what the summer subtracts (m).
    base: [f64; LANES],
    datum: f64,
    cos: [f64; LANES],
    sin: [f64; LANES],
}

impl Out {
    /// Of sweeps from `address` on over all frames, trimmed by `trim` (m).
    pub(super) fn new<S: Real>(run: &Run<'_, S>, address: u64, trim: &[f64; LANES]) -> Self {
        let Scale { datum, height, slope } = run.array.scale;
        Self {
            noise: run.array.noise.each_ref().map(|source| source.of_group(address)),
            sigma: run.array.sigma,
            height,
            slope,
            region_size: run.generator.region_size,
            base: trim.map(|trim| datum + trim),
            datum: run.generator.datum,
            cos: run.programs.each_ref().map(|program| program.start.direction[0]),
            sin: run.programs.each_ref().map(|program| program.start.direction[1]),
        }
    }

    /// Height and slopes at `sample`, which is number `n` of the block; whether it is the first that is taken.
    #[inline(always)]
    pub(super) fn put<S: Real>(
        &self,
        (sample, n): (usize, usize),
        is_first: bool,
        state: &mut ArrayState<S>,
        profile: &mut Profile<S>,
    ) {
        if self.sigma > 0.0 && (sample % 2 == 0 || is_first) {
            for sum in 0..3 {
                state.noise[sum] = self.noise[sum].pair(sample as u64 / 2);
            }
        }
        let mut values = [[0.0; LANES]; 3];
        for sum in 0..3 {
            let noise = &state.noise[sum][sample % 2];
            for lane in 0..LANES {
                values[sum][lane] = state.block.sums[sum][n].0[lane].to_f64() + self.sigma * noise[lane];
            }
        }
        let [mut height, mut along, mut across] = [Lanes::default(); 3];
        for lane in 0..LANES {
            let [h, u, v] = [values[0][lane], values[1][lane], values[2][lane]];
            let (hu, hv) = (u * self.slope / self.region_size, v * self.slope / self.region_size);
            height.0[lane] = S::from_f64(h * self.height + self.base[lane] - self.datum);
            along.0[lane] = S::from_f64(hu * self.cos[lane] + hv * self.sin[lane]);
            across.0[lane] = S::from_f64(hv * self.cos[lane] - hu * self.sin[lane]);
        }
        profile.height[sample] = height;
        profile.along[sample] = along;
        profile.across[sample] = across;
    }
}
