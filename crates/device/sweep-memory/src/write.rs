//! The write beam: from a profile in sight to the lines of a sweep.

use std::ops::Range;

use fearless_simd::prelude::SimdCombine;
use fearless_simd::{Level, Simd, SimdBase, SimdMask, dispatch, f32x8, f32x16, mask32x8};
use scenario::PixelRule;
use signal::{LANES, Lanes, Real, Signal, Unit};

use crate::broken::{BeamBreaks, Cursors};
use crate::cubic::Cubic;
use crate::curve::{MOST_BEND, STRAIGHT, chords};
use crate::stroke::{Stroke, centre, line_mean};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground(
        "sm.video",
        Unit::Reflectivity,
        "intensity that the write beam is driven with: 0 in shadow and while it is blanked",
        "fig. 14",
    ),
    Signal::display("sm.write", Unit::Reflectivity, "what the sweep leaves in each display line", "fig. 14"),
];

/// What drives the write beam of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Copy)]
pub struct Beam<'a, S> {
    /// Line position of the profile, in sight or not, from the top.
    pub position: &'a [Lanes<S>],
    /// Line position of the highest elevation so far: never grows, and stands still while the profile is hidden.
    pub line: &'a [Lanes<S>],
    /// Part of the step from the sample before at which the profile comes back into sight.
    pub entry: &'a [Lanes<S>],
    /// Intensity, negative in local shadow.
    pub intensity: &'a [Lanes<S>],
    /// What happens between samples; `None` if nothing does in any lane.
    pub breaks: Option<BeamBreaks<'a, S>>,
    /// Silhouettes behind the last sample, lane by lane, nearest first; `None` if there are none.
    pub far: Option<&'a [Vec<FarStroke>; LANES]>,
}

/// What stands behind the last sample: a mountain of which only the outline is known (section 8).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FarStroke {
    /// Line position of its outline, from the top.
    pub line: f32,
    /// Intensity of the mountain, 0..=1.
    pub intensity: f32,
}

/// How the beam is drawn over a step between two samples that has no break in it or beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Steps<'a> {
    /// Along the cubics through the samples around it, where position or intensity bends by more than is seen.
    #[default]
    Curved,
    /// Straight from sample to sample, position and intensity: one stroke a step, in these runs of samples, ascending and apart.
    /// All other steps are hidden in all lanes, or outside the picture.
    Straight(&'a [Range<usize>]),
}

/// Writes the first `rows.len() / lines` sweeps of a group into `rows`, `lines` values a sweep, cleared before. In `side`,
/// the buffer of a worker, lines have their lanes side by side while they are written.
pub fn write_group<S: Real>(
    beam: &Beam<'_, S>,
    steps: Steps<'_>,
    rule: PixelRule,
    lines: usize,
    side: &mut Vec<Lanes<f32>>,
    rows: &mut [f32],
) {
    debug_assert!(rows.len() / lines <= LANES);
    side.clear();
    side.resize(lines, Lanes::default());
    let writer = Writer { beam, steps, rule, vectors: Level::new() };
    match (beam.breaks, steps) {
        (Some(broken), _) => writer.steps_among(broken, side),
        (None, Steps::Straight(runs)) => {
            runs.iter().for_each(|run| writer.smooth_steps(run.start + 1..run.end, side));
        }
        (None, Steps::Curved) => writer.smooth_steps(1..beam.line.len(), side),
    }
    for (lane, row) in rows.chunks_exact_mut(lines).enumerate() {
        beam.far_strokes(lane, |stroke| writer.draw(stroke, lane, side));
        row.iter_mut().zip(&*side).for_each(|(value, line)| *value = line[lane]);
    }
}

/// The beam of a group, and how its strokes are left in the lines.
struct Writer<'a, 'b, S> {
    beam: &'a Beam<'b, S>,
    steps: Steps<'a>,
    rule: PixelRule,
    vectors: Level,
}

