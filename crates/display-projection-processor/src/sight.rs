//! What is seen of the profiles of a group, and nothing else: all that straight strokes are drawn from.

use std::ops::Range;

use fearless_simd::dispatch;
use scenario::Occlusion;
use signal::{LANES, Lanes, Real};

use crate::occlusion::{all, derivative, peak_hold};
use crate::processor::Place;
use crate::{Deflection, Processor};

/// Outputs of a group that straight strokes need: one [`Lanes`] a sample, as in [`Projected`](crate::Projected).
#[derive(Debug, Clone, Default)]
pub struct Sight<S> {
    /// Part of the step from the sample before at which the profile comes back into sight.
    pub entry: Vec<Lanes<S>>,
    /// Line position of the held elevation.
    pub line: Vec<Lanes<S>>,
    /// Runs of samples whose light is seen, ascending and apart: the ends of all steps in which any sweep is in sight.
    pub runs: Vec<Range<usize>>,
}

impl<S: Real> Processor<S> {
    /// As [`run`](Self::run), for strokes that are straight between samples.
    pub fn look(&self, height: &[Lanes<S>], deflection: &[Deflection; LANES], out: &mut Sight<S>) {
        out.entry.resize(height.len(), Lanes::default());
        out.line.resize(height.len(), Lanes::default());
        match self.occlusion {
            Occlusion::PeakHold => {
                dispatch!(self.vectors, _ => self.look_by(height, deflection, peak_hold, out));
            }
            Occlusion::Derivative => {
                dispatch!(self.vectors, _ => self.look_by(height, deflection, derivative, out));
            }
        }
    }

    #[inline(always)]
    fn look_by(
        &self,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        circuit: impl Fn(S, S, S) -> S,
        out: &mut Sight<S>,
    ) {
        let Sight { entry, line, runs } = out;
        runs.clear();
        let (mut before, mut begin) = (Lanes::default(), None);
        self.walk(height, deflection, circuit, |sample, place: Place<S>| {
            (entry[sample], line[sample]) = (place.entry, place.line);
            let is_hidden = sample == 0 || all(|lane| place.line[lane] >= before[lane]);
            before = place.line;
            if !is_hidden && begin.is_none() {
                begin = Some(sample - 1);
            }
            if is_hidden && let Some(begin) = begin.take() {
                runs.push(begin..sample);
            }
        });
        runs.extend(begin.map(|begin| begin..height.len()));
    }
}
