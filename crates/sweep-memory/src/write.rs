//! The write beam: from a profile in sight to the lines of a sweep.

use scenario::PixelRule;
use signal::{LANES, Lanes, Real, Signal, Unit};

/// Signals of the block.
pub const SIGNALS: &[Signal] =
    &[Signal::display("sm.write", Unit::Reflectivity, "what the sweep leaves in each display line")];

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
}

/// The beam over a stretch between two samples: line positions (`to` is above, that is, smaller) and intensities.
#[derive(Debug, Clone, Copy)]
struct Stroke {
    from: f32,
    to: f32,
    start: f32,
    end: f32,
}

/// Writes the first `rows.len() / lines` sweeps of a group into `rows`, `lines` values a sweep, cleared before.
pub fn write_group<S: Real>(beam: &Beam<'_, S>, rule: PixelRule, lines: usize, rows: &mut [f32]) {
    rows.fill(0.0);
    let deposit = match rule {
        PixelRule::LineMean => line_mean,
        PixelRule::Centre => centre,
    };
    let sweeps = rows.len() / lines;
    debug_assert!(sweeps <= LANES);
    for sample in 1..beam.line.len() {
        for lane in 0..sweeps {
            let row = &mut rows[lane * lines..(lane + 1) * lines];
            beam.strokes(sample, lane, |stroke| {
                if let Some(stroke) = stroke.lit() {
                    deposit(stroke, row);
                }
            });
        }
    }
}

/// Bends of a step, as second differences, from which on it is drawn as a curve: lines and intensity. Chosen so
/// that a chord leaves its curve by at most an eighth of this, that is, 0.006 line and 0.0003.
const STRAIGHT: (f32, f32) = (0.05, 0.0025);
/// Strokes of a curved step.
const CHORDS: u32 = 4;

impl<S: Real> Beam<'_, S> {
    /// The strokes of the step that ends at `sample`: none where the profile is hidden; straight where that is
    /// near enough; else chords of the cubic through the four samples around.
    #[inline(always)]
    fn strokes(&self, sample: usize, lane: usize, mut draw: impl FnMut(Stroke)) {
        let (from, to) = (at(self.line, sample - 1, lane), at(self.line, sample, lane));
        if to < from {
            let entry = at(self.entry, sample, lane);
            let (before, end) = (at(self.intensity, sample - 1, lane), at(self.intensity, sample, lane));
            let straight = Stroke { from, to, start: before + entry * (end - before), end };
            match self.curves(sample, lane) {
                None => draw(straight),
                Some(curves) => chords(&curves, straight, entry, draw),
            }
        }
    }

    /// Position and intensity over the step as cubics, where either bends.
    #[inline(always)]
    fn curves(&self, sample: usize, lane: usize) -> Option<[Cubic; 2]> {
        if sample < 2 || sample + 1 >= self.line.len() {
            return None;
        }
        let cubic = |values| Cubic::through(std::array::from_fn(|k| at(values, sample + k - 2, lane)));
        let (position, intensity) = (cubic(self.position), cubic(self.intensity));
        let bends = position.bend() > STRAIGHT.0 || intensity.bend() > STRAIGHT.1;
        // A neighbour beyond the end of the profile is far out of sight and says nothing of its shape.
        (bends && position.bend() < MOST_BEND).then_some([position, intensity])
    }
}

/// Bend beyond which a step has no common curve with its neighbours (lines).
const MOST_BEND: f32 = 200.0;

fn at<S: Real>(values: &[Lanes<S>], sample: usize, lane: usize) -> f32 {
    values[sample][lane].to_f64() as f32
}

/// The cubic between the middle two of four equally spaced values whose slopes are those of their neighbours.
#[derive(Debug, Clone, Copy)]
struct Cubic {
    values: [f32; 4],
}

impl Cubic {
    fn through(values: [f32; 4]) -> Self {
        Self { values }
    }

    /// Largest second difference; infinite where a value is not finite.
    fn bend(&self) -> f32 {
        let [a, b, c, d] = self.values;
        let (first, last) = ((a - 2.0 * b + c).abs(), (b - 2.0 * c + d).abs());
        if (first + last).is_finite() { first.max(last) } else { f32::INFINITY }
    }

