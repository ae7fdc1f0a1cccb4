//! A picture of a landscape from above.

use picture::{Depth, GreyPicture, PictureError};
use quantities::intensity;
use rayon::prelude::*;
use terrain_builder::{Ground, Textures};

use crate::albedo;

/// Grey of full light.
const WHITE: f64 = 255.0;

/// The ground from above, north at the top, shaded by its slope to a sun of a direction (north, east, up; unit vector) and darkened where
/// its textures are darker than elsewhere. The longer side has `longest` pixels. Shadows that the ground casts are left out, and boulders.
///
/// # Errors
/// If there are no pixels.
pub fn shaded(
    ground: &Ground,
    textures: &Textures,
    sun: [f64; 3],
    longest: usize,
) -> Result<GreyPicture, PictureError> {
    let [low, high] = ground.description().grid.extent();
    let size = [0, 1].map(|axis| high[axis] - low[axis]);
    let pixel = size[0].max(size[1]) / longest as f64;
    let [lines, columns] = size.map(|length| ((length / pixel).round() as usize).max(1));
    let place = |line: usize, column: usize| {
        let [south, east] = [line, column].map(|at| (at as f64 + 0.5) * pixel);
        [(high[0] - south).max(low[0]), (low[1] + east).min(high[1])]
    };
    let heights: Vec<f64> = (0..(lines + 1) * (columns + 1))
        .into_par_iter()
        .map(|index| ground.height(place(index / (columns + 1), index % (columns + 1))))
        .collect();
    let albedo = |index: usize| intensity(albedo::at(textures, place(index / columns, index % columns)));
    let albedos: Vec<f64> = (0..lines * columns).into_par_iter().map(albedo).collect();
    // The brightest ground has all of its light: dark soil is not a dark picture.
    let brightest = albedos.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let code = |index: usize| {
        let at = index / columns * (columns + 1) + index % columns;
        let slope =
            [heights[at] - heights[at + columns + 1], heights[at + 1] - heights[at]].map(|rise| rise / pixel);
        (WHITE * (albedos[index] / brightest) * share(slope, sun)).round() as u16
    };
    GreyPicture::new(columns, lines, Depth::Eight, (0..lines * columns).map(code).collect())
}

/// Cosine between the sun and the normal of a slope (rise over run to the north and to the east), at least 0.
fn share([north, east]: [f64; 2], sun: [f64; 3]) -> f64 {
    let length = (north * north + east * east + 1.0).sqrt();
    ((sun[2] - north * sun[0] - east * sun[1]) / length).max(0.0)
}
