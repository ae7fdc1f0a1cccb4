//! What found no slot, and how wrong the colour can be for it.

use crate::brightest::larger;
use crate::feature::{Feature, Kind};

/// The loss of one sampling point.
///
/// **Bound.** Up to the nearest lost feature nothing is missing. Behind it both sums, the machine's and that without limits, are means
/// of colours from there on, so they differ by the largest of these colours at most, times what the kept features before it
/// let through. The largest colour is taken over all translucent features of the sub-area, lights above intensity 1
/// included, and the nearest opaque feature or the background; lights that hide nothing are added. (What was lost belongs to it: white dust
/// that is lost over black ground makes an error though nothing kept is bright.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loss<'a> {
    /// The nearest translucent surface and the nearest light without a slot, with their q (1/m); `None` if none was lost.
    pub nearest: [Option<(&'a Feature, f64)>; 2],
    /// How much the colour can differ from that without limits (linear red, green, blue), beyond rounding.
    pub bound: [f64; 3],
}

/// The losses of a sub-area, or of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Losses {
    /// Sampling points that lost a translucent surface.
    pub translucent: u64,
    /// Sampling points that lost a light.
    pub lights: u64,
    /// Largest bound of a sampling point (linear red, green, blue).
    pub bound: [f64; 3],
}

impl Losses {
    /// Takes in the loss of one sampling point.
    pub(crate) fn take_in(&mut self, loss: &Loss<'_>) {
        let lost = |kind: Kind| u64::from(loss.nearest[kind as usize].is_some());
        self.translucent += lost(Kind::Surface);
        self.lights += lost(Kind::Light);
        self.bound = larger(self.bound, loss.bound);
    }

    /// Both together, as of two sub-areas; the order does not matter.
    pub fn and(self, other: Self) -> Self {
        Self {
            translucent: self.translucent + other.translucent,
            lights: self.lights + other.lights,
            bound: larger(self.bound, other.bound),
        }
    }
}
