//! The way through a stack of things, from near to far.

use smallvec::SmallVec;

use super::matter::Effect;
use super::part::Part;

/// From near to far through a stack.
pub struct Run {
    /// Light that has been added (linear red, green, blue).
    pub added: [f64; 3],
    /// Share of light that what is nearer lets through.
    pub through: f64,
    /// The same of nearer calligraphic points, which hide calligraphic points alone.
    veil: f64,
    /// Number of calligraphic points and what is seen of their area.
    pub visible: SmallVec<[(usize, f64); 2]>,
}

impl Run {
    /// Nothing has been passed.
    pub fn new() -> Self {
        Self { added: [0.0; 3], through: 1.0, veil: 1.0, visible: SmallVec::new() }
    }

    /// Passes a thing that covers `share` of the way.
    pub fn pass(&mut self, part: &Part, effect: Effect, share: f64) {
        let let_through = 1.0 - share * (1.0 - effect.translucency);
        if part.feature.beam().is_some() {
            self.visible.push((part.index, part.weight * share * self.through * self.veil));
            self.veil *= let_through;
            return;
        }
        for channel in 0..3 {
            self.added[channel] += part.weight * share * self.through * effect.added[channel];
        }
        self.through *= let_through;
    }
}
