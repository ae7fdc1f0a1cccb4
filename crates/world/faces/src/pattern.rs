//! The rule that numbers the false normals of a checkerboard.

use std::f64::consts::TAU;

use crate::board::GridVertex;
use crate::error::{FaceError, within};

/// Rule that gives each vertex the number of its normal: a function of place and seed alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pattern {
    /// A hash of seed, row and column: a confused sea (reported, as delivered).
    Random {
        /// Number that names the pattern.
        seed: u64,
    },
    /// The sum of two sines (reported).
    TwoSine(TwoSine),
    /// One sine on odd rows, its negative on even rows (reported as unrealistic).
    MirrorRows {
        /// Wavelength along x (m).
        length: f64,
    },
    /// The same sine on all rows (reported); its bands move to and fro and do not travel (derived).
    Swell {
        /// Wavelength along x (m).
        length: f64,
    },
    /// A phase that grows evenly along x, so the bands travel (chosen).
    Travelling {
        /// Wavelength along x (m).
        length: f64,
    },
    /// A phase that grows evenly with the distance from the origin, so rings travel outwards (chosen).
    Radial {
        /// Wavelength along the radius (m).
        length: f64,
    },
}

/// Two sines: one along x, the other along a direction turned from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoSine {
    /// Wavelengths of the two sines (m).
    pub lengths: [f64; 2],
    /// Azimuth along which the second sine runs (radians).
    pub turned: f64,
}

impl TwoSine {
    /// The two sines at `place` (m), each from -1 to 1.
    pub fn sines(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = quantities::sin_cos(self.turned);
        [sine(x, self.lengths[0]), sine(x * cos + y * sin, self.lengths[1])]
    }
}

impl Pattern {
    /// Refuses wavelengths that are not above 0, and angles that are not finite.
    ///
    /// # Errors
    /// Names the figure, its value and its range.
    pub fn check(&self) -> Result<(), FaceError> {
        let above = |length: f64| within("wavelength (m)", length, length > 0.0, "above 0");
        match self {
            Self::Random { .. } => Ok(()),
            Self::TwoSine(two) => {
                within("azimuth of the second sine (rad)", two.turned, true, "a finite number")?;
                two.lengths.into_iter().try_for_each(above)
            }
            Self::MirrorRows { length }
            | Self::Swell { length }
            | Self::Travelling { length }
            | Self::Radial { length } => above(*length),
        }
    }

    /// Number of the normal of `vertex`, from 0 to `count` - 1.
    pub fn number(&self, vertex: GridVertex, count: u32) -> u32 {
        let [x, y] = vertex.place;
        match *self {
            Self::Random { seed } => hashed(seed, vertex, count),
            Self::TwoSine(two) => numbered((two.sines(vertex.place).iter().sum::<f64>() + 2.0) / 4.0, count),
            Self::MirrorRows { length } if vertex.row % 2 == 0 => {
                numbered((2.0 - sine(x, length)) / 4.0, count)
            }
            Self::MirrorRows { length } | Self::Swell { length } => {
                numbered((sine(x, length) + 2.0) / 4.0, count)
            }
            Self::Travelling { length } => numbered(x.rem_euclid(length) / length, count),
            Self::Radial { length } => numbered((x * x + y * y).sqrt().rem_euclid(length) / length, count),
        }
    }
}

fn sine(x: f64, length: f64) -> f64 {
    libm::sin(TAU * x.rem_euclid(length) / length)
}

/// Number of a part of the table, 0 to 1; both ends are the same normal, because the cone closes.
fn numbered(part: f64, count: u32) -> u32 {
    (f64::from(count) * part).floor() as u32 % count
}

fn hashed(seed: u64, vertex: GridVertex, count: u32) -> u32 {
    let row = quantities::mix(quantities::mix(seed) ^ vertex.row as u64);
    let hash = quantities::mix(row ^ vertex.column as u64);
    (((hash >> 32) * u64::from(count)) >> 32) as u32
}
