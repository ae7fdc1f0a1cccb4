//! Picture, placement, sun and grey curve together.

use std::path::Path;
use std::sync::Arc;

use glam::DVec3;
use photo_camera::Light;
use picture::{Curve, GreyPicture, Transfer};

use crate::sampling::bilinear;
use crate::{PhotoError, PhotoFile, Placement};

/// A photograph of the ground. Its picture is shared by all its copies.
#[derive(Debug, Clone, PartialEq)]
pub struct Photograph {
    picture: Arc<GreyPicture>,
    placement: Placement,
    /// Azimuth, clockwise from north, and elevation of the sun (rad).
    sun: Option<[f64; 2]>,
    transfer: Transfer,
    /// The light of each code.
    lights: Vec<f64>,
}

impl Photograph {
    /// The photograph of a picture of 8 or 16 bits under a camera or map. Without a grey curve in `light`, light is the level.
    ///
    /// # Errors
    ///
    /// If the grey curve is out of its range.
    pub fn new(picture: GreyPicture, placement: Placement, light: Light) -> Result<Self, PhotoError> {
        let [white, gamma] = light.grey().unwrap_or([1.0; 2]);
        let transfer = Transfer::new(white as f32, gamma as f32)?;
        let depth = picture.depth();
        let lights = (0..=depth.white()).map(|code| f64::from(transfer.intensity(code, depth))).collect();
        Ok(Self { picture: Arc::new(picture), placement, sun: light.sun(), transfer, lights })
    }

    /// Reads a picture file (PNG, JPEG or TIFF) and its camera file.
    ///
    /// # Errors
    ///
    /// If one of the files cannot be read, or is not what it should be.
    pub fn read(picture: &Path, camera: &Path) -> Result<Self, PhotoError> {
        let PhotoFile { placement, light } = PhotoFile::read(camera)?;
        // The camera file says what light the codes are, whatever the picture says.
        let picture = photographs::read_map(picture, Curve::Power(1.0))?;
        Self::new(picture.to_grey(photographs::CURVE), placement, light)
    }

    /// The picture of grey codes.
    pub fn picture(&self) -> &GreyPicture {
        &self.picture
    }

    /// How its pixels lie on the ground.
    pub fn placement(&self) -> &Placement {
        &self.placement
    }

    /// Azimuth, clockwise from north, and elevation of the sun that lit the ground (rad), where it is known.
    pub fn sun(&self) -> Option<[f64; 2]> {
        self.sun
    }

    /// The curve from light to codes.
    pub fn transfer(&self) -> Transfer {
        self.transfer
    }

    /// Pixel I, J of a ground point, inside the picture or not; none behind the camera.
    pub fn pixel(&self, point: DVec3) -> Option<[f64; 2]> {
        self.placement.pixel(point)
    }

    /// Whether a pixel I, J lies inside the picture.
    pub fn holds(&self, [i, j]: [f64; 2]) -> bool {
        let (columns, lines) = (self.picture.columns() as f64, self.picture.lines() as f64);
        (0.0..columns).contains(&i) && (0.0..lines).contains(&j)
    }

    /// Level, 0 to 1, at a pixel I, J; none outside the picture.
    pub fn level(&self, pixel: [f64; 2]) -> Option<f64> {
        let white = f64::from(self.picture.depth().white());
        bilinear(&self.picture, pixel, |code| f64::from(code) / white)
    }

    /// Light, 0 to the white of the grey curve, at a pixel I, J; none outside the picture.
    pub fn light(&self, pixel: [f64; 2]) -> Option<f64> {
        bilinear(&self.picture, pixel, |code| self.lights[usize::from(code)])
    }

    /// Light of a pixel by its column and line.
    ///
    /// # Panics
    /// If the picture has no such pixel.
    pub fn light_of(&self, column: usize, line: usize) -> f64 {
        self.lights[usize::from(self.picture.code(column, line))]
    }

    /// Light at a ground point; none beside the picture or behind the camera.
    pub fn light_at(&self, point: DVec3) -> Option<f64> {
        self.light(self.pixel(point)?)
    }

    /// The ground under the corners of the picture at a `height` (m): upper left, upper right, lower right, lower left. None
    /// for a corner that looks past the ground.
    pub fn footprint(&self, height: f64) -> [Option<DVec3>; 4] {
        let [columns, lines] = [self.picture.columns(), self.picture.lines()].map(|count| count as f64);
        [[0.0, 0.0], [columns, 0.0], [columns, lines], [0.0, lines]]
            .map(|corner| self.placement.on_level(corner, height))
    }
}