impl<S: Real> Writer<'_, '_, S> {
    /// Steps with no break in them or beside them: nearly all.
    fn smooth_steps(&self, samples: Range<usize>, lines: &mut [Lanes<f32>]) {
        dispatch!(self.vectors, simd => self.smooth_steps_by(simd, samples, lines));
    }

    #[inline(always)]
    fn smooth_steps_by<V: Simd>(&self, simd: V, mut samples: Range<usize>, lines: &mut [Lanes<f32>]) {
        while !samples.is_empty() {
            let steps = samples.len().min(2);
            if steps == 1 || !self.leave_two_steps(simd, samples.start, lines) {
                for sample in samples.clone().take(steps) {
                    // Neighbouring sweeps are mostly hidden together: one look at all of them.
                    if !self.beam.is_hidden(sample) {
                        self.smooth_step(simd, sample, mask32x8::splat(simd, true), lines);
                    }
                }
            }
            samples.start += steps;
        }
    }

    /// The step that ends at `sample` and the next one, if they are straight and quickly drawn together.
    #[inline(always)]
    fn leave_two_steps<V: Simd>(&self, simd: V, sample: usize, lines: &mut [Lanes<f32>]) -> bool {
        if self.steps == Steps::Curved || self.rule == PixelRule::Centre {
            return false;
        }
        let Beam { line, entry, intensity, .. } = self.beam;
        // One by one: arrays of wide vectors stay in memory.
        let (from, to) = (two(simd, line, sample - 1), two(simd, line, sample));
        let (before, end) = (two(simd, intensity, sample - 1), two(simd, intensity, sample));
        let entry = two(simd, entry, sample);
        Stroke::in_sight(from, to, before, end, entry).leave_both(simd, lines)
    }

    /// The step that ends at `sample` in the lanes for which `smooth` is true: nothing where the profile is hidden;
    /// straight where that is near enough or wanted; else chords of the cubics through the four samples around.
    #[inline(always)]
    fn smooth_step<V: Simd>(&self, simd: V, sample: usize, smooth: mask32x8<V>, lines: &mut [Lanes<f32>]) {
        let Beam { line, entry, intensity, .. } = self.beam;
        let [from, to] = [sample - 1, sample].map(|sample| all(simd, line, sample));
        let [before, end] = [sample - 1, sample].map(|sample| all(simd, intensity, sample));
        let entry = all(simd, entry, sample);
        let strokes = Stroke::in_sight(from, to, before, end, entry).only(smooth);
        let curves = match self.steps {
            Steps::Curved => self.beam.curves(simd, sample),
            Steps::Straight(_) => None,
        };
        let Some(Curves { position, intensity, bent }) = curves else {
            return self.leave(simd, &strokes, lines);
        };
        self.leave(simd, &strokes.only(!bent), lines);
        if (bent & strokes.draw()).any_true() {
            let end = f32x8::splat(simd, 1.0);
            for chord in chords(&position, &intensity, strokes.only(bent), [entry, end]) {
                self.leave(simd, &chord, lines);
            }
        }
    }

    /// Smooth steps side by side, and apart from them those with a break in them or beside them.
    fn steps_among(&self, broken: BeamBreaks<'_, S>, lines: &mut [Lanes<f32>]) {
        let (samples, mut sample) = (self.beam.line.len(), 1);
        let mut cursors = Cursors::new(broken);
        while sample < samples {
            let disturbed = cursors.next_disturbed(sample).min(samples);
            self.smooth_steps(sample..disturbed, lines);
            if disturbed < samples {
                self.disturbed_step(disturbed, &mut cursors, lines);
            }
            sample = disturbed + 1;
        }
    }

    fn disturbed_step(&self, sample: usize, cursors: &mut Cursors<'_, S>, lines: &mut [Lanes<f32>]) {
        // A bit a lane.
        let mut smooth = 0;
        for lane in 0..LANES {
            cursors.pass(sample, lane);
            // The held line never grows: where it stands, nothing between the samples rises above it either.
            if at(self.beam.line, sample, lane) >= at(self.beam.line, sample - 1, lane) {
                continue;
            }
            match cursors.around(sample, lane) {
                None => smooth |= 1 << lane,
                Some(step) => step.strokes(self.beam, &mut |stroke| self.draw(stroke, lane, lines)),
            }
        }
        if smooth != 0 {
            dispatch!(self.vectors, simd => {
                self.smooth_step(simd, sample, mask32x8::from_bitmask(simd, smooth), lines);
            });
        }
    }

