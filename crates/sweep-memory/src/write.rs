//! The write beam: from a profile in sight to the lines of a sweep.

use scenario::PixelRule;
use signal::{LANES, Lanes, Real, Signal, Unit};

/// Signals of the block.
pub const SIGNALS: &[Signal] =
    &[Signal::display("sm.write", Unit::Reflectivity, "what the sweep leaves in each display line")];

/// The beam over one step between two samples: line positions (`to` is above, that is, smaller) and intensities.
#[derive(Debug, Clone, Copy)]
struct Stroke {
    from: f32,
    to: f32,
    start: f32,
    end: f32,
}

/// Writes the first `rows.len() / lines` sweeps of a group into `rows`, `lines` values a sweep, cleared before.
///
/// `line` is the held line position of each sample (from the top, never growing), `entry` the part of a step at
/// which the profile comes back into sight, `reflectivity` the intensity, negative in local shadow.
pub fn write_group<S: Real>(
    line: &[Lanes<S>],
    entry: &[Lanes<S>],
    reflectivity: &[Lanes<S>],
    rule: PixelRule,
    lines: usize,
    rows: &mut [f32],
) {
    rows.fill(0.0);
    let deposit = match rule {
        PixelRule::LineMean => line_mean,
        PixelRule::Centre => centre,
    };
    let sweeps = rows.len() / lines;
    debug_assert!(sweeps <= LANES);
    let at = |values: &[Lanes<S>], sample: usize, lane: usize| values[sample][lane].to_f64() as f32;
    for sample in 1..line.len() {
        for lane in 0..sweeps {
            let (from, to) = (at(line, sample - 1, lane), at(line, sample, lane));
            if to < from {
                let (before, end) = (at(reflectivity, sample - 1, lane), at(reflectivity, sample, lane));
                let start = before + at(entry, sample, lane) * (end - before);
                let row = &mut rows[lane * lines..(lane + 1) * lines];
                if let Some(stroke) = (Stroke { from, to, start, end }).lit() {
                    deposit(stroke, row);
                }
            }
        }
    }
}

impl Stroke {
    /// The part of the stroke whose intensity is above black: the beam is cut off where local shadow begins,
    /// between two samples.
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
    use super::write_group;
    use proptest::prelude::{prop_assert, proptest};
    use scenario::PixelRule;
    use signal::Lanes;

    fn write(line: &[f64], intensity: &[f64], rule: PixelRule, lines: usize) -> Vec<f32> {
        let lanes = |values: &[f64]| values.iter().map(|&value| Lanes::splat(value)).collect::<Vec<_>>();
        let mut rows = vec![9.0; lines];
        let entry = vec![Lanes::splat(0.0); line.len()];
        write_group(&lanes(line), &entry, &lanes(intensity), rule, lines, &mut rows);
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
        write_group(&line, &entry, &lanes([0.5, 0.0, 1.0]), PixelRule::LineMean, 1, &mut rows);
        assert!((rows[0] - 0.625).abs() < 1e-7);
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
