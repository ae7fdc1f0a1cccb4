//! The texture generator made of real parts.
//!
//! ```text
//! pattern ─▶ word of b bits ─▶ D/A × fading ramp ─▶ × gain of craters ─▶ filter ─▶ txg.texture
//! ```
//!
//! **Law.** The sum of the layers as a share of their amplitudes at that range is the word of a D/A converter, whose reference
//! is the fading ramp: steps are as large as `amplitude / 2^(b-1)` near the eye and fade with the texture. A filter of one
//! pole follows ([`parts::LagStep`], straight lines between samples): at a rate v of ground range grain lies v tau farther
//! away, and grain of wavelength L along the sweep is weaker by `1 / sqrt(1 + (2 pi v tau / L)^2)`.
//! **Parameters.** [`hardware_model::TextureParts`].
//! **State and timing.** The filter is settled at the first sample of a sweep.
//! **Elaboration.** Without bits and filter this is not there.
//! **Our choices.** One converter behind the sum of the layers. The shift register runs at the sweep clock.

use hardware_model::AnalogParts;
use landscape::Texture;
use parts::{LagStep, MultiplyingConverter, Spread, Tolerance, relative_sigma, time_constant};
use signal::{Lanes, Real};

use crate::scale;

/// Converter and filter, drawn once from the seed of the model; what is `None` is not there.
#[derive(Debug, Clone)]
pub struct PartsTexture<S> {
    converter: Option<MultiplyingConverter>,
    filter: Option<LagStep<S>>,
    /// Amplitude of all layers at each sample that has texture.
    ramp: Vec<f64>,
}

impl<S: Real> PartsTexture<S> {
    /// For samples at `ranges` (m, ascending) that are `h` seconds apart; `seed` is the model's.
    pub fn new(texture: &Texture, ranges: &[f64], h: f64, parts: &AnalogParts, seed: u64) -> Self {
        let sigma = if parts.spread { relative_sigma::BANDWIDTH } else { 0.0 };
        let filter = |nominal: f64| {
            let tolerance = Tolerance { nominal, sigma };
            LagStep::new(h, time_constant(Spread::new(seed).figure("txg.filter", 0, &tolerance)))
        };
        let amplitude =
            |&range: &f64| texture.grains().iter().map(|grain| grain.layer().amplitude_at(range)).sum();
        Self {
            converter: parts.texture.bits.map(|bits| MultiplyingConverter::new(h, bits, 1.0, 0.0, 0.0)),
            filter: parts.texture.bandwidth.map(filter),
            ramp: ranges.iter().take_while(|&&range| range < texture.reach()).map(amplitude).collect(),
        }
    }

    /// Passes the texture of a group of sweeps through; `grain` is what craters add to its gain, none where they add nothing.
    pub fn run(&self, grain: &[Lanes<S>], texture: &mut [Lanes<S>]) {
        if let Some(converter) = &self.converter {
            for (value, &ramp) in texture.iter_mut().zip(&self.ramp) {
                *value = value.map(|value| quantised(converter, value, ramp));
            }
        }
        scale(grain, texture);
        if let Some(filter) = &self.filter {
            let Some(&first) = texture.first() else { return };
            let (mut before, mut out) = (first, first);
            for value in texture {
                out = filter.step(out, before, *value);
                before = std::mem::replace(value, out);
            }
        }
    }
}

fn quantised<S: Real>(converter: &MultiplyingConverter, value: S, ramp: f64) -> S {
    if ramp > 0.0 { S::from_f64(converter.quantised(value.to_f64() / ramp) * ramp) } else { value }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use hardware_model::{AnalogParts, TextureParts};
    use landscape::{Layer, Source, Texture};
    use parts::time_constant;
    use signal::Lanes;

    use super::PartsTexture;

    const H: f64 = 50e-9;

    fn ranges() -> Vec<f64> {
        (1..=1500).map(|k| 0.1 * f64::from(k)).collect()
    }

    fn parts(bits: Option<u32>, bandwidth: Option<f64>) -> PartsTexture<f64> {
        let layers = [
            Layer { cell: 3.7, amplitude: 0.1, range: 150.0 },
            Layer { cell: 0.11, amplitude: 0.2, range: 30.0 },
        ];
        let texture = Texture::new(&layers, Source::Random, 5, 22.0, [0.0; 2]).unwrap();
        let mut analog = AnalogParts::ideal();
        analog.texture = TextureParts { bits, bandwidth };
        PartsTexture::new(&texture, &ranges(), H, &analog, 1970)
    }

    #[test]
    fn words_are_off_by_half_a_step_of_the_fading_ramp() {
        for bits in [1, 4, 6, 10] {
            let part = parts(Some(bits), None);
            let wave = |k: usize| 0.97 * part.ramp[k] * libm::sin(0.37 * k as f64);
            let mut texture: Vec<_> = (0..part.ramp.len()).map(|k| Lanes::splat(wave(k))).collect();
            part.run(&[], &mut texture);
            let step = |k: usize| part.ramp[k] / f64::from(1 << (bits - 1));
            let off = |k: usize| (texture[k][3] - wave(k)) / step(k);
            let most = (0..part.ramp.len()).map(|k| off(k).abs()).fold(0.0, f64::max);
            // There is no word for the positive end.
            assert!(most > 0.45 && most <= 1.0 + 1e-9, "{bits}: {most}");
            assert!((0..part.ramp.len()).all(|k| (texture[k][3] / step(k)).fract().abs() < 1e-9
                || (1.0 - (texture[k][3] / step(k)).fract().abs()) < 1e-9));
        }
        assert_eq!(parts(Some(4), None).ramp.len(), 1499, "none at the reach itself");
    }

    /// Closed form: a sine along the sweep is weaker by `cos(phi)` and later by `phi`, `tan(phi) = w tau`.
    #[test]
    fn grain_is_weaker_and_farther_behind_the_filter() {
        let bandwidth = 0.5e6;
        let part = parts(None, Some(bandwidth));
        let turn = 2.0 * PI / 80.0;
        let mut texture: Vec<_> = (0..1500).map(|k| Lanes::splat(libm::sin(turn * f64::from(k)))).collect();
        part.run(&[], &mut texture);
        let phase = libm::atan(turn * time_constant(bandwidth) / H);
        for (k, value) in texture.iter().enumerate().skip(300) {
            let expected = libm::cos(phase) * libm::sin(turn * k as f64 - phase);
            // Chords of the sine between samples: w^2 h^2 / 12.
            assert!((value[0] - expected).abs() < turn * turn / 11.0, "{k}: {} {expected}", value[0]);
        }
    }

    #[test]
    fn ideal_parts_change_nothing() {
        let mut texture: Vec<Lanes<f64>> = (0..99).map(|k| Lanes::splat(0.001 * f64::from(k))).collect();
        let before = texture.clone();
        parts(None, None).run(&[], &mut texture);
        assert_eq!(texture, before);
        parts(Some(6), Some(5e6)).run(&[], &mut []);
    }
}
