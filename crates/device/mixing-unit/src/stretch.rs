//! The value of a signal between two samples.

use signal::Real;

/// A smooth part of a step: from a sample or a kink to a kink or the next sample, with what is known beyond. Shares
/// count from the sample before the step, so the sample before that is at -1 and the one after the step at 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch<S> {
    /// Share and value where it begins.
    pub start: (S, S),
    /// Share and value where it ends.
    pub end: (S, S),
    /// Value at -1, where the same smooth piece reaches so far; it then begins at 0.
    pub near: Option<S>,
    /// Value at 2, likewise; it then ends at 1.
    pub far: Option<S>,
}

impl<S: Real> Stretch<S> {
    /// Value at a share within: the parabola through three places of the piece; the mean of two such, by distance,
    /// where there are four, which is the cubic that the write beam draws; the chord where there are two.
    pub fn at(&self, share: S) -> S {
        let ((from, first), (to, last)) = (self.start, self.end);
        if from >= to {
            return first;
        }
        let slope = (last - first) / (to - from);
        let bend = match (self.near, self.far) {
            (Some(near), Some(far)) => {
                (S::ONE - share) * self.near_bend(slope, near) + share * self.far_bend(slope, far)
            }
            (Some(near), None) => self.near_bend(slope, near),
            (None, Some(far)) => self.far_bend(slope, far),
            (None, None) => S::ZERO,
        };
        first + (share - from) * (slope + (share - to) * bend)
    }

    /// Second divided difference with the place at -1.
    fn near_bend(&self, slope: S, near: S) -> S {
        (slope - (self.start.1 - near)) / (self.end.0 + S::ONE)
    }

    /// Second divided difference with the place at 2.
    fn far_bend(&self, slope: S, far: S) -> S {
        (far - self.end.1 - slope) / (S::ONE + S::ONE - self.start.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Stretch;

    fn parabola(u: f64) -> f64 {
        3.0 - 2.0 * u + 0.7 * u * u
    }

    #[test]
    fn a_parabola_is_a_parabola_whatever_is_known() {
        for (from, to, near, far) in
            [(0.0, 1.0, true, true), (0.0, 0.3, true, false), (0.4, 1.0, false, true)]
        {
            let stretch = Stretch {
                start: (from, parabola(from)),
                end: (to, parabola(to)),
                near: near.then(|| parabola(-1.0)),
                far: far.then(|| parabola(2.0)),
            };
            for part in [0.0, 0.25, 0.6, 1.0] {
                let share = from + part * (to - from);
                assert!((stretch.at(share) - parabola(share)).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn four_places_make_the_cubic_with_the_slopes_of_the_neighbours() {
        let cubic = |u: f64| 1.0 - u + 0.5 * u * u - 0.25 * u * u * u;
        let [a, b, c, d] = [-1.0, 0.0, 1.0, 2.0].map(cubic);
        let stretch = Stretch { start: (0.0, b), end: (1.0, c), near: Some(a), far: Some(d) };
        let (first, last) = (0.5 * (c - a), 0.5 * (d - b));
        for u in [0.1, 0.5, 0.8] {
            let hermite = b + u
                * (first + u * (3.0 * (c - b) - 2.0 * first - last + u * (first + last - 2.0 * (c - b))));
            assert!((stretch.at(u) - hermite).abs() < 1e-14);
        }
    }

    #[test]
    fn an_empty_stretch_has_one_value() {
        let stretch = Stretch { start: (0.5, 1.0), end: (0.5, 1.0), near: None, far: None };
        assert_eq!(stretch.at(0.5), 1.0);
    }
}
