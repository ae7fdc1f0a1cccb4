//! Small detail of the foreground (section 13): a law of place and range, the same for the machine and `exact`.
//!
//! `t = sum over layers of amplitude * weight(range) * pattern(x, y)`, added to reflectivity before projection. The
//! weight falls linearly from 1 at range 0 to 0 at the layer's range. A pattern is within -1..=1, of zero mean, given
//! on a square lattice and joined in each cell by `smooth(u)` along x and y, `smooth(u) = u^2 (3 - 2u)`. The slope of
//! `smooth` is 0 at both ends, so the derivative across every lattice line vanishes on it: the pattern has no kink, and
//! none where a stored region is mirrored at its edge.

mod lattice;
#[cfg(test)]
mod tests;

pub use lattice::{Hashed, Stored};

use quantities::hash_words;

/// Why a texture cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TextureError {
    /// No layer, or too many.
    #[error("{0} texture layers: expected 1 to {MOST_LAYERS}")]
    LayerCount(usize),
    /// Cell size out of range.
    #[error("texture layer {layer}: cell of {cell} m, expected 0.001 m to 1e6 m")]
    Cell {
        /// Which, counted from 0.
        layer: usize,
        /// What was given (m).
        cell: f64,
    },
    /// Amplitude out of range.
    #[error("texture layer {layer}: amplitude {amplitude}, expected 0 to 1")]
    Amplitude {
        /// Which, counted from 0.
        layer: usize,
        /// Amplitude that was given for the layer.
        amplitude: f64,
    },
    /// Range out of range.
    #[error("texture layer {layer}: range of {range} m, expected above 0 and at most 1e6 m")]
    Range {
        /// Which, counted from 0.
        layer: usize,
        /// What was given (m).
        range: f64,
    },
    /// Region size or origin out of range.
    #[error("texture over regions of {region_size} m from ({}, {}) m: expected 0.001 m to 1e9 m, from within 1e9 m", origin[0], origin[1])]
    Regions {
        /// Side of a region (m).
        region_size: f64,
        /// Corner of region (0, 0) (m).
        origin: [f64; 2],
    },
}

/// Most layers of a texture.
pub const MOST_LAYERS: usize = 8;

/// Texture of one grain size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Distance between lattice points (m).
    pub cell: f64,
    /// Largest deviation of reflectivity, either way, 0..=1.
    pub amplitude: f64,
    /// Ground range at which it has faded to nothing (m).
    pub range: f64,
}

impl Layer {
    /// Amplitude at ground range `range` (m).
    pub fn amplitude_at(&self, range: f64) -> f64 {
        self.amplitude * (1.0 - range / self.range).max(0.0)
    }

    fn check(&self, layer: usize) -> Result<(), TextureError> {
        let Self { cell, amplitude, range } = *self;
        if !(0.001..=1e6).contains(&cell) {
            return Err(TextureError::Cell { layer, cell });
        }
        if !(0.0..=1.0).contains(&amplitude) {
            return Err(TextureError::Amplitude { layer, amplitude });
        }
        if !(range > 0.0 && range <= 1e6) {
            return Err(TextureError::Range { layer, range });
        }
        Ok(())
    }
}

/// Where texture comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A pattern over one region, mirrored at its edges: used in every region (variant 1).
    Pattern,
    /// A repeatable pseudo-random routine over the whole ground (variant 2).
    Random,
}

/// Lattice values of a layer.
#[derive(Debug, Clone, PartialEq)]
pub enum Lattice {
    /// Lattice of variant 1: values stored for one region.
    Stored(Stored),
    /// Lattice of variant 2: values hashed from their place, over the whole ground.
    Hashed(Hashed),
}

/// A layer with its pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct Grain {
    layer: Layer,
    lattice: Lattice,
}

impl Grain {
    /// Size, amplitude and reach. The cell of a stored pattern is the whole part of a region nearest to that asked for.
    pub fn layer(&self) -> &Layer {
        &self.layer
    }

    /// Returns the lattice values of the pattern.
    pub fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// The pattern at (x, y) (m) from the origin of the texture, -1..=1.
    pub fn pattern(&self, x: f64, y: f64) -> f64 {
        match &self.lattice {
            Lattice::Stored(lattice) => lattice.at(x, y),
            Lattice::Hashed(lattice) => lattice.at(x, y),
        }
    }
}

/// Texture of the ground: layers of different grain, added to reflectivity.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    origin: [f64; 2],
    grains: Vec<Grain>,
}

impl Texture {
    /// Texture of `layers` (1 to 8, in any order) from `source`; `seed` names the pattern. Its lattice is laid over the
    /// regions of the finest level: side `region_size` (m), corner of region (0, 0) at `origin` (m).
    ///
    /// # Errors
    /// If a number is out of its range.
    pub fn new(
        layers: &[Layer],
        source: Source,
        seed: u64,
        region_size: f64,
        origin: [f64; 2],
    ) -> Result<Self, TextureError> {
        if layers.is_empty() || layers.len() > MOST_LAYERS {
            return Err(TextureError::LayerCount(layers.len()));
        }
        let is_near = |place: &f64| place.abs() <= 1e9;
        if !((0.001..=1e9).contains(&region_size) && origin.iter().all(is_near)) {
            return Err(TextureError::Regions { region_size, origin });
        }
        let grain = |(number, layer): (usize, &Layer)| {
            layer.check(number)?;
            // Two layers of one cell size are two patterns.
            let seed = hash_words(seed, &[number as u64]);
            Ok(match source {
                Source::Random => {
                    Grain { layer: *layer, lattice: Lattice::Hashed(Hashed::new(seed, layer.cell)) }
                }
                Source::Pattern => {
                    let stored = Stored::new(seed, layer.cell, region_size);
                    Grain {
                        layer: Layer { cell: region_size / stored.cells() as f64, ..*layer },
                        lattice: Lattice::Stored(stored),
                    }
                }
            })
        };
        Ok(Self { origin, grains: layers.iter().enumerate().map(grain).collect::<Result<_, _>>()? })
    }

    /// Where lattice point (0, 0) of all layers lies (m).
    pub fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// Layers with their patterns, in the order given.
    pub fn grains(&self) -> &[Grain] {
        &self.grains
    }

    /// What is added to reflectivity at (x, y) (m), seen from ground range `range` (m).
    pub fn at(&self, x: f64, y: f64, range: f64) -> f64 {
        let [x, y] = [x - self.origin[0], y - self.origin[1]];
        let near = self.grains.iter().filter(|grain| range < grain.layer.range);
        near.fold(0.0, |sum, grain| sum + grain.layer.amplitude_at(range) * grain.pattern(x, y))
    }

    /// Ground range beyond which there is no texture (m).
    pub fn reach(&self) -> f64 {
        self.grains.iter().map(|grain| grain.layer.range).fold(0.0, f64::max)
    }

    /// Largest deviation of reflectivity that all layers together can make.
    pub fn bound(&self) -> f64 {
        self.grains.iter().map(|grain| grain.layer.amplitude).sum()
    }
}
