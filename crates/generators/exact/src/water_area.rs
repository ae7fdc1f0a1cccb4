//! Light of water as the mean over the area of a pixel.

use generator::Label;

use crate::column::Pixel;
use crate::effects::{Opaque, Screen, sub_rays};
use crate::scene::Scene;

/// Light of five places of a pixel that differs by no more than this is even over the pixel (chosen).
const EVEN: f64 = 1.0 / 1024.0;

/// Gives the pixels of a column, top line first, the mean light over their area where they show the water; returns the rays that it took.
pub fn area_means(scene: &Scene, screen: &Screen, column: usize, pixels: &mut [Pixel]) -> u64 {
    let mut surface = Opaque::beside_faces(scene, screen, column);
    let is_water: Vec<bool> = pixels.iter().map(|pixel| pixel.seen.label == Label::Sea).collect();
    for (line, pixel) in pixels.iter_mut().enumerate() {
        let beside = line.saturating_sub(1)..(line + 2).min(is_water.len());
        if is_water[beside].contains(&true) {
            pixel.light = area_mean([column, line], &mut surface);
        }
    }
    surface.rays()
}

/// Mean light over the area of a pixel.
fn area_mean(pixel: [usize; 2], surface: &mut Opaque) -> [f64; 3] {
    let place = |within: [f64; 2]| [0, 1].map(|axis| pixel[axis] as f64 + within[axis]);
    let five = [[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let five = five.map(|within| surface.seen(place(within)).light);
    let is_even = (0..3).all(|channel| five.iter().all(|of| (of[channel] - five[0][channel]).abs() <= EVEN));
    if is_even {
        return mean(five.into_iter());
    }
    mean(sub_rays().map(|within| surface.seen(place(within)).light))
}

fn mean(lights: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for light in lights {
        sum = [0, 1, 2].map(|channel| sum[channel] + light[channel]);
        count += 1.0;
    }
    sum.map(|channel| channel / count)
}
