//! The unit at the samples alone: features are in the terrain already, and no edge lies between two samples.

use std::ops::Range;

use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use scenario::TextureInShadow;
use signal::{Lanes, Number, Real, Stretches};

use crate::MixingUnit;

impl MixingUnit {
    /// VS2, the adder and the clip upon the `reflectivity` of a group, lit with its features. A sample keeps as much of its
    /// light as `dark`, the stretches in remote shadow, leave of the step about it (stretches begin half a step before the first sample and end half a step
    /// beyond the last one, at most): so the light of a sweep is what it is with
    /// edges at their places, as far as samples can tell. `texture` ends where the slice does. Only the samples in `runs` are
    /// right afterwards.
    pub fn run_preview<S: Real>(
        &self,
        dark: Option<&Stretches>,
        texture: &[Lanes<S>],
        runs: &[Range<usize>],
        reflectivity: &mut [Lanes<S>],
    ) {
        let video = Video { runs, texture };
        dispatch!(Level::new(), simd => match self.texture_in_shadow {
            TextureInShadow::Off => {
                video.add(simd, S::from_f64(f64::NEG_INFINITY), reflectivity);
                blank(dark, reflectivity);
                video.clip(simd, reflectivity);
            }
            TextureInShadow::On => {
                blank(dark, reflectivity);
                video.add(simd, S::ZERO, reflectivity);
                video.clip(simd, reflectivity);
            }
        });
    }
}

/// What stands about VS2.
struct Video<'a, S> {
    runs: &'a [Range<usize>],
    texture: &'a [Lanes<S>],
}

impl<S: Real> Video<'_, S> {
    /// The adder: texture upon what is not below `least`.
    #[inline(always)]
    fn add<L: Simd>(&self, simd: L, least: S, reflectivity: &mut [Lanes<S>]) {
        let least = S::Vector::<L>::simd_from(simd, least);
        for run in self.runs {
            let texture = self.texture.get(run.start..).unwrap_or_default();
            for (value, texture) in reflectivity[run.clone()].iter_mut().zip(texture) {
                let [light, grain] =
                    [&value.0, &texture.0].map(|lanes| S::Vector::<L>::from_slice(simd, lanes));
                (light.at_least(least) + grain).store_slice(&mut value.0);
            }
        }
    }

    /// The clip: nothing is brighter than white.
    #[inline(always)]
    fn clip<L: Simd>(&self, simd: L, reflectivity: &mut [Lanes<S>]) {
        let white = S::Vector::<L>::simd_from(simd, S::ONE);
        for run in self.runs {
            for value in &mut reflectivity[run.clone()] {
                let light = S::Vector::<L>::from_slice(simd, &value.0);
                light.simd_gt(white).select(white, light).store_slice(&mut value.0);
            }
        }
    }
}

/// VS2: nothing is left within the stretches, and at their ends what is lit of half a step before a sample and half a step
/// behind it.
#[inline(always)]
fn blank<S: Real>(dark: Option<&Stretches>, reflectivity: &mut [Lanes<S>]) {
    let Some(dark) = dark else { return };
    for (lane, stretches) in dark.iter().enumerate() {
        for &[begin, end] in stretches {
            let [first, last] = [begin, end].map(|place| (place + 0.5) as usize);
            if first == last {
                keep(reflectivity, first, lane, 1.0 - (end - begin));
                continue;
            }
            keep(reflectivity, first, lane, begin + 0.5 - first as f64);
            reflectivity[first + 1..last].iter_mut().for_each(|value| value[lane] = S::ZERO);
            keep(reflectivity, last, lane, last as f64 + 0.5 - end);
        }
    }
}

/// Leaves a share of a sample; the step behind the last sample is no sample's.
fn keep<S: Real>(reflectivity: &mut [Lanes<S>], sample: usize, lane: usize, share: f64) {
    if let Some(value) = reflectivity.get_mut(sample) {
        value[lane] *= S::from_f64(share);
    }
}

#[cfg(test)]
mod tests {
    use hardware_model::MixingParts;
    use proptest::prelude::{prop_assert, proptest};
    use scenario::TextureInShadow;
    use signal::{Lanes, Stretches};

    use crate::MixingUnit;

    fn unit(texture: TextureInShadow) -> MixingUnit {
        MixingUnit::new(&MixingParts::default(), texture)
    }

    fn mixed(
        texture_in_shadow: TextureInShadow,
        dark: &[[f64; 2]],
        texture: &[f64],
        light: &[f64],
    ) -> Vec<f64> {
        let mut reflectivity: Vec<Lanes<f64>> = light.iter().map(|&light| Lanes::splat(light)).collect();
        let texture: Vec<_> = texture.iter().map(|&texture| Lanes::splat(texture)).collect();
        let stretches: Stretches =
            std::array::from_fn(|lane| if lane == 3 { dark.to_vec() } else { Vec::new() });
        unit(texture_in_shadow).run_preview(
            Some(&stretches),
            &texture,
            &[0..2, 2..light.len()],
            &mut reflectivity,
        );
        reflectivity.iter().map(|value| value[3]).collect()
    }

    #[test]
    fn texture_grains_shadow_where_the_adder_stands_behind_the_switch() {
        let (light, dark, grain) = ([0.5, -0.2, 0.5, 0.95, 0.5], [[1.5, 2.5]], [0.1; 4]);
        let behind = mixed(TextureInShadow::On, &dark, &grain, &light);
        assert_eq!(behind, [0.6, 0.1, 0.1, 1.0, 0.5]);
        let before = mixed(TextureInShadow::Off, &dark, &grain, &light);
        assert_eq!(before, [0.6, -0.1, 0.0, 1.0, 0.5]);
    }

    #[test]
    fn a_shadow_within_a_step_takes_its_part() {
        assert_eq!(mixed(TextureInShadow::Off, &[[2.0, 2.25]], &[], &[1.0; 5]), [1.0, 1.0, 0.75, 1.0, 1.0]);
        assert_eq!(mixed(TextureInShadow::Off, &[[3.75, 4.5]], &[], &[1.0; 5]), [1.0, 1.0, 1.0, 1.0, 0.25]);
        assert_eq!(mixed(TextureInShadow::Off, &[[0.0, 2.25]], &[], &[1.0; 5]), [0.5, 0.0, 0.25, 1.0, 1.0]);
    }

    proptest! {
        /// Over a level stretch the light that is left is what is outside the shadows.
        #[test]
        fn as_much_is_dark_as_lies_in_shadow(cuts in proptest::collection::vec(0.01..2.0f64, 0..40)) {
            let mut at = 0.5;
            let places: Vec<f64> = cuts.iter().map(|cut| { at += cut; at }).take_while(|&at| at < 47.5).collect();
            let dark: Vec<[f64; 2]> = places.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect();
            let left: f64 = mixed(TextureInShadow::Off, &dark, &[], &[1.0; 49]).iter().sum();
            let shadow: f64 = dark.iter().map(|[begin, end]| end - begin).sum();
            // Two shadows in the step about one sample take parts of one another: at most a quarter of a step each.
            let shared = 0.25 * dark.len() as f64;
            prop_assert!((49.0 - shadow - left).abs() <= shared, "{} {}", 49.0 - shadow, left);
            if dark.windows(2).all(|pair| pair[1][0] - pair[0][1] > 1.0) && dark.iter().all(|[b, e]| e - b > 1.0) {
                prop_assert!((49.0 - shadow - left).abs() < 1e-9);
            }
        }
    }
}
