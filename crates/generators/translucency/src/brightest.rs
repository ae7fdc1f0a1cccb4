//! The most light that anything translucent of a sub-area can send.

use crate::feature::Feature;

/// Bounds on the light of the translucent features that were added, each a function of their set.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Brightest {
    /// Largest colour: own light over the share that is hidden.
    hiding: [f64; 3],
    /// Number of the features that add light and hide nothing, and the largest light of one of them.
    adding: f64,
    added: [f64; 3],
}

impl Brightest {
    /// Takes in one translucent feature.
    pub fn take_in(&mut self, feature: &Feature) {
        let hidden = 1.0 - feature.translucency();
        let colour = feature.own_light().map(|light| light / hidden);
        if colour.iter().all(|channel| channel.is_finite()) {
            self.hiding = larger(self.hiding, colour);
        } else {
            self.adding += 1.0;
            self.added = larger(self.added, feature.own_light());
        }
    }

    /// The most light that any of them can send through to the eye, above something of the colour `behind`: a sum of claim 4 is a mean
    /// of colours, as long as each feature hides as much as it shines.
    pub fn with(&self, behind: [f64; 3]) -> [f64; 3] {
        let hiding = larger(self.hiding, behind);
        std::array::from_fn(|channel| hiding[channel] + self.adding * self.added[channel])
    }
}

/// The larger of both, channel by channel.
pub(crate) fn larger(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|channel| a[channel].max(b[channel]))
}
