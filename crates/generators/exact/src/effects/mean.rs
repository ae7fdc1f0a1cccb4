//! The mean over the sub-rays of a pixel.

use smallvec::SmallVec;

use super::lattice::SUB_RAYS;
use super::run::Run;

/// What sub-rays have found so far.
#[derive(Debug, Default)]
pub struct Mean {
    added: [f64; 3],
    /// Light of the opaque picture that effects let through, summed.
    through: [f64; 3],
    /// All light of the opaque picture, summed.
    whole: [f64; 3],
    /// Share that effects let through, in the mean.
    share: f64,
    visible: SmallVec<[(usize, f64); 2]>,
}

impl Mean {
    /// Adds a sub-ray that ends in the opaque picture at `light` (linear red, green, blue).
    pub fn add(&mut self, run: Run, light: [f64; 3]) {
        self.share += run.through / f64::from(SUB_RAYS);
        for channel in 0..3 {
            self.added[channel] += run.added[channel];
            self.through[channel] += run.through * light[channel];
            self.whole[channel] += light[channel];
        }
        self.visible.extend(run.visible);
    }

    /// Light that effects add in the pixel (linear red, green, blue).
    pub fn added(&self) -> [f64; 3] {
        self.added
    }

    /// Share of red, green and blue of the opaque picture that effects let through, weighed with its light where it has any.
    pub fn through(&self) -> [f64; 3] {
        [0, 1, 2].map(|channel| match self.whole[channel] {
            whole if whole > 0.0 => self.through[channel] / whole,
            _ => self.share,
        })
    }

    /// Numbers of calligraphic points, and what is seen of their area.
    pub fn visible(&self) -> &[(usize, f64)] {
        &self.visible
    }
}
