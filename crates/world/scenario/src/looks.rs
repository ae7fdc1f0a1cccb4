//! How ground and sky look: texture, the fineness of shadows, how the display takes roll.

use std::path::PathBuf;

use landscape::{Layer, Source, Texture, TextureError};

/// Texture that a scenario asks for.
#[derive(Debug, Clone, PartialEq)]
pub struct TextureWish {
    /// Where it comes from.
    pub source: Source,
    /// Seed that names the pattern: the same seed, the same pattern.
    pub seed: u64,
    /// Layers of the texture, one per grain size.
    pub layers: Vec<Layer>,
    /// Gain of the grain in the middle of craters of types 1, 2 and 3, 0 to [`MOST_GAIN`](landscape::MOST_GAIN).
    pub crater_gain: [f64; 3],
}

impl TextureWish {
    /// The texture over regions of this size (m) from `origin` (m).
    ///
    /// # Errors
    /// If a number is out of its range.
    pub fn over(&self, region_size: f64, origin: [f64; 2]) -> Result<Texture, TextureError> {
        Texture::new(&self.layers, self.source, self.seed, region_size, origin)
    }
}

/// How finely remote shadow is worked out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadowFineness {
    /// Smallest distance between profiles (m).
    pub finest: f64,
    /// Distance between profiles for each metre of distance from the eye (rad).
    pub angle: f64,
    /// Ground range beyond which there is none (m); that of the last sample if open.
    pub reach: Option<f64>,
}

impl Default for ShadowFineness {
    /// A quarter of a metre near the eye, a sweep of a thousand beyond (our choice).
    fn default() -> Self {
        Self { finest: 0.25, angle: 1e-3, reach: None }
    }
}

/// What the display does about the vehicle's roll (section 18).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RollDisplay {
    /// Nothing: the picture stands upright whatever the vehicle does.
    #[default]
    None,
    /// The yoke of the machine turns the picture.
    Yoke,
}

/// A picture that says what the ground returns from place to place.
#[derive(Debug, Clone, PartialEq)]
pub struct AlbedoMapWish {
    /// The picture, in the scenario's folder or below: north above.
    pub file: PathBuf,
    /// Its south, west, north, east edge (m); those of the finest level if open.
    pub area: Option<[f64; 4]>,
    /// Albedo of black and of white, 0..=1.
    pub ends: [f64; 2],
    /// From codes to light.
    pub curve: MapCurve,
}

/// A photograph of the ground.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PhotographWish {
    /// The picture, in the scenario's folder or below.
    pub file: PathBuf,
    /// Its camera file or map file, there too.
    pub camera: PathBuf,
}

/// How the codes of a map stand for light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MapCurve {
    /// By the curve of sRGB, as pictures that say nothing else.
    #[default]
    Srgb,
    /// Light is in proportion to the code.
    Linear,
}
