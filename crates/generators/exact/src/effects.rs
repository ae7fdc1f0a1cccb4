//! What a scene has beside ground and bodies, over the opaque picture: lamps, stars, sheets, overlays, discs of the sky.

mod beams;
mod circle;
mod column;
mod lattice;
mod matter;
mod mean;
mod outline;
mod part;
mod placing;
mod run;
mod screen;
mod stack;

use rayon::prelude::*;
use scenario::{Effects, FieldOfView};

use beams::Beams;
use matter::Feature;
use part::{Part, Parts};
use placing::Placing;
use stack::{Mix, Stack};

use crate::column::Pixel;
use crate::scene::Scene;
use crate::view::View;

pub use column::Opaque;
pub use lattice::{SUB_RAYS, sub_rays};
pub use screen::Screen;
pub use stack::Surface;

/// The effects of a frame on the screen.
#[derive(Debug)]
pub struct Layer<'a> {
    scene: &'a Scene<'a>,
    features: Features,
}

impl<'a> Layer<'a> {
    /// The effects of a scene in a picture of `size` (columns, lines); `None` if there are none.
    pub fn new(
        scene: &'a Scene<'a>,
        effects: &Effects,
        size: [usize; 2],
        field: FieldOfView,
    ) -> Option<Self> {
        if effects.is_empty() {
            return None;
        }
        let (screen, view) = (Screen::new(size, field), *scene.view());
        let placing = Placing { outlook: scene.outlook(), view: &view, screen };
        let features = Features::new(placing.features(effects), screen, view);
        Some(Self { scene, features })
    }

    /// Draws what is not calligraphic over a column, top line first, and returns the rays that it took.
    pub fn over(&self, column: usize, pixels: &mut [Pixel]) -> u64 {
        let mut surface = Opaque::new(self.scene, &self.features.screen, column);
        for (line, pixel) in pixels.iter_mut().enumerate() {
            let Some(mix) = self.features.mix([column, line], false, &mut surface) else { continue };
            pixel.light = [0, 1, 2].map(|k| mix.added[k] + mix.through[k] * pixel.light[k]);
            pixel.seen.label = mix.label.unwrap_or(pixel.seen.label);
        }
        surface.rays()
    }

    /// Draws calligraphic points over columns from the number `first` on, and returns the rays that it took.
    pub fn beam(&self, first: usize, columns: &mut [Vec<Pixel>]) -> u64 {
        let points = self.features.beams(first..first + columns.len());
        let reached: Vec<_> = points.par_iter().map(|&index| self.reached(index)).collect();
        let mut beams = Beams { size: self.features.screen.size(), first, columns };
        for (&index, (share, _)) in points.iter().zip(&reached) {
            self.features.all[index].beam().into_iter().for_each(|lamp| beams.draw(lamp, *share));
        }
        reached.iter().map(|(_, rays)| rays).sum()
    }

    /// Share of the light of a calligraphic point that reaches the eye, and the rays that it took.
    fn reached(&self, index: usize) -> (f64, u64) {
        let ([[left, top], [right, bottom]], mut rays) = (self.features.pixels(index), 0);
        let (mut aperture, mut visible) = (0.0, 0.0);
        for column in left..right {
            let mut surface = Opaque::new(self.scene, &self.features.screen, column);
            for line in top..bottom {
                let mix = self.features.mix([column, line], true, &mut surface);
                let beams = mix.map(|mix| mix.beams).unwrap_or_default();
                for reached in beams.iter().filter(|reached| reached.index == index) {
                    aperture += reached.aperture;
                    visible += reached.visible;
                }
            }
            rays += surface.rays();
        }
        // Outside the screen nothing is known of the point: what is inside speaks for all.
        (if aperture > 0.0 { visible / aperture } else { 0.0 }, rays)
    }
}

/// Everything that is drawn over the opaque picture.
#[derive(Debug)]
struct Features {
    all: Vec<Feature>,
    /// Pixels (low to below high) in which each lies.
    pixels: Vec<[[usize; 2]; 2]>,
    /// Numbers of those in each column, ascending.
    columns: Vec<Vec<usize>>,
    screen: Screen,
    view: View,
}

impl Features {
    fn new(all: Vec<Feature>, screen: Screen, view: View) -> Self {
        let size = screen.size();
        let pixels: Vec<_> =
            all.iter().map(|feature| within(feature.outline.bounds(&screen), size)).collect();
        let mut columns = vec![Vec::new(); size[0]];
        for (index, [low, high]) in pixels.iter().enumerate() {
            columns[low[0]..high[0]].iter_mut().for_each(|column| column.push(index));
        }
        Self { all, pixels, columns, screen, view }
    }

    fn pixels(&self, index: usize) -> [[usize; 2]; 2] {
        self.pixels[index]
    }

    /// Calligraphic points whose spots can reach some of these columns.
    fn beams(&self, columns: std::ops::Range<usize>) -> Vec<usize> {
        let reaches =
            |feature: &Feature| feature.beam().is_some_and(|lamp| beams::reaches(lamp.middle[0], &columns));
        (0..self.all.len()).filter(|&index| reaches(&self.all[index])).collect()
    }

    /// What things make of a pixel; `None` if there are none. Calligraphic points are among them on demand.
    fn mix(&self, pixel: [usize; 2], with_beams: bool, surface: &mut impl Surface) -> Option<Mix> {
        let low = pixel.map(|at| at as f64);
        let part = |&index: &usize| {
            let ([from, to], feature) = (self.pixels[index], &self.all[index]);
            if pixel[1] < from[1] || pixel[1] >= to[1] || (!with_beams && feature.beam().is_some()) {
                return None;
            }
            let share = feature.outline.share(&self.screen, low);
            (share > 0.0).then(|| Part::new(feature, index, share))
        };
        let parts: Parts = self.columns[pixel[0]].iter().filter_map(part).collect();
        let stack = Stack { screen: &self.screen, view: &self.view, low, parts };
        (!stack.parts.is_empty()).then(|| stack.mix(surface))
    }
}

/// Pixels (low to below high) of a picture of `size` that a box (pixels) meets; the conversion saturates.
fn within([low, high]: [[f64; 2]; 2], size: [usize; 2]) -> [[usize; 2]; 2] {
    let high = [0, 1].map(|axis| (high[axis].ceil().max(0.0) as usize).min(size[axis]));
    [[0, 1].map(|axis| (low[axis].floor().max(0.0) as usize).min(high[axis])), high]
}

#[cfg(test)]
mod tests;
