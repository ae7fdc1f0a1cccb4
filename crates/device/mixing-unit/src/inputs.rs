//! What the generators send to the mixing unit.

use signal::{LANES, Lanes, Real};

use crate::switch::VideoSwitch;

/// A place between two samples where the surface of a feature bends or begins (section 9).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kink<S> {
    /// The step: it lies between samples `sample - 1` and `sample`; at least 1, below the number of samples.
    pub sample: usize,
    /// Part of the step, 0..=1.
    pub share: S,
    /// Height of terrain and features there, above the eye (m).
    pub height: S,
    /// Reflectivity of the features just before and just after it, with its sign.
    pub feature: [S; 2],
    /// Reflectivity of the terrain there, with its sign.
    pub terrain: S,
    /// Whether there is a feature just before and just after it.
    pub present: [bool; 2],
}

/// Signals of the feature generator.
#[derive(Debug, Clone, Copy)]
pub struct FeatureInput<'a, S> {
    /// Height that features add to the terrain (m).
    pub height: &'a [Lanes<S>],
    /// Presence line: 1 where there is a feature, else 0.
    pub present: &'a [Lanes<S>],
    /// Reflectivity of the surface that features make, with its sign; 0 where there is none.
    pub reflectivity: &'a [Lanes<S>],
    /// 1 where `reflectivity` is that of the surface: inside footprints, and where a chain of real parts has not come to
    /// rest behind them.
    pub lit: &'a [Lanes<S>],
    /// Kinks lane by lane, ascending.
    pub kinks: &'a [Vec<Kink<S>>; LANES],
    /// The presence line where comparators of real parts make it; without them it changes at the kinks.
    pub gates: Option<&'a [ToggleList<'a, S>; LANES]>,
}

/// A gate changes: the sweep crosses a boundary of remote shadow, or the edge of a footprint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toggle<S> {
    /// The step: it lies between samples `sample - 1` and `sample`; at least 1, below the number of samples.
    pub sample: usize,
    /// Part of the step, 0..=1.
    pub share: S,
    /// Slope of what the gate's comparator sees there (full scales a step), above 0; infinite for a jump. Without real
    /// parts nobody asks.
    pub slope: f64,
}

/// A gate over one sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToggleList<'a, S> {
    /// Whether it is open at the first sample: in remote shadow, or in a footprint.
    pub open_at_start: bool,
    /// Where the gate changes, ascending.
    pub toggles: &'a [Toggle<S>],
}

/// Signals of a group of sweeps, one [`Lanes`] a sample; a generator that is not there sends `None`.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a, S> {
    /// Terrain height above the eye (m).
    pub height: &'a [Lanes<S>],
    /// Terrain reflectivity with its sign.
    pub reflectivity: &'a [Lanes<S>],
    /// Signals of the feature generator.
    pub features: Option<FeatureInput<'a, S>>,
    /// Gates of the shadow controller, one a lane.
    pub shadow: Option<&'a [ToggleList<'a, S>; LANES]>,
    /// Texture generator: what it adds to the samples from the first to where texture ends.
    pub texture: Option<&'a [Lanes<S>]>,
}

impl<S: Real> Inputs<'_, S> {
    /// Gate of VS1 at each sample of a lane, 0 or 1: for a probe.
    pub fn vs1_gate(&self, vs1: &VideoSwitch, lane: usize) -> Vec<f64> {
        let samples = self.height.len();
        self.features.map_or_else(
            || vec![0.0; samples],
            |features| {
                let pairs = features.present.iter().zip(features.reflectivity);
                pairs.map(|(p, r)| f64::from(u8::from(vs1.is_open(p[lane], r[lane])))).collect()
            },
        )
    }

    /// Gate of VS2 at each sample of a lane, 0 or 1: for a probe.
    pub fn vs2_gate(&self, lane: usize) -> Vec<f64> {
        let mut gate = vec![0.0; self.height.len()];
        if let Some(shadow) = self.shadow {
            shadow[lane].for_each_open(gate.len(), |sample| gate[sample] = 1.0);
        }
        gate
    }
}

impl<S: Real> ToggleList<'_, S> {
    /// Each sample at which it is open, of `samples`.
    pub(crate) fn for_each_open(&self, samples: usize, mut visit: impl FnMut(usize)) {
        let (mut open, mut from) = (self.open_at_start, 0);
        let ends = self.toggles.iter().map(|toggle| toggle.sample.min(samples));
        for end in ends.chain(std::iter::once(samples)) {
            if open {
                (from..end).for_each(&mut visit);
            }
            (open, from) = (!open, end);
        }
    }
}
