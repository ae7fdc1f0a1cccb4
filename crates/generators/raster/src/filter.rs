//! Weights with which sampling points make a pixel.

use crate::pattern::{OFFSET_UNIT, Pattern};

/// Standard deviation of the Gaussian filter (pixels). Chosen: its cut at 1 pixel lies at two deviations.
const SIGMA: f64 = 0.5;

/// How the sampling points around a pixel are averaged, in linear light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Filter {
    /// The pixel's own points, all alike.
    Box,
    /// Points within 1 pixel of the middle along both axes, less by distance along each axis.
    Tent,
    /// Points as of the tent, by a Gaussian of 0.5 pixel.
    Gaussian,
}

/// Weights of the points of 3 x 3 pixels for the middle one.
///
/// They belong to a pattern that is the same in every pixel: for turned ones the sum would differ from pixel to pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Weights {
    /// By pixel, row by row from the top left, then by sampling point.
    weights: Vec<f64>,
    samples: usize,
}

impl Filter {
    /// The weights of this filter over a pattern; their sum is 1.
    pub fn weights(self, pattern: Pattern) -> Weights {
        let offsets = pattern.offsets();
        let neighbours = (-1..=1).flat_map(|row| (-1..=1).map(move |column| [column, row]));
        let raw = neighbours.flat_map(|pixel| offsets.iter().map(move |&offset| self.at(pixel, offset)));
        let raw: Vec<f64> = raw.collect();
        let sum: f64 = raw.iter().sum();
        Weights { weights: raw.iter().map(|weight| weight / sum).collect(), samples: offsets.len() }
    }

    /// The weight, not yet scaled, of an offset (1/64 pixel) in a pixel counted from the middle one.
    fn at(self, pixel: [i32; 2], offset: [u8; 2]) -> f64 {
        let from_middle = [0, 1].map(|axis| {
            let unit = i32::from(OFFSET_UNIT);
            f64::from(unit * pixel[axis] + i32::from(offset[axis]) - unit / 2) / f64::from(unit)
        });
        let [x, y] = from_middle.map(f64::abs);
        match self {
            Self::Box => f64::from(u8::from(pixel == [0, 0])),
            _ if x >= 1.0 || y >= 1.0 => 0.0,
            Self::Tent => (1.0 - x) * (1.0 - y),
            Self::Gaussian => libm::exp(-(x * x + y * y) / (2.0 * SIGMA * SIGMA)),
        }
    }
}

impl Weights {
    /// Weights of the sampling points of the pixel `column` and `row` (-1 to 1) away from the middle one.
    pub fn of(&self, [column, row]: [i32; 2]) -> &[f64] {
        let pixel = (3 * (row + 1) + column + 1) as usize;
        &self.weights[pixel * self.samples..(pixel + 1) * self.samples]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_sum_to_one_and_keep_the_middle() {
        for pattern in Pattern::ALL {
            for filter in [Filter::Box, Filter::Tent, Filter::Gaussian] {
                let weights = filter.weights(pattern).weights;
                let sum: f64 = weights.iter().sum();
                assert!((sum - 1.0).abs() < 1e-15 * 32.0, "{filter:?} {}: {sum}", pattern.name());
                assert!(weights.iter().all(|&weight| weight >= 0.0));
            }
        }
    }

    #[test]
    fn the_box_is_the_mean_of_the_pixel() {
        let weights = Filter::Box.weights(Pattern::Sixteen);
        assert_eq!(weights.of([0, 0]), [1.0 / 16.0; 16]);
        assert_eq!(weights.of([1, 0]), [0.0; 16]);
    }

    #[test]
    fn the_tent_falls_by_distance_along_each_axis() {
        let weights = Filter::Tent.weights(Pattern::Grid16);
        // Points of the middle pixel lie 1/8 and 3/8 off its middle; the nearest of the next pixel 5/8.
        let ratio = weights.of([0, 0])[0] / weights.of([0, 0])[5];
        assert!((ratio - (0.625 * 0.625) / (0.875 * 0.875)).abs() < 1e-15, "{ratio}");
        let beside = weights.of([1, 0])[4] / weights.of([0, 0])[6];
        assert!((beside - 0.375 / 0.875).abs() < 1e-15, "{beside}");
    }

    #[test]
    fn the_gaussian_falls_by_its_deviation() {
        let weights = Filter::Gaussian.weights(Pattern::Grid16);
        let ratio = weights.of([1, 0])[4] / weights.of([0, 0])[6];
        assert!((ratio - libm::exp(-2.0 * (0.625 * 0.625 - 0.125 * 0.125))).abs() < 1e-15, "{ratio}");
    }
}
