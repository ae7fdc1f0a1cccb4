//! A beam's spot in the pixels of a frame.

use std::f64::consts::SQRT_2;

use crate::error::{LightError, checked};

/// How far from its middle a spot is drawn (standard deviations). Chosen: less than 1e-11 of its light lies beyond.
const REACH: f64 = 7.0;

/// A Gaussian spot, integrated over each pixel.
///
/// Taken at the middles of pixels instead, the sum over all pixels of a spot of 0.6 pixel would change from 0.9967 to 1.0033 as it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    sigma: f64,
}

impl Spot {
    /// Standard deviation without a wish (pixels). Chosen: no figure of a display is known.
    pub const DEFAULT_SIGMA: f64 = 0.6;

    /// A spot of a standard deviation (pixels, above 0 to 100).
    ///
    /// # Errors If the deviation is out of range or not finite.
    pub fn new(sigma: f64) -> Result<Self, LightError> {
        let holds = |sigma| sigma > 0.0 && sigma <= 100.0;
        Ok(Self { sigma: checked("deviation of a spot (pixels)", sigma, "above 0 to 100", holds)? })
    }

    /// Light a pixel squared in the middle of a spot of this much `light` (intensity times pixels squared).
    pub fn peak_density(&self, light: f64) -> f64 {
        light / (2.0 * std::f64::consts::PI * self.sigma * self.sigma)
    }

    /// Calls `add` with every pixel (column, row) of a screen of `size` (pixels) that a spot reaches, and its part of the `light`.
    pub fn draw(&self, middle: [f64; 2], light: f64, size: [u32; 2], mut add: impl FnMut([u32; 2], f64)) {
        let reached = |axis: usize| {
            let [low, high] = [-REACH, REACH].map(|reach| (middle[axis] + reach * self.sigma).floor());
            // Conversion saturates: a spot far outside reaches no pixel.
            (low.max(0.0) as u32)..((high + 1.0).max(0.0) as u32).min(size[axis])
        };
        for row in reached(1) {
            let part = light * self.within(middle[1], row);
            for column in reached(0) {
                add([column, row], part * self.within(middle[0], column));
            }
        }
    }

    /// Share of the light along one axis that falls into a pixel.
    fn within(&self, middle: f64, pixel: u32) -> f64 {
        let upto = |at: f64| libm::erf((at - middle) / (self.sigma * SQRT_2));
        (upto(f64::from(pixel) + 1.0) - upto(f64::from(pixel))) / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spot_keeps_its_light_wherever_it_lies() {
        let spot = Spot::new(Spot::DEFAULT_SIGMA).unwrap();
        for step in 0..100 {
            let middle = [9.0 + f64::from(step) / 100.0, 9.0 + f64::from(step * 37 % 100) / 100.0];
            let mut sum = 0.0;
            spot.draw(middle, 3.0, [20, 20], |_, light| sum += light);
            assert!((sum / 3.0 - 1.0).abs() < 2e-11, "{sum} at {middle:?}");
        }
    }

    #[test]
    fn a_spot_lies_in_its_pixel_and_ends_with_the_screen() {
        let spot = Spot::new(0.6).unwrap();
        let mut pixels = vec![0.0; 30];
        spot.draw([2.5, 3.5], 1.0, [5, 6], |[x, y], light| pixels[(y * 5 + x) as usize] += light);
        let middle = 3 * 5 + 2;
        // erf(0.5 / (0.6 sqrt 2)) squared: the middle pixel of a spot in its middle.
        assert!((pixels[middle] - 0.354_433_571_118_904).abs() < 1e-12, "{}", pixels[middle]);
        assert_eq!((pixels[middle - 1], pixels[middle - 5]), (pixels[middle + 1], pixels[middle + 5]));
        for far in [[-1e9, 3.0], [3.0, 1e300], [-5.0, -5.0]] {
            spot.draw(far, 1.0, [5, 6], |_, light| assert!(light < 1e-9, "{light}"));
        }
    }

    #[test]
    fn peak_of_the_check_values() {
        let area = std::f64::consts::PI * 1.5 * 1.5 / 4.0;
        assert!((Spot::new(0.6).unwrap().peak_density(0.405 * area) - 0.31640625).abs() < 1e-15);
        for wrong in [0.0, -1.0, f64::NAN, 101.0] {
            assert!(Spot::new(wrong).is_err());
        }
    }
}
