//! What the block puts out.

use signal::{LANES, Lanes, Real, Signal, Unit};

use crate::bank::Bank;

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("fg.height", Unit::Metre, "height that features add to the terrain", "section 10"),
    Signal::ground("fg.slope.u", Unit::Slope, "slope of the features to the north", "section 10"),
    Signal::ground("fg.slope.v", Unit::Slope, "slope of the features to the east", "section 10"),
    Signal::ground(
        "fg.or",
        Unit::Gate,
        "1 inside the footprint of a feature that is drawn, before the comparator",
        "section 14",
    ),
    Signal::ground("fg.present", Unit::Gate, "presence line, behind its comparator", "section 14"),
    Signal::ground(
        "fg.grain",
        Unit::Number,
        "what craters add to the gain of texture, which is 1 without any",
        "section 13",
    ),
    Signal::ground(
        "fg.reflectivity",
        Unit::Reflectivity,
        "reflectivity where a feature is: of the summed slopes, or of the features' alone",
        "section 10",
    ),
];

/// Where the sweep crosses a circle at which the slope of a feature jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kink<S> {
    /// The step: it lies between samples `sample - 1` and `sample`, so this is at least 1.
    pub sample: usize,
    /// Part of the step, 0..=1.
    pub share: S,
    /// Ground range of the kink (m).
    pub range: f64,
    /// Height of all drawn features there (m): continuous.
    pub height: S,
    /// Slopes of all drawn features just before it: along the sweep, across to the right.
    pub before: [S; 2],
    /// The same just after it.
    pub after: [S; 2],
    /// Whether a drawn feature is just before it and just after it.
    pub present: [bool; 2],
}

/// Features along a group of sweeps: one [`Lanes`] a sample; 0 where there is none.
#[derive(Debug, Clone, Default)]
pub struct FeatureProfile<S> {
    /// Height above the terrain (m).
    pub height: Vec<Lanes<S>>,
    /// Slope along the sweep.
    pub along: Vec<Lanes<S>>,
    /// Slope across the sweep, positive to the right.
    pub across: Vec<Lanes<S>>,
    /// 1 inside the footprint of a drawn feature, else 0.
    pub present: Vec<Lanes<S>>,
    /// Kinks lane by lane, ascending in range.
    pub kinks: [Vec<Kink<S>>; LANES],
    /// Workspace of the sweep that is being drawn.
    pub(crate) bank: Bank,
}

/// Height and slopes of a group that craters are added to: one [`Lanes`] a sample.
#[derive(Debug)]
pub struct Surface<'a, S> {
    /// Height of the surface (m).
    pub height: &'a mut [Lanes<S>],
    /// Slope along the sweep.
    pub along: &'a mut [Lanes<S>],
    /// Slope across the sweep, positive to the right.
    pub across: &'a mut [Lanes<S>],
}

impl<S: Real> FeatureProfile<S> {
    /// What features add to.
    pub(crate) fn surface(&mut self) -> Surface<'_, S> {
        Surface { height: &mut self.height, along: &mut self.along, across: &mut self.across }
    }

    /// All samples 0 and no kinks.
    pub(crate) fn clear(&mut self, samples: usize) {
        for signal in [&mut self.height, &mut self.along, &mut self.across, &mut self.present] {
            signal.clear();
            signal.resize(samples, Lanes::default());
        }
        self.kinks.iter_mut().for_each(Vec::clear);
    }
}
