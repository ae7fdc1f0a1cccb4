//! The table of false normals: a cone about the vertical.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;
use quantities::sin_cos;

use crate::error::{FaceError, within};
use crate::warning::Warning;

/// `count` unit normals on a cone about the vertical, each `alpha` radians above the horizontal (reported).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    count: u32,
    alpha: f64,
}

impl Cone {
    /// A cone of 2 normals or more, `alpha` above 0 and at most a quarter turn (radians).
    ///
    /// # Errors
    /// If a figure is out of range.
    pub fn new(count: u32, alpha: f64) -> Result<Self, FaceError> {
        within("number of normals", f64::from(count), count >= 2, "2 or more")?;
        let allowed = alpha > 0.0 && alpha <= FRAC_PI_2;
        within("angle of the normals above the horizontal (rad)", alpha, allowed, "above 0, pi / 2 at most")?;
        Ok(Self { count, alpha })
    }

    /// Number of normals in the table.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Angle of each normal above the horizontal (radians).
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// Azimuth of normal `number` (radians), a whole part of one turn.
    pub fn azimuth(&self, number: u32) -> f64 {
        TAU * f64::from(number % self.count) / f64::from(self.count)
    }

    /// Unit normal `number`: north, east, up. Numbers beyond the table begin again.
    pub fn normal(&self, number: u32) -> DVec3 {
        let (sin, cos) = sin_cos(self.azimuth(number));
        let (up, out) = sin_cos(self.alpha);
        DVec3::new(cos * out, sin * out, up)
    }

    /// Mean brightness over a turn of a sun at `elevation` (radians), where nothing is clamped.
    pub fn mean(&self, elevation: f64) -> f64 {
        sin_cos(self.alpha).0 * sin_cos(elevation).0
    }

    /// Amplitude of the brightness under a sun at `elevation` (radians), where nothing is clamped.
    pub fn amplitude(&self, elevation: f64) -> f64 {
        sin_cos(self.alpha).1 * sin_cos(elevation).1
    }

    /// Contrast under a sun at `elevation` (radians): amplitude over mean, `cot alpha cot elevation` (derived).
    pub fn contrast(&self, elevation: f64) -> f64 {
        self.amplitude(elevation) / self.mean(elevation)
    }

    /// Elevation of the sun (radians) that gives `contrast`, at most 1: more would clamp the troughs to black.
    ///
    /// # Errors
    /// If the contrast is not from 0 to 1.
    pub fn elevation_of(&self, contrast: f64) -> Result<f64, FaceError> {
        within("contrast", contrast, (0.0..=1.0).contains(&contrast), "from 0 to 1")?;
        let (sin, cos) = sin_cos(self.alpha);
        Ok(libm::atan2(cos, contrast * sin))
    }

    /// Troughs that a sun at `elevation` (radians) clamps to black, and normals without contrast.
    pub fn warnings(&self, elevation: f64) -> Vec<Warning> {
        let sum = self.alpha + elevation;
        let none = (self.amplitude(0.0) == 0.0).then_some(Warning::NoContrast);
        let clipped = (sum < FRAC_PI_2 - 1e-12).then_some(Warning::Clipped { sum });
        none.into_iter().chain(clipped).collect()
    }
}