    #[inline(always)]
    fn leave<V: Simd>(&self, simd: V, strokes: &Stroke<f32x8<V>>, lines: &mut [Lanes<f32>]) {
        match self.rule {
            PixelRule::LineMean => strokes.leave_line_means(simd, lines),
            PixelRule::Centre => strokes.leave_centres(simd, lines),
        }
    }

    fn draw(&self, stroke: Stroke, lane: usize, lines: &mut [Lanes<f32>]) {
        if let Some(stroke) = stroke.lit() {
            match self.rule {
                PixelRule::LineMean => {
                    line_mean(stroke, lines.len(), |line, value| lines[line][lane] += value);
                }
                PixelRule::Centre => centre(stroke, lines.len(), |line, value| lines[line][lane] = value),
            }
        }
    }
}

/// Position and intensity over a step, and in which lanes either bends.
struct Curves<V: Simd> {
    position: Cubic<f32x8<V>>,
    intensity: Cubic<f32x8<V>>,
    bent: mask32x8<V>,
}

impl<S: Real> Beam<'_, S> {
    /// Whether the profile is hidden in all lanes over the step that ends at `sample`.
    #[inline(always)]
    fn is_hidden(&self, sample: usize) -> bool {
        let (before, now) = (&self.line[sample - 1], &self.line[sample]);
        let mut hidden = true;
        for lane in 0..LANES {
            hidden &= now[lane] >= before[lane];
        }
        hidden
    }

    /// Curves over the step that ends at `sample`, if any lane bends there.
    #[inline(always)]
    fn curves<V: Simd>(&self, simd: V, sample: usize) -> Option<Curves<V>> {
        if sample < 2 || sample + 1 >= self.line.len() {
            return None;
        }
        let cubic = |values: &[Lanes<S>]| {
            Cubic::through(
                [sample - 2, sample - 1, sample, sample + 1].map(|sample| all(simd, values, sample)),
            )
        };
        let (position, intensity) = (cubic(self.position), cubic(self.intensity));
        let (bend, fade) = (position.bend(simd), intensity.bend(simd));
        let [line, light, most] = [STRAIGHT.0, STRAIGHT.1, MOST_BEND].map(|value| f32x8::splat(simd, value));
        // A neighbour beyond the end of the profile is far out of sight and says nothing of its shape.
        let bent = (bend.simd_gt(line) | fade.simd_gt(light)) & bend.simd_lt(most);
        bent.any_true().then_some(Curves { position, intensity, bent })
    }

    /// Silhouettes rise from the held elevation, each hidden by what is before it.
    fn far_strokes(&self, lane: usize, mut draw: impl FnMut(Stroke)) {
        let (Some(far), Some(last)) = (self.far, self.line.last()) else { return };
        let mut from = last[lane].to_f64() as f32;
        for &FarStroke { line, intensity } in &far[lane] {
            if line < from {
                draw(Stroke { from, to: line, start: intensity, end: intensity });
                from = line;
            }
        }
    }
}

pub(crate) fn at<S: Real>(values: &[Lanes<S>], sample: usize, lane: usize) -> f32 {
    values[sample][lane].to_f64() as f32
}

#[inline(always)]
fn all<V: Simd, S: Real>(simd: V, values: &[Lanes<S>], sample: usize) -> f32x8<V> {
    let values = &values[sample];
    let mut all = [0.0; LANES];
    for lane in 0..LANES {
        all[lane] = values[lane].to_f64() as f32;
    }
    f32x8::load_array(simd, all)
}

/// Of a sample and the one behind it.
#[inline(always)]
fn two<V: Simd, S: Real>(simd: V, values: &[Lanes<S>], sample: usize) -> f32x16<V> {
    all(simd, values, sample).combine(all(simd, values, sample + 1))
}

