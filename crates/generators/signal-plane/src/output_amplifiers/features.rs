//! Wires of the feature generator, which bend and jump at kinks.

use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use feature_generator::{FeatureProfile, Kink};
use parts::{Jump, Jumps};
use signal::{LANES, Lanes, Real};

use crate::feature_light::Lit;
use crate::output_amplifiers::{AmplifierScratch, Axes, OutputAmplifiers};

impl<S: Real> OutputAmplifiers<S> {
    /// Height and slopes behind their amplifiers, at the samples and at the kinks; sweeps run in `directions`.
    pub fn drive_features(
        &self,
        directions: &[[f64; 2]; LANES],
        profile: &mut FeatureProfile<S>,
        AmplifierScratch { jumps, .. }: &mut AmplifierScratch<S>,
    ) {
        let FeatureProfile { height, along, across, kinks, .. } = profile;
        if let Some(driver) = &self.features.height {
            take_jumps(kinks, jumps, |kink| (kink.sample, kink.share, [kink.height; 2]));
            driver.pass(height, jumps);
            put_back(jumps, kinks, |kink, [height, _]| kink.height = height);
        }
        if self.features.slopes.iter().any(Option::is_some) {
            let axes = Axes::new(directions);
            axes.to_map(along, across);
            turn(kinks, |lane| [axes.cos[lane], axes.sin[lane]]);
            for (axis, (driver, slope)) in
                self.features.slopes.iter().zip([&mut *along, &mut *across]).enumerate()
            {
                let Some(driver) = driver else { continue };
                take_jumps(kinks, jumps, |kink| {
                    (kink.sample, kink.share, [kink.before[axis], kink.after[axis]])
                });
                driver.pass(slope, jumps);
                put_back(jumps, kinks, |kink, sides| [kink.before[axis], kink.after[axis]] = sides);
            }
            axes.to_sweep(along, across);
            turn(kinks, |lane| [axes.cos[lane], -axes.sin[lane]]);
        }
    }

    /// Reflectivity behind its amplifier, where features lie on ground of reflectivity `ground`; `lit` is 1 where they do.
    pub fn drive_feature_light(
        &self,
        ground: &[Lanes<S>],
        lit: &[Lanes<S>],
        light: &mut Lit<S>,
        AmplifierScratch { jumps, .. }: &mut AmplifierScratch<S>,
    ) {
        let Some(driver) = &self.features.reflectivity else { return };
        dispatch!(Level::new(), simd => fill_unlit(simd, ground, lit, &mut light.reflectivity));
        take_jumps(&light.kinks, jumps, |kink| {
            let video = |side: usize| if kink.present[side] { kink.feature[side] } else { kink.terrain };
            (kink.sample, kink.share, [video(0), video(1)])
        });
        driver.pass(&mut light.reflectivity, jumps);
        put_back(jumps, &mut light.kinks, |kink, sides| kink.feature = sides);
    }
}

/// The video of features is the ground's where they are not lit.
#[inline(always)]
fn fill_unlit<L: Simd, S: Real>(simd: L, ground: &[Lanes<S>], lit: &[Lanes<S>], video: &mut [Lanes<S>]) {
    let zero = S::Vector::<L>::simd_from(simd, S::ZERO);
    for (video, (lit, ground)) in video.iter_mut().zip(lit.iter().zip(ground)) {
        let [own, lit, ground] =
            [&*video, lit, ground].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
        lit.simd_gt(zero).select(own, ground).store_slice(&mut video.0);
    }
}

/// What jumps at `kinks`: step, part of the step, and the values on both sides.
fn take_jumps<S: Real, K>(kinks: &[Vec<K>; LANES], jumps: &mut Jumps, of: impl Fn(&K) -> (usize, S, [S; 2])) {
    for (jumps, kinks) in jumps.lists.iter_mut().zip(kinks) {
        jumps.clear();
        jumps.extend(kinks.iter().map(|kink| {
            let (sample, share, sides) = of(kink);
            let [before, after] = sides.map(S::to_f64);
            Jump { at: sample as f64 - 1.0 + share.to_f64(), before, after }
        }));
    }
}

/// Writes the values on both sides of each jump back to its kink.
fn put_back<S: Real, K>(jumps: &Jumps, kinks: &mut [Vec<K>; LANES], put: impl Fn(&mut K, [S; 2])) {
    for (jumps, kinks) in jumps.lists.iter().zip(kinks) {
        for (jump, kink) in jumps.iter().zip(kinks) {
            put(kink, [jump.before, jump.after].map(S::from_f64));
        }
    }
}

/// Turns the slopes of kinks by the angle whose cosine and sine `of` has for each lane.
fn turn<S: Real>(kinks: &mut [Vec<Kink<S>>; LANES], of: impl Fn(usize) -> [S; 2]) {
    for (lane, kinks) in kinks.iter_mut().enumerate() {
        let [cos, sin] = of(lane);
        for kink in kinks {
            for [a, b] in [&mut kink.before, &mut kink.after] {
                (*a, *b) = (*a * cos - *b * sin, *a * sin + *b * cos);
            }
        }
    }
}
