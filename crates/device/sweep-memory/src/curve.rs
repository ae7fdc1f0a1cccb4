//! Position and intensity of the beam between two samples.

use signal::Comparable;

use crate::stroke::Stroke;

/// Bends of a step, as second differences, from which on it is drawn as a curve: lines and intensity. Chosen so
/// that a chord leaves its curve by at most an eighth of this, that is, 0.006 line and 0.0003.
pub(crate) const STRAIGHT: (f32, f32) = (0.05, 0.0025);

/// Bend beyond which a step has no common curve with its neighbours (lines).
pub(crate) const MOST_BEND: f32 = 200.0;

/// Strokes of a curved step.
pub(crate) const CHORDS: u32 = 4;

/// A quantity over a step, as a function of the part of the step that has passed.
pub(crate) trait Curve<T> {
    /// Value at a part of the step, 0..=1.
    fn at(&self, u: T) -> T;
}

/// A smooth part of a step, from a sample or a break to a break or a sample: the chord, bent as the parabola through
/// its ends and a sample beyond; with a sample beyond either end as the mean of two parabolas by distance, which is
/// the [`Cubic`](crate::cubic::Cubic).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    start: (f32, f32),
    slope: f32,
    end: f32,
    /// Second divided differences on the parabola before and on the one beyond.
    bends: [f32; 2],
}

impl Stretch {
    /// From `start` to `end`, each a part of the step and a value. `near` is the value a step before the step's
    /// begin, where the same smooth piece reaches so far, and `far` the one a step after its end.
    pub fn new(start: (f32, f32), end: (f32, f32), near: Option<f32>, far: Option<f32>) -> Self {
        let length = end.0 - start.0;
        if length <= 0.0 {
            return Self { start, slope: 0.0, end: start.0, bends: [0.0; 2] };
        }
        let slope = (end.1 - start.1) / length;
        let near = near.map(|near| (slope - (start.1 - near)) / (end.0 + 1.0));
        let far = far.map(|far| (far - end.1 - slope) / (2.0 - start.0));
        let bends = [near.or(far).unwrap_or(0.0), far.or(near).unwrap_or(0.0)];
        Self { start, slope, end: end.0, bends }
    }

    /// Where it begins and ends, as parts of the step.
    pub fn reach(&self) -> [f32; 2] {
        [self.start.0, self.end]
    }

    /// Largest second difference over its length.
    pub fn bend(&self) -> f32 {
        let length = self.end - self.start.0;
        2.0 * length * length * self.bends[0].abs().max(self.bends[1].abs())
    }
}

impl Curve<f32> for Stretch {
    fn at(&self, u: f32) -> f32 {
        let bend = self.bends[0] + u * (self.bends[1] - self.bends[0]);
        let passed = u - self.start.0;
        self.start.1 + passed * (self.slope + (u - self.end) * bend)
    }
}

/// Curved strokes as chords from one part of the step to another; the beam never turns back. One stroke, or those of eight sweeps
/// side by side; a chord that does not end above its begin draws nothing.
#[inline(always)]
pub(crate) fn chords<T: Comparable>(
    position: &impl Curve<T>,
    intensity: &impl Curve<T>,
    whole: Stroke<T>,
    [begin, finish]: [T; 2],
) -> [Stroke<T>; CHORDS as usize] {
    // A cubic overshoots at a step; no intensity is beyond full scale.
    let [least, most] = [-1.0, 1.0].map(|value| begin.like(value));
    let intensity = |u| intensity.at(u).within(least, most);
    let way = finish - begin;
    let (mut from, mut start) = (whole.from, intensity(begin));
    let mut chords = [whole; CHORDS as usize];
    for (number, chord) in (1..).zip(&mut chords) {
        if number < CHORDS {
            let u = begin + way * begin.like(f64::from(number)) / begin.like(f64::from(CHORDS));
            chord.to = position.at(u).within(whole.to, from);
            chord.end = intensity(u);
        }
        (chord.from, chord.start) = (from, start);
        (from, start) = (chord.to, chord.end);
    }
    chords
}

#[cfg(test)]
mod tests {
    use super::{Curve, Stretch};
    use crate::cubic::Cubic;

    fn parabola(u: f32) -> f32 {
        3.0 - 2.0 * u + 0.7 * u * u
    }

    #[test]
    fn a_parabola_is_a_parabola_whatever_is_known() {
        for (from, to, near, far) in [
            (0.0, 1.0, true, true),
            (0.0, 1.0, false, true),
            (0.0, 0.3, true, false),
            (0.4, 1.0, false, true),
        ] {
            let known = |known: bool, u| known.then(|| parabola(u));
            let (start, end) = ((from, parabola(from)), (to, parabola(to)));
            let stretch = Stretch::new(start, end, known(near, -1.0), known(far, 2.0));
            for part in [0.0, 0.25, 0.6, 1.0] {
                let u = from + part * (to - from);
                assert!((stretch.at(u) - parabola(u)).abs() < 2e-6, "{u}");
            }
            assert!((stretch.bend() - 1.4 * (to - from) * (to - from)).abs() < 1e-5);
        }
    }

    #[test]
    fn a_whole_step_between_smooth_neighbours_is_the_cubic() {
        let values @ [a, b, c, d] = [0.3, 1.0, 1.4, -0.2];
        let stretch = Stretch::new((0.0, b), (1.0, c), Some(a), Some(d));
        let cubic = Cubic::through(values);
        for u in [0.0, 0.1, 0.5, 0.8, 1.0] {
            assert!((cubic.at(u) - stretch.at(u)).abs() < 1e-6);
        }
    }

    #[test]
    fn a_stretch_without_length_has_one_value() {
        let stretch = Stretch::new((1.0, 0.5), (1.0, 0.7), None, Some(3.0));
        assert_eq!((stretch.at(1.0), stretch.bend()), (0.5, 0.0));
    }
}
