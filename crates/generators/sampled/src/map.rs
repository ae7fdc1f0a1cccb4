//! The overload map: where a frame lost something to the limits of memory and time.

use generator::Loss;
use raster::Screen;

use crate::picture::{Picture, area_of};
use crate::session::Gathered;
use crate::tile::SIDE;

/// Fills the plane with the losses of each pixel. Lists and lateness are of whole sub-areas, whose readings `picture` must have; stacks
/// are of pixels; a lost light marks the pixel of its middle.
pub fn fill(plane: &mut [f32], picture: &Picture, gathered: &Gathered, screen: &Screen, late: &[bool]) {
    let [width, height] = screen.size().map(|pixels| pixels as usize);
    let mut areas: Vec<u8> = late.iter().map(|is_late| u8::from(*is_late) * Loss::Late.bit()).collect();
    picture.lost.iter().for_each(|lost| areas[lost.sub_area as usize] |= Loss::List.bit());
    let mut bits: Vec<u8> = (0..plane.len())
        .map(|at| {
            let area = area_of(at, width);
            let pixel = SIDE * (at / width % SIDE) + at % width % SIDE;
            let is_full = picture.readings[area].lost_in >> pixel & 1 == 1;
            areas[area] | u8::from(is_full) * Loss::Stack.bit()
        })
        .collect();
    let of_store = gathered.lost_points.iter().map(|point| point.middle);
    let of_beam = picture.beam.dropped.iter().map(|point| point.place);
    for [x, y] in of_store.chain(of_beam) {
        if (0.0..width as f64).contains(&x) && (0.0..height as f64).contains(&y) {
            bits[y as usize * width + x as usize] |= Loss::Light.bit();
        }
    }
    plane.iter_mut().zip(bits).for_each(|(value, bits)| *value = f32::from(bits));
}
