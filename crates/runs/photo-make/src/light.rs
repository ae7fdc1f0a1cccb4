//! From the light of the ground to the codes of a picture.

use std::f64::consts::PI;

use picture::{Encoder, GreyPicture};
use quantities::{sin_cos, unit_interval};

use crate::{MakeError, Wishes};

/// The picture of a plane of light, line by line, with the noise that `wishes` ask for.
pub fn coded(light: &[f32], wishes: &Wishes) -> Result<GreyPicture, MakeError> {
    let [columns, lines] = wishes.size.map(|count| count as usize);
    let encoder = Encoder::new(wishes.transfer, wishes.depth);
    if wishes.noise == 0.0 {
        return Ok(encoder.encode(light, columns, lines)?);
    }
    let deviation = wishes.noise * f64::from(wishes.transfer.white());
    let noisy =
        |(pixel, light): (usize, &f32)| light + (deviation * normal(wishes.seed, pixel as u64)) as f32;
    let noisy: Vec<f32> = light.iter().enumerate().map(noisy).collect();
    Ok(encoder.encode(&noisy, columns, lines)?)
}

/// A number of the normal distribution of mean 0 and deviation 1 (Box and Muller 1958), the same for a seed and a pixel.
fn normal(seed: u64, pixel: u64) -> f64 {
    // Above 0, so that there is a logarithm.
    let radius = (-2.0 * libm::log(1.0 - unit_interval(seed, &[pixel, 0]))).sqrt();
    let (_, cos) = sin_cos(2.0 * PI * unit_interval(seed, &[pixel, 1]));
    radius * cos
}
