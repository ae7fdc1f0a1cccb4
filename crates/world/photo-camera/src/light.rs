//! The light of a photograph: its sun, and the curve of its greys.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::CameraError;

/// Sun and grey curve of a photograph, as far as they are known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Light {
    sun: Option<[f64; 2]>,
    grey: Option<[f64; 2]>,
}

impl Light {
    /// The light of a sun at azimuth and elevation (rad), and of a grey curve of white and gamma.
    ///
    /// # Errors
    ///
    /// If a figure is out of its range: the key of the camera file, and the figure.
    pub fn new(sun: Option<[f64; 2]>, grey: Option<[f64; 2]>) -> Result<Self, (&'static str, CameraError)> {
        if let Some([azimuth, elevation]) = sun {
            let key = |error| ("sun_azimuth_elevation_rad", error);
            let turn = "radians, from -2 pi to 2 pi";
            CameraError::figure("azimuth of the sun (rad)", azimuth, turn, |a| a.abs() <= TAU)
                .map_err(key)?;
            let range = "a number from -pi/2 to pi/2";
            CameraError::figure("elevation of the sun (rad)", elevation, range, |e| e.abs() <= FRAC_PI_2)
                .map_err(key)?;
        }
        if let Some([white, gamma]) = grey {
            let key = |error| ("grey_white_gamma", error);
            CameraError::figure("white of the grey curve", white, "a number from 1e-6 to 1e6", |w| {
                (1e-6..=1e6).contains(&w)
            })
            .map_err(key)?;
            CameraError::figure("gamma of the grey curve", gamma, "a number from 0.25 to 4", |g| {
                (0.25..=4.0).contains(&g)
            })
            .map_err(key)?;
        }
        Ok(Self { sun, grey })
    }

    /// Azimuth, clockwise from north, and elevation of the sun (rad). North is that of the body at the photograph, or of the
    /// landscape.
    pub fn sun(&self) -> Option<[f64; 2]> {
        self.sun
    }

    /// White and gamma of the grey curve: a code is `(light / white)^(1 / gamma)` of the largest code.
    pub fn grey(&self) -> Option<[f64; 2]> {
        self.grey
    }
}
