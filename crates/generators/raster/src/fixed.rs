//! Screen positions in whole steps, in which edge functions are exact.

use crate::screen::{LARGEST_RASTER, LARGEST_SIDE};

/// Steps of a corner's position in a pixel. Chosen: what graphics hardware snaps to.
pub(crate) const STEPS: i32 = 256;

/// Lowest and highest coordinate of a corner (steps): the largest raster with the margin of the largest sub-area.
const RANGE: [i32; 2] = [-(LARGEST_SIDE as i32) * STEPS, (LARGEST_RASTER + LARGEST_SIDE) as i32 * STEPS];

/// A corner on the screen, snapped to 1/256 pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Point {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

/// A coordinate that is not finite, or lies outside the largest raster and its margin.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("screen coordinate {0}: expected a number from -{LARGEST_SIDE} to {end} pixels", end = LARGEST_RASTER + LARGEST_SIDE)]
pub struct OffRaster(pub f64);

impl Point {
    /// Snaps a position (pixels) to the nearest multiple of 1/256 pixel; half a step goes right and down.
    ///
    /// # Errors If a coordinate is not finite, or lies more than 8 pixels outside a raster of 8192 x 8192.
    pub fn snap([x, y]: [f64; 2]) -> Result<Self, OffRaster> {
        Ok(Self { x: steps(x)?, y: steps(y)? })
    }

    /// The snapped position (pixels), exactly.
    pub fn position(self) -> [f64; 2] {
        [self.x, self.y].map(|steps| f64::from(steps) / f64::from(STEPS))
    }
}

fn steps(pixels: f64) -> Result<i32, OffRaster> {
    let steps = (pixels * f64::from(STEPS) + 0.5).floor();
    let [low, high] = RANGE.map(f64::from);
    if (low..=high).contains(&steps) { Ok(steps as i32) } else { Err(OffRaster(pixels)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_step_goes_right_and_down() {
        let snapped = |x| Point::snap([x, 0.0]).map(|point| point.x);
        assert_eq!(snapped(1.0 / 512.0), Ok(1));
        assert_eq!(snapped(-1.0 / 512.0), Ok(0));
        assert_eq!(snapped(8200.0), Ok(8200 * 256));
        assert_eq!(snapped(-8.0), Ok(-8 * 256));
    }

    #[test]
    fn what_is_no_place_on_a_raster_is_refused() {
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 8200.01, -8.01] {
            assert!(Point::snap([wrong, 0.0]).is_err() && Point::snap([0.0, wrong]).is_err(), "{wrong}");
        }
        let message = Point::snap([9000.0, 0.0]).unwrap_err().to_string();
        assert_eq!(message, "screen coordinate 9000: expected a number from -8 to 8200 pixels");
    }
}
