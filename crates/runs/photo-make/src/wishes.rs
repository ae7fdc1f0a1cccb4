//! What a photograph is to be.

use std::f64::consts::{FRAC_PI_2, PI};

use picture::{Depth, Transfer};

use crate::MakeError;

/// How far away the camera stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reach {
    /// Height of the camera above the ground in the picture's middle (m).
    Height(f64),
    /// Horizontal field of view (rad): the angle between the left and the right edge of the picture.
    Field(f64),
}

/// What a photograph is to be.
#[derive(Debug, Clone, PartialEq)]
pub struct Wishes {
    /// Place in the picture's middle: north, east (m).
    pub centre: [f64; 2],
    /// Columns and lines, each 1 or more.
    pub size: [u32; 2],
    /// Side of a pixel at the picture's middle, across the optical axis (m), above 0.
    pub ground_sample: f64,
    /// How far away the camera stands.
    pub reach: Reach,
    /// Focal length (m), above 0; with the rest it decides the size of a pixel in the image plane.
    pub focal_length: f64,
    /// Azimuth of the optical axis, clockwise from north (rad). In a vertical picture it points to the upper edge.
    pub heading: f64,
    /// Elevation of the optical axis (rad), from -pi/2, straight down, to below 0.
    pub pitch: f64,
    /// Turn about the optical axis (rad), positive for the right side down.
    pub roll: f64,
    /// Time of the scenario (s).
    pub time: f64,
    /// Bits of a code.
    pub depth: Depth,
    /// The curve from light to codes.
    pub transfer: Transfer,
    /// Standard deviation of the noise as a share of the curve's white, 0 or more.
    pub noise: f64,
    /// Seed of the noise.
    pub seed: u64,
}

impl Wishes {
    /// Refuses figures that make no photograph.
    ///
    /// # Errors
    /// The first figure out of its range.
    pub fn check(&self) -> Result<(), MakeError> {
        let figure = |what, found: f64, expected, holds: bool| match found.is_finite() && holds {
            true => Ok(()),
            false => Err(MakeError::Wish { what, found, expected }),
        };
        let above = "a finite number above 0";
        figure("ground sample (m)", self.ground_sample, above, self.ground_sample > 0.0)?;
        figure("focal length (m)", self.focal_length, above, self.focal_length > 0.0)?;
        match self.reach {
            Reach::Height(height) => figure("height (m)", height, above, height > 0.0)?,
            Reach::Field(field) => {
                let is_angle = field > 0.0 && field < PI;
                figure("field of view (rad)", field, "an angle above 0 and below pi", is_angle)?;
            }
        }
        let looks_down = (-FRAC_PI_2..0.0).contains(&self.pitch);
        figure("pitch (rad)", self.pitch, "an angle from -pi/2 to below 0", looks_down)?;
        for (what, found) in [
            ("heading (rad)", self.heading),
            ("roll (rad)", self.roll),
            ("time (s)", self.time),
            ("north of the centre (m)", self.centre[0]),
            ("east of the centre (m)", self.centre[1]),
        ] {
            figure(what, found, "a finite number", true)?;
        }
        figure("noise", self.noise, "a finite number of 0 or more", self.noise >= 0.0)
    }
}
