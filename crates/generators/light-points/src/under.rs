//! Sampling points under a disc.

use raster::Sampling;

/// Sampling points of a pixel (column, row; on the screen or beside it) that a disc covers, as bits in the order of the pattern.
/// Middle and diameter are in pixels. Points on the rim count. Chosen: no pattern's figures tell it apart.
pub fn mask_under(middle: [f64; 2], diameter: f64, pixel: [i32; 2], sampling: &Sampling) -> u32 {
    let squared = diameter * diameter / 4.0;
    let covers = |[x, y]: [f64; 2]| {
        let [x, y] = [x - middle[0], y - middle[1]];
        x * x + y * y <= squared
    };
    sampling.places(pixel).enumerate().fold(0, |bits, (i, place)| bits | u32::from(covers(place)) << i)
}

/// How many sampling points a disc covers, those beside the screen too: a lamp that leaves the screen would grow brighter if only
/// the points on the screen counted. Middle and diameter are in pixels, within a million of the screen.
pub fn count_under(middle: [f64; 2], diameter: f64, sampling: &Sampling) -> u32 {
    let range = |axis: usize| {
        let [low, high] = [-0.5, 0.5].map(|half| (middle[axis] + half * diameter).floor() as i32);
        low..=high
    };
    let pixels = range(1).flat_map(|row| range(0).map(move |column| [column, row]));
    pixels.map(|pixel| mask_under(middle, diameter, pixel, sampling).count_ones()).sum()
}
