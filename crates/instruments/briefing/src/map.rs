//! The map of the ground, north up.

use generator::Stage;
use glam::DVec3;
use landscape::Landscape;
use photo_drape::{Choice, Drape, Footprint, Ground};
use picture::{Depth, Encoder, GreyPicture, Transfer};
use rayon::prelude::*;

use crate::BriefingError;

/// How places of the ground lie on the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// North and east (m) of the upper left corner of the map.
    corner: [f64; 2],
    /// Side of a pixel (m).
    scale: f64,
}

impl Place {
    /// The largest scale at which the ground between `[south, west, north, east]` (m) fits into so many columns and lines, in their middle.
    pub fn fitting([south, west, north, east]: [f64; 4], [columns, lines]: [usize; 2]) -> Self {
        let size = [lines, columns].map(|count| count as f64);
        let scale = ((north - south) / size[0]).max((east - west) / size[1]);
        let middle = [(south + north) / 2.0, (west + east) / 2.0];
        let corner = [middle[0] + scale * size[0] / 2.0, middle[1] - scale * size[1] / 2.0];
        Self { corner, scale }
    }

    /// Side of a pixel (m).
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Column and line of a place (north, east; m); the middle of the first pixel is (0.5, 0.5).
    pub fn pixel(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        [(east - self.corner[1]) / self.scale, (self.corner[0] - north) / self.scale]
    }

    /// North and east (m) of a column and line.
    pub fn ground(&self, [column, line]: [f64; 2]) -> [f64; 2] {
        [self.corner[0] - line * self.scale, self.corner[1] + column * self.scale]
    }
}

/// The ground of a stage as large as its frames, in the greys of its display.
pub fn map(stage: &Stage, place: &Place) -> Result<GreyPicture, BriefingError> {
    let (view, landscape) = (&stage.view, &stage.landscape);
    let [columns, lines] = [view.columns, view.lines].map(|count| count as usize);
    let at = |pixel: usize| place.ground([pixel % columns, pixel / columns].map(|at| at as f64 + 0.5));
    let photographs = match landscape.photographs().is_empty() {
        true => None,
        false => {
            let ground = Ground::new(landscape, landscape.level().extent(), place.scale())?;
            Some(Drape::new(landscape, ground, Choice::Best)?)
        }
    };
    let sun = stage.scenery.sun(0.0);
    let light = |pixel: usize| match &photographs {
        Some(drape) => shown(drape, landscape, at(pixel)),
        None => {
            let [north, east] = at(pixel);
            landscape.at(north, east).map_or(0.0, |point| {
                point.albedo * sun.shade(point.slopes, [0.0, 0.0, 1.0], *landscape.photometry())
            })
        }
    };
    let lights: Vec<f32> = (0..columns * lines).into_par_iter().map(|pixel| light(pixel) as f32).collect();
    let transfer = Transfer::new(view.display.white as f32, view.display.gamma as f32)?;
    Ok(Encoder::new(transfer, Depth::Eight).encode(&lights, columns, lines)?)
}

/// Light that photographs show in a square of the ground as large as a post's cell; 0 where none does.
fn shown(drape: &Drape, landscape: &Landscape, [north, east]: [f64; 2]) -> f64 {
    let ground = drape.ground();
    let Some(height) = landscape.height(north, east) else { return 0.0 };
    let square = Footprint::square(ground.normal([north, east]), ground.spacing());
    drape.at(DVec3::new(north, east, height), &square).map_or(0.0, |shown| shown.light)
}
