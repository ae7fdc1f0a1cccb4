//! Spots of calligraphic points: a beam of their own draws them over the finished picture.

use std::ops::Range;

use light_points::Spot;

use super::matter::Lamp;
use crate::column::Pixel;

/// Farther from its middle than this (pixels) no spot is drawn: seven standard deviations and the rest of a pixel.
const REACH: f64 = 7.0 * Spot::DEFAULT_SIGMA + 1.0;

/// Some columns of a picture.
pub struct Beams<'a> {
    /// Columns and lines of the whole picture.
    pub size: [usize; 2],
    /// Number of the first column.
    pub first: usize,
    /// The columns, top line first.
    pub columns: &'a mut [Vec<Pixel>],
}

impl Beams<'_> {
    /// Adds a spot with this share of the light of a point.
    pub fn draw(&mut self, lamp: &Lamp, share: f64) {
        let Ok(spot) = Spot::new(Spot::DEFAULT_SIGMA) else { return };
        let size = self.size.map(|size| size as u32);
        spot.draw(lamp.middle, lamp.light * share, size, |[column, line], part| {
            let column = (column as usize).checked_sub(self.first).and_then(|at| self.columns.get_mut(at));
            let pixel = column.and_then(|pixels| pixels.get_mut(line as usize));
            let Some(pixel) = pixel else { return };
            pixel.light = [0, 1, 2].map(|k| pixel.light[k] + part * lamp.colour[k]);
        });
    }
}

/// Whether a spot with its middle at `x` (pixels) can reach some of these columns.
pub fn reaches(x: f64, columns: &Range<usize>) -> bool {
    x + REACH >= columns.start as f64 && x - REACH <= columns.end as f64
}
