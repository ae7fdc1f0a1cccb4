//! What is seen of the profiles of a group, and nothing else: all that straight strokes are drawn from.

use std::ops::Range;

use fearless_simd::prelude::{SimdBase, SimdFrom, SimdMask};
use fearless_simd::{Simd, dispatch};
use signal::{LANES, Lanes, Real};

use crate::occlusion::all;
use crate::processor::{Place, Take};
use crate::{Deflection, Processor};

/// Outputs of a group that straight strokes need: one [`Lanes`] a sample, as in [`Projected`](crate::Projected).
#[derive(Debug, Clone, Default)]
pub struct PreviewSight<S> {
    /// Part of the step from the sample before at which the profile comes back into sight.
    pub entry: Vec<Lanes<S>>,
    /// Line position of the held elevation.
    pub line: Vec<Lanes<S>>,
    /// Runs of samples whose light is seen, ascending and apart: the ends of all steps in which any sweep is in sight, but for
    /// those below the picture and above it in all sweeps.
    pub runs: Vec<Range<usize>>,
}

impl<S: Real> Processor<S> {
    /// As [`run`](Self::run), for strokes that are straight between samples, in a picture of so many `lines`.
    pub fn look(
        &self,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        lines: usize,
        out: &mut PreviewSight<S>,
    ) {
        out.entry.resize(height.len(), Lanes::default());
        out.line.resize(height.len(), Lanes::default());
        dispatch!(self.vectors, simd => self.look_by(simd, height, deflection, lines, out));
    }

    #[inline(always)]
    fn look_by<L: Simd>(
        &self,
        simd: L,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        lines: usize,
        out: &mut PreviewSight<S>,
    ) {
        out.runs.clear();
        let before = S::Vector::<L>::simd_from(simd, S::ZERO);
        let mut seen = Seen::<L, S> { out, before, begin: None };
        self.walk(simd, height, deflection, &mut seen);
        let begin = seen.begin;
        out.runs.extend(begin.map(|begin| begin..height.len()));
        out.leave_out_of_picture(S::from_f64(lines as f64));
    }
}

impl<S: Real> PreviewSight<S> {
    /// Cuts what lies before the first step that reaches into a picture of so many lines, and behind the last one: sweeps go
    /// upwards.
    #[inline(always)]
    fn leave_out_of_picture(&mut self, lines: S) {
        let below = self.line.iter().take_while(|line| all(|lane| line[lane] >= lines)).count();
        let above = self.line.iter().rev().take_while(|line| all(|lane| line[lane] <= S::ZERO)).count();
        let (first, end) = (below.saturating_sub(1), self.line.len() + 1 - above);
        self.runs.retain_mut(|run| {
            *run = run.start.max(first)..run.end.min(end);
            run.len() > 1
        });
    }
}

/// What is seen, on the way from sample to sample.
struct Seen<'a, L: Simd, S: Real> {
    out: &'a mut PreviewSight<S>,
    /// Line position of the sample before.
    before: S::Vector<L>,
    /// Where the present run begins, if there is one.
    begin: Option<usize>,
}

impl<L: Simd, S: Real> Take<L, S> for Seen<'_, L, S> {
    #[inline(always)]
    fn take(&mut self, sample: usize, place: Place<L, S>) {
        place.entry.store_slice(&mut self.out.entry[sample].0);
        place.line.store_slice(&mut self.out.line[sample].0);
        let is_hidden = sample == 0 || place.line.simd_ge(self.before).all_true();
        self.before = place.line;
        if !is_hidden && self.begin.is_none() {
            self.begin = Some(sample - 1);
        }
        if is_hidden && let Some(begin) = self.begin.take() {
            self.out.runs.push(begin..sample);
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{prop_assert_eq, proptest};
    use scenario::{Curvature, Occlusion, Projection};
    use signal::{LANES, Lanes};

    use super::PreviewSight;
    use crate::{Deflection, Processor, Projected};

    proptest! {
        /// What is kept is what the whole processor has; a sample is in a run if a step beside it is in sight in any lane.
        #[test]
        fn what_is_seen_is_what_is_seen_of_all(
            profiles in proptest::collection::vec(proptest::collection::vec(-30.0..30.0f64, LANES), 1..60),
            below_until in 0..40usize, hidden_from in 0..60usize, lines in 1..700usize,
        ) {
            let ranges: Vec<f64> = (1..=profiles.len()).map(|k| 5.0 * k as f64).collect();
            // Near ground lies below the picture, far ground low, so that there are long runs of both kinds.
            let height_at = |k: usize, height: f64| match k {
                k if k < below_until => ranges[k] * (0.02 * height - 3.0),
                k if k < hidden_from => height,
                _ => -500.0,
            };
            let height: Vec<_> = (0..)
                .zip(&profiles)
                .map(|(k, heights)| Lanes::from_fn(|lane| height_at(k, heights[lane])))
                .collect();
            let level = Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(575.0, 0.268);
            for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
                let processor = Processor::<f64>::new(occlusion, Curvature::Parabolic, &ranges);
                let (mut whole, mut sight) = (Projected::default(), PreviewSight::default());
                processor.run(&height, &[level; LANES], &mut whole);
                processor.look(&height, &[level; LANES], lines, &mut sight);
                prop_assert_eq!(&sight.entry, &whole.entry);
                prop_assert_eq!(&sight.line, &whole.line);
                let any = |is_so: &dyn Fn(usize) -> bool| (0..LANES).any(is_so);
                let is_drawn = |step: usize| {
                    step > 0 && step < height.len() && {
                        let [from, to] = [step - 1, step].map(|sample| whole.line[sample]);
                        any(&|lane| to[lane] < from[lane])
                            && any(&|lane| to[lane] < lines as f64)
                            && any(&|lane| from[lane] > 0.0)
                    }
                };
                let found: Vec<usize> = sight.runs.iter().cloned().flatten().collect();
                let expected: Vec<usize> =
                    (0..height.len()).filter(|&sample| is_drawn(sample) || is_drawn(sample + 1)).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}
