//! Photograph and relief over one another, in map geometry.

use photograph::Photograph;
use picture::{ColourPicture, Curve, Depth, PictureError};
use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use crate::visible::Sight;
use crate::{Ground, Relief};

/// Longest side of the pictures (pixels, chosen).
const LONGEST: f64 = 1200.0;
/// Share of the pixels that are darker than white.
const BELOW_WHITE: f64 = 0.995;
/// Colour where a picture shows nothing.
const NOTHING: [u8; 3] = [18, 26, 52];
/// Colour of ground that the photograph does not show, because other ground hides it.
const HIDDEN: [u8; 3] = [96, 40, 110];
/// Curve from light to the codes of the pictures.
const CURVE: Curve = Curve::Srgb;

/// One pixel of both pictures.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Pixel {
    photo: Option<f64>,
    relief: Option<f64>,
    was_void: bool,
    is_hidden: bool,
}

/// Photograph and relief over the whole grid, north up.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    columns: usize,
    lines: usize,
    /// Metres a pixel, down and across.
    step: [f64; 2],
    pixels: Vec<Pixel>,
}

impl Overlay {
    /// The overlay of `photo` and `relief` over `ground`. `sample` is the photograph's ground sample (m), if it is known.
    pub fn new(ground: &Ground, photo: &Photograph, relief: &Relief, sample: Option<f64>) -> Self {
        let [lines, columns] = size(ground, sample);
        let sight = Sight::new(ground, photo);
        let line = |line: usize| {
            let pixel =
                |column: usize| pixel(&sight, photo, relief, place(ground, [line, column], [lines, columns]));
            (0..columns).map(pixel).collect::<Vec<_>>()
        };
        let pixels = (0..lines).into_par_iter().flat_map_iter(line).collect();
        let extent = extent(ground);
        Self { columns, lines, step: [extent[0] / lines as f64, extent[1] / columns as f64], pixels }
    }

    /// Columns and lines of both pictures.
    pub fn size(&self) -> [usize; 2] {
        [self.columns, self.lines]
    }

    /// Metres a pixel, down and across.
    pub fn step(&self) -> [f64; 2] {
        self.step
    }

    /// Light of photograph and relief at a pixel.
    pub fn lights(&self, column: usize, line: usize) -> [Option<f64>; 2] {
        let Pixel { photo, relief, .. } = self.pixels[line * self.columns + column];
        [photo, relief]
    }

    /// Share of the pixels within the photograph whose ground is hidden from the camera, 0 to 1.
    pub fn hidden(&self) -> f64 {
        let hidden = self.pixels.iter().filter(|pixel| pixel.is_hidden).count();
        let seen = self.pixels.iter().filter(|pixel| pixel.photo.is_some()).count();
        hidden as f64 / (hidden + seen).max(1) as f64
    }

    /// The photograph as the map shows it; former voids are tinted.
    ///
    /// # Errors
    /// Never, for a grid of two posts or more.
    pub fn photo(&self) -> Result<ColourPicture, PictureError> {
        self.picture(|pixel| pixel.photo)
    }

    /// The relief; former voids are tinted.
    ///
    /// # Errors
    /// Never, for a grid of two posts or more.
    pub fn relief(&self) -> Result<ColourPicture, PictureError> {
        self.picture(|pixel| pixel.relief)
    }

    fn picture(&self, light: impl Fn(&Pixel) -> Option<f64>) -> Result<ColourPicture, PictureError> {
        let white = white(self.pixels.iter().filter_map(&light).collect());
        let colour = |pixel: &Pixel| {
            let Some(light) = light(pixel) else { return if pixel.is_hidden { HIDDEN } else { NOTHING } };
            let grey = CURVE.code(light / white, Depth::Eight) as u8;
            if pixel.was_void { tinted(grey) } else { [grey; 3] }
        };
        let codes = self.pixels.iter().flat_map(|pixel| colour(pixel).map(u16::from)).collect();
        ColourPicture::new(self.columns, self.lines, Depth::Eight, codes)
    }
}

/// Lines and columns of the pictures: the finer of posts and photograph, but no side longer than [`LONGEST`].
fn size(ground: &Ground, sample: Option<f64>) -> [usize; 2] {
    let extent = extent(ground);
    let step = [0, 1].map(|axis| extent[axis] / (ground.size()[axis] - 1) as f64);
    let finest = sample.unwrap_or(f64::INFINITY).min(step[0]).min(step[1]);
    let pixel = finest.max(extent[0].max(extent[1]) / LONGEST);
    extent.map(|length| ((length / pixel).round() as usize).max(1))
}

/// Metres from the first to the last line and from the first to the last column of the grid, at its middle.
fn extent(ground: &Ground) -> [f64; 2] {
    let posts = ground.size();
    let step = ground.steps(0.5 * (posts[0] - 1) as f64);
    [0, 1].map(|axis| step[axis].abs() * (posts[axis] - 1) as f64)
}

/// Continuous line and column of the grid under the centre of a pixel.
fn place(ground: &Ground, pixel: [usize; 2], size: [usize; 2]) -> [f64; 2] {
    let forward = ground.begins_north_west();
    [0, 1].map(|axis| {
        let last = (ground.size()[axis] - 1) as f64;
        let at = (pixel[axis] as f64 + 0.5) / size[axis] as f64 * last;
        if forward[axis] { at } else { last - at }
    })
}

fn pixel(sight: &Sight<'_>, photo: &Photograph, relief: &Relief, at: [f64; 2]) -> Pixel {
    let ground = sight.ground();
    let Some(height) = ground.height_between(at) else { return Pixel::default() };
    let nearest = at.map(|at| at.round() as usize);
    let point = ground.point(at, height);
    let light = point.and_then(|point| photo.light_at(point));
    let is_hidden = light.is_some() && point.is_some_and(|point| sight.is_hidden(point));
    Pixel {
        photo: light.filter(|_| !is_hidden),
        relief: ground.between(at, |post| relief.light(post)),
        was_void: ground.was_void(nearest),
        is_hidden,
    }
}

/// The light that is shown white.
fn white(mut lights: Vec<f64>) -> f64 {
    lights.sort_unstable_by(f64::total_cmp);
    let at = (BELOW_WHITE * lights.len() as f64) as usize;
    lights.get(at.min(lights.len().saturating_sub(1))).copied().unwrap_or(1.0).max(1e-9)
}

/// Amber over a grey.
fn tinted(grey: u8) -> [u8; 3] {
    let mixed = |ink: u16| ((2 * u16::from(grey) + 3 * ink) / 5) as u8;
    [mixed(255), mixed(150), mixed(20)]
}