    /// Value at a part of the step, 0..=1.
    fn at(&self, u: f32) -> f32 {
        let [a, b, c, d] = self.values;
        let (first, last) = (0.5 * (c - a), 0.5 * (d - b));
        let chord = c - b;
        b + u * (first + u * (3.0 * chord - 2.0 * first - last + u * (first + last - 2.0 * chord)))
    }
}

/// A curved step as chords, from where it comes into sight; the beam never turns back.
fn chords([position, intensity]: &[Cubic; 2], whole: Stroke, entry: f32, mut draw: impl FnMut(Stroke)) {
    // A cubic overshoots at a step; no intensity is beyond full scale.
    let intensity = |u| intensity.at(u).clamp(-1.0, 1.0);
    let (mut from, mut start) = (whole.from, intensity(entry));
    for chord in 1..=CHORDS {
        let u = entry + (1.0 - entry) * chord as f32 / CHORDS as f32;
        let last = chord == CHORDS;
        let to = if last { whole.to } else { position.at(u).clamp(whole.to, from) };
        let end = if last { whole.end } else { intensity(u) };
        if to < from {
            draw(Stroke { from, to, start, end });
        }
        (from, start) = (to, end);
    }
}

impl Stroke {
    /// The part of the stroke whose intensity is above black: the beam is cut off where local shadow begins,
    /// between two samples.
    #[inline(always)]
    fn lit(self) -> Option<Self> {
        let Self { from, to, start, end } = self;
        if start >= 0.0 && end >= 0.0 {
            return Some(self);
        }
        if start <= 0.0 && end <= 0.0 {
            return None;
        }
        let black = (from + start / (end - start) * (from - to)).clamp(to, from);
        let lit = if start < 0.0 {
            Self { from: black, start: 0.0, ..self }
        } else {
            Self { to: black, end: 0.0, ..self }
        };
        (lit.to < lit.from).then_some(lit)
    }

    /// Intensity at a line position within the stroke.
    fn at(&self, line: f32) -> f32 {
        self.start + (self.from - line) / (self.from - self.to) * (self.end - self.start)
    }
}

/// Adds the stroke's integral over each line that it touches.
fn line_mean(stroke: Stroke, row: &mut [f32]) {
    let height = row.len() as f32;
    let (bottom, top) = (stroke.from.min(height), stroke.to.max(0.0));
    if bottom <= top {
        return;
    }
    let last = top as usize;
    if bottom <= (last + 1) as f32 && bottom == stroke.from && top == stroke.to {
        // Nearly all strokes of far ground stay within one line.
        row[last] += 0.5 * (stroke.start + stroke.end) * (bottom - top);
        return;
    }
    let mut lower = bottom;
    let mut index = (bottom.ceil() as usize).min(row.len());
    while index > last {
        index -= 1;
        let upper = top.max(index as f32);
        row[index] += 0.5 * (stroke.at(lower) + stroke.at(upper)) * (lower - upper);
        lower = upper;
    }
}

/// Sets each line whose centre the stroke passes.
fn centre(stroke: Stroke, row: &mut [f32]) {
    let first = (stroke.to - 0.5).ceil().max(0.0) as usize;
    for (index, value) in row.iter_mut().enumerate().skip(first) {
        let centre = index as f32 + 0.5;
        if centre >= stroke.from {
            break;
        }
        *value = stroke.at(centre);
    }
}

#[cfg(test)]
mod tests {
    use super::{Beam, write_group};
    use proptest::prelude::{prop_assert, proptest};
    use scenario::PixelRule;
    use signal::Lanes;

    fn write(line: &[f64], intensity: &[f64], rule: PixelRule, lines: usize) -> Vec<f32> {
        let lanes = |values: &[f64]| values.iter().map(|&value| Lanes::splat(value)).collect::<Vec<_>>();
        let mut rows = vec![9.0; lines];
        let (line, intensity) = (lanes(line), lanes(intensity));
        let entry = vec![Lanes::splat(0.0); line.len()];
        let beam = Beam { position: &line, line: &line, entry: &entry, intensity: &intensity };
        write_group(&beam, rule, lines, &mut rows);
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
        let beam = Beam { position: &line, line: &line, entry: &entry, intensity: &intensity };
        write_group(&beam, PixelRule::LineMean, 1, &mut rows);
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