#[cfg(test)]
mod tests {
    use std::slice::from_ref;

    use super::{Beam, Steps, write_group};
    use proptest::prelude::{prop_assert, proptest};
    use scenario::PixelRule;
    use signal::Lanes;

    fn write(line: &[f64], intensity: &[f64], rule: PixelRule, lines: usize) -> Vec<f32> {
        write_by(Steps::Curved, line, intensity, rule, lines)
    }

    fn write_by(
        steps: Steps<'_>,
        line: &[f64],
        intensity: &[f64],
        rule: PixelRule,
        lines: usize,
    ) -> Vec<f32> {
        let lanes = |values: &[f64]| values.iter().map(|&value| Lanes::splat(value)).collect::<Vec<_>>();
        let mut rows = vec![9.0; lines];
        let (line, intensity) = (lanes(line), lanes(intensity));
        let entry = vec![Lanes::splat(0.0); line.len()];
        let beam = Beam {
            position: &line,
            line: &line,
            entry: &entry,
            intensity: &intensity,
            breaks: None,
            far: None,
        };
        write_group(&beam, steps, rule, lines, &mut Vec::new(), &mut rows);
        rows
    }

    #[test]
    fn a_ramp_of_intensity_has_the_means_of_a_ramp() {
        // Intensity 0 at line 5 to 1 at line 1: line k shows the mean of its stretch.
        let rows = write(&[5.0, 1.0], &[0.0, 1.0], PixelRule::LineMean, 6);
        for (row, expected) in rows.iter().zip([0.0, 0.875, 0.625, 0.375, 0.125, 0.0]) {
            assert!((row - expected).abs() < 1e-6, "{rows:?}");
        }
        let centres = write(&[5.0, 1.0], &[0.0, 1.0], PixelRule::Centre, 6);
        assert_eq!(centres, [0.0, 0.875, 0.625, 0.375, 0.125, 0.0]);
    }

