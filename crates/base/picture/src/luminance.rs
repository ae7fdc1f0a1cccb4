//! From colour to grey: luminance, reckoned in linear light.

use crate::pixels::{ColourPicture, Depth, GreyPicture, Picture};

/// The display curve between a level of the codes, 0 to 1, and linear light, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// That of sRGB (IEC 61966-2-1), for pictures that say nothing else.
    Srgb,
    /// A power, for frames of a run: light = level to this exponent.
    Power(f64),
}

impl Curve {
    /// The linear light of a level, both 0 to 1.
    pub fn light(self, level: f64) -> f64 {
        match self {
            Self::Srgb if level <= 0.040_45 => level / 12.92,
            Self::Srgb => libm::pow((level + 0.055) / 1.055, 2.4),
            Self::Power(exponent) => libm::pow(level, exponent),
        }
    }

    /// The level of a linear light, both 0 to 1.
    pub fn level(self, light: f64) -> f64 {
        match self {
            Self::Srgb if light <= 0.003_130_8 => light * 12.92,
            Self::Srgb => 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055,
            Self::Power(exponent) => libm::pow(light, 1.0 / exponent),
        }
    }

    /// The light of every code.
    pub(crate) fn lights(self, depth: Depth) -> Vec<f64> {
        let white = f64::from(depth.white());
        (0..=depth.white()).map(|code| self.light(f64::from(code) / white)).collect()
    }

    /// The code of a light of 0 to 1, rounded to the nearest level.
    pub fn code(self, light: f64, depth: Depth) -> u16 {
        (self.level(light.clamp(0.0, 1.0)) * f64::from(depth.white()) + 0.5).floor() as u16
    }
}

impl ColourPicture {
    /// The grey picture of the same luminance: each code becomes light under `curve`, the light is weighted by
    /// [`quantities::luminance`], and the sum becomes a code under the same curve. A pixel without colour keeps its code.
    pub fn to_grey(&self, curve: Curve) -> GreyPicture {
        let lights = curve.lights(self.depth());
        let grey = |pixel: &[u16; 3]| match *pixel {
            [red, green, blue] if red == green && green == blue => red,
            codes => {
                let light = quantities::luminance(codes.map(|code| lights[usize::from(code)]));
                curve.code(light, self.depth())
            }
        };
        let codes = self.pixels().iter().map(grey).collect();
        Picture::from_parts(self.columns(), self.lines(), self.depth(), codes)
    }
}
