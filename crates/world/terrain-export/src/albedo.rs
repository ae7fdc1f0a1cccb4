//! Albedo of a landscape as a picture, and on its posts.

use picture::{AnyPicture, Depth, Picture, PictureError};
use quantities::intensity;
use rayon::prelude::*;
use terrain_builder::{Grid, Textures};

/// Pixels of a cell along one direction at most, and of the picture (chosen).
const MOST_A_CELL: usize = 8;
const MOST_PIXELS: usize = 8192;

/// Pixels of a cell along one direction: as many as the finest texel asks for, as far as the picture may be so large.
pub(crate) fn pixels_a_cell(textures: &Textures, grid: &Grid) -> usize {
    let cells = grid.north.cells.max(grid.east.cells);
    let wanted = textures.finest_texel().map_or(1.0, |texel| (grid.north.resolution / texel).ceil());
    (wanted as usize).clamp(1, MOST_A_CELL).min((MOST_PIXELS / cells).max(1))
}

/// The albedo of the ground from above, north at the top: 16 bits, linear, grey unless a texture has colour. It is 1 where no texture
/// lies.
///
/// # Errors
/// If the picture would be too large.
pub(crate) fn picture(textures: &Textures, grid: &Grid) -> Result<AnyPicture, PictureError> {
    let density = pixels_a_cell(textures, grid);
    let [lines, columns] = [&grid.north, &grid.east].map(|axis| axis.cells * density);
    let ([low, high], step) = (grid.extent(), grid.north.resolution / density as f64);
    let albedo = |pixel: usize| {
        let [down, right] = [pixel / columns, pixel % columns].map(|at| (at as f64 + 0.5) * step);
        at(textures, [(high[0] - down).max(low[0]), (low[1] + right).min(high[1])])
    };
    let pixels: Vec<[u16; 3]> =
        (0..lines * columns).into_par_iter().map(|pixel| albedo(pixel).map(code)).collect();
    let (size, depth) = ([columns, lines], Depth::Sixteen);
    if textures.is_colourful() {
        let codes = pixels.into_iter().flatten().collect();
        return Picture::new(size[0], size[1], depth, codes).map(AnyPicture::Colour);
    }
    let codes = pixels.into_iter().map(|[grey, ..]| grey).collect();
    Picture::new(size[0], size[1], depth, codes).map(AnyPicture::Grey)
}

/// Luminance of the albedo on every post, in 16 bits: row by row from the south.
pub(crate) fn posts(textures: &Textures, grid: &Grid) -> Vec<u16> {
    let [rows, columns] = grid.size();
    let post = |index: usize| code(intensity(at(textures, grid.place(index / columns, index % columns))));
    (0..rows * columns).into_par_iter().map(post).collect()
}

/// Albedo at a place: north, east (m); 1 where no texture lies.
pub(crate) fn at(textures: &Textures, place: [f64; 2]) -> [f64; 3] {
    textures.at(place).unwrap_or([1.0; 3])
}

fn code(albedo: f64) -> u16 {
    (albedo * f64::from(u16::MAX)).round() as u16
}