    #[test]
    fn a_half_covered_line_is_half_sky() {
        assert_eq!(write(&[3.0, 1.5], &[1.0, 1.0], PixelRule::LineMean, 3), [0.0, 0.5, 1.0]);
        assert_eq!(write(&[3.0, 1.6], &[1.0, 1.0], PixelRule::Centre, 3), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn the_beam_is_cut_off_where_local_shadow_begins() {
        // From -1 at line 4 to 1 at line 0: black up to line 2, then a ramp.
        let rows = write(&[4.0, 0.0], &[-1.0, 1.0], PixelRule::LineMean, 4);
        assert_eq!(rows, [0.75, 0.25, 0.0, 0.0]);
        let rows = write(&[4.0, 0.0], &[1.0, -1.0], PixelRule::LineMean, 4);
        assert_eq!(rows, [0.0, 0.0, 0.25, 0.75]);
        assert_eq!(write(&[4.0, 0.0], &[-1.0, 1.0], PixelRule::Centre, 4), [0.75, 0.25, 0.0, 0.0]);
    }

    #[test]
    fn strokes_beyond_the_picture_are_cut_where_it_ends() {
        let rows = write(&[9.0, -1.0], &[0.0, 10.0], PixelRule::LineMean, 3);
        for (row, expected) in rows.iter().zip([8.5, 7.5, 6.5]) {
            assert!((row - expected).abs() < 1e-5, "{rows:?}");
        }
    }

    #[test]
    fn a_profile_that_comes_back_starts_with_its_own_intensity() {
        let lanes = |values: [f64; 3]| values.map(Lanes::splat);
        let mut rows = vec![0.0; 1];
        // In sight, hidden, back a quarter into the last step: intensity there is 0.25 of the way from 0 to 1.
        let (line, entry) = (lanes([1.0, 1.0, 0.0]), lanes([0.0, 0.0, 0.25]));
        let intensity = lanes([0.5, 0.0, 1.0]);
        let beam = Beam {
            position: &line,
            line: &line,
            entry: &entry,
            intensity: &intensity,
            breaks: None,
            far: None,
        };
        write_group(&beam, Steps::Curved, PixelRule::LineMean, 1, &mut Vec::new(), &mut rows);
        assert!((rows[0] - 0.625).abs() < 1e-7);
    }

    #[test]
    fn a_curve_is_drawn_as_a_curve() {
        // Lines fall as a parabola of the sample, intensity is the line over 100: every line shows its own.
        let line: Vec<f64> = (0..12).map(|k| 100.0 - 0.7 * f64::from(k * k)).collect();
        let intensity: Vec<f64> = line.iter().map(|line| line / 100.0).collect();
        let rows = write(&line, &intensity, PixelRule::LineMean, 100);
        for (index, row) in rows.iter().enumerate().skip(30).take(65) {
            assert!((f64::from(*row) - (index as f64 + 0.5) / 100.0).abs() < 1e-4, "{index}: {row}");
        }
    }

    #[test]
    fn straight_steps_leave_chords() {
        // Two steps of a parabola: every line shows the intensity of the chord at its centre, which the curve does not.
        let (line, intensity) = ([30.0, 20.0, 10.0, 0.0], [0.9, 0.4, 0.1, 0.0]);
        let rows = write_by(Steps::Straight(from_ref(&(0..4))), &line, &intensity, PixelRule::LineMean, 30);
        for (index, row) in rows.iter().enumerate() {
            let place = 29.5 - index as f32;
            let step = (place / 10.0) as usize;
            let [from, to] = [step, step + 1].map(|sample| intensity[sample] as f32);
            let chord = from + (place / 10.0 - step as f32) * (to - from);
            assert!((row - chord).abs() < 1e-5, "{index}: {row} against {chord}");
        }
        assert_ne!(rows, write(&line, &intensity, PixelRule::LineMean, 30));
        // Run by run the same; what is in none is not drawn.
        let by = |runs: &[_]| write_by(Steps::Straight(runs), &line, &intensity, PixelRule::LineMean, 30);
        assert_eq!(by(&[0..2, 1..4]), rows);
        let last = by(from_ref(&(2..4)));
        assert!(last[..10] == rows[..10] && last[10..].iter().all(|&row| row == 0.0), "{last:?}");
    }

    #[test]
    fn intensity_follows_the_sample_not_the_line() {
        // Intensity is a parabola of the sample while the beam climbs evenly: one chord would miss by 0.002.
        let line: Vec<f64> = (0..12).map(|k| 60.0 - 5.0 * f64::from(k)).collect();
        let intensity: Vec<f64> = (0..12).map(|k| 0.008 * f64::from(k * k)).collect();
        let rows = write(&line, &intensity, PixelRule::Centre, 60);
        for (index, row) in rows.iter().enumerate().skip(12).take(40) {
            let sample = (60.0 - (index as f64 + 0.5)) / 5.0;
            assert!((f64::from(*row) - 0.008 * sample * sample).abs() < 2e-4, "{index}: {row}");
        }
    }

    #[test]
    fn a_step_of_intensity_does_not_overshoot() {
        let line: Vec<f64> = (0..8).map(|k| 80.0 - 10.0 * f64::from(k)).collect();
        let intensity = [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0];
        let rows = write(&line, &intensity, PixelRule::Centre, 80);
        assert!(rows.iter().all(|row| (0.0..=1.0).contains(row)), "{rows:?}");
    }

    proptest! {
        #[test]
        fn coverage_is_conserved(steps in proptest::collection::vec(0.0..2.0f64, 1..60)) {
            let mut line = vec![20.0];
            for step in &steps {
                line.push((line[line.len() - 1] - step).max(0.0));
            }
            let rows = write(&line, &vec![1.0; line.len()], PixelRule::LineMean, 20);
            let covered: f32 = rows.iter().sum();
            prop_assert!((f64::from(covered) - (20.0 - line[line.len() - 1])).abs() < 1e-4);
            prop_assert!(rows.iter().all(|row| (0.0..=1.0 + 1e-5).contains(row)));
        }
    }
}
