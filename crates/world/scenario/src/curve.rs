//! A smooth curve through values at ascending times.

use std::sync::Arc;

/// Piecewise cubic that is C1, monotone between any two neighbouring values and never leaves the interval
/// between them (Steffen 1990, "A simple method for monotonic interpolation in one dimension"). Before the
/// first time and after the last one it is constant.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    times: Arc<[f64]>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Curve {
    /// `times` strictly ascending, as many `values` as times, one or more.
    pub fn new(times: Arc<[f64]>, values: Vec<f64>) -> Self {
        let slopes = slopes(&times, &values);
        Self { times, values, slopes }
    }

    /// Returns the value of the curve at `time`.
    pub fn at(&self, time: f64) -> f64 {
        let Some((index, step, s)) = self.locate(time) else { return self.end_value(time) };
        let [v0, v1] = [self.values[index], self.values[index + 1]];
        let [m0, m1] = [self.slopes[index], self.slopes[index + 1]].map(|slope| slope * step);
        let smooth = s * s * (3.0 - 2.0 * s);
        v0 + (v1 - v0) * smooth + s * (1.0 - s) * (m0 * (1.0 - s) - m1 * s)
    }

    /// Rate of change at `time`; 0 outside the curve.
    pub fn rate(&self, time: f64) -> f64 {
        let Some((index, step, s)) = self.locate(time) else { return 0.0 };
        let chord = (self.values[index + 1] - self.values[index]) / step;
        let [m0, m1] = [self.slopes[index], self.slopes[index + 1]];
        6.0 * s * (1.0 - s) * chord + m0 * (1.0 - s) * (1.0 - 3.0 * s) + m1 * s * (3.0 * s - 2.0)
    }

    /// Index of the span that holds `time`, its length, and the place in it, 0..=1; nothing outside.
    pub fn locate(&self, time: f64) -> Option<(usize, f64, f64)> {
        let last = self.times.len() - 1;
        if last == 0 || !(self.times[0]..=self.times[last]).contains(&time) {
            return None;
        }
        let index = (self.times.partition_point(|&t| t <= time) - 1).min(last - 1);
        let step = self.times[index + 1] - self.times[index];
        Some((index, step, (time - self.times[index]) / step))
    }

    fn end_value(&self, time: f64) -> f64 {
        let index = if time < self.times[0] { 0 } else { self.values.len() - 1 };
        self.values[index]
    }
}

fn slopes(times: &[f64], values: &[f64]) -> Vec<f64> {
    let steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chords: Vec<f64> =
        values.windows(2).zip(&steps).map(|(pair, step)| (pair[1] - pair[0]) / step).collect();
    match chords[..] {
        [] => vec![0.0],
        [only] => vec![only, only],
        _ => {
            let n = chords.len();
            let inner = (1..n).map(|i| inner_slope([chords[i - 1], chords[i]], [steps[i - 1], steps[i]]));
            let first = end_slope([chords[0], chords[1]], [steps[0], steps[1]]);
            let last = end_slope([chords[n - 1], chords[n - 2]], [steps[n - 1], steps[n - 2]]);
            std::iter::once(first).chain(inner).chain([last]).collect()
        }
    }
}

/// Slope of the parabola through three points, limited so that both neighbouring cubics stay monotone.
fn inner_slope([before, after]: [f64; 2], [step_before, step_after]: [f64; 2]) -> f64 {
    let parabola = (before * step_after + after * step_before) / (step_before + step_after);
    let limit = before.abs().min(after.abs()).min(0.5 * parabola.abs());
    (before.signum() + after.signum()) * limit
}

fn end_slope([chord, next]: [f64; 2], [step, next_step]: [f64; 2]) -> f64 {
    let share = step / (step + next_step);
    let parabola = chord * (1.0 + share) - next * share;
    if parabola * chord <= 0.0 {
        0.0
    } else if parabola.abs() > 2.0 * chord.abs() {
        2.0 * chord
    } else {
        parabola
    }
}

#[cfg(test)]
mod tests {
    use super::Curve;
    use proptest::prelude::*;

    fn curve(points: &[(f64, f64)]) -> Curve {
        Curve::new(points.iter().map(|p| p.0).collect(), points.iter().map(|p| p.1).collect())
    }

    #[test]
    fn a_parabola_is_exact_where_it_is_monotone() {
        let square = curve(&[(1.0, 1.0), (2.0, 4.0), (3.5, 12.25), (4.0, 16.0)]);
        for i in 0..=30 {
            let t = 1.0 + 0.1 * f64::from(i);
            assert!((square.at(t) - t * t).abs() < 1e-12, "t = {t}");
            assert!((square.rate(t) - 2.0 * t).abs() < 1e-12, "t = {t}");
        }
    }

    #[test]
    fn one_point_and_two_points() {
        let still = curve(&[(1.0, 5.0)]);
        assert_eq!((still.at(0.0), still.at(1.0), still.rate(1.0)), (5.0, 5.0, 0.0));
        let line = curve(&[(0.0, 1.0), (2.0, 5.0)]);
        assert_eq!((line.at(0.5), line.rate(0.5)), (2.0, 2.0));
        assert_eq!((line.at(-1.0), line.at(9.0), line.rate(9.0)), (1.0, 5.0, 0.0));
    }

    #[test]
    fn a_turning_point_is_not_overshot() {
        let there_and_back = curve(&[(0.0, 0.0), (1.0, 10.0), (2.0, 0.0)]);
        assert_eq!(there_and_back.rate(1.0), 0.0);
        assert!((0..=200).all(|i| there_and_back.at(0.01 * f64::from(i)) <= 10.0));
    }

    prop_compose! {
        fn points()(steps in prop::collection::vec((0.5..10.0f64, -100.0..100.0f64), 2..12)) -> Vec<(f64, f64)> {
            let mut time = 0.0;
            steps.iter().map(|&(step, value)| { time += step; (time, value) }).collect()
        }
    }

    proptest! {
        #[test]
        fn stays_between_neighbours_and_has_a_continuous_rate(points in points()) {
            let curve = curve(&points);
            for pair in points.windows(2) {
                let ((t0, v0), (t1, v1)) = (pair[0], pair[1]);
                for i in 0..=20 {
                    let value = curve.at(t0 + (t1 - t0) * f64::from(i) / 20.0);
                    prop_assert!(value >= v0.min(v1) - 1e-9 && value <= v0.max(v1) + 1e-9);
                }
            }
            for &(t, _) in &points[1..points.len() - 1] {
                let (before, after) = (curve.rate(t - 1e-9), curve.rate(t));
                prop_assert!((before - after).abs() < 1e-3 * (1.0 + after.abs()), "{before} {after}");
            }
        }

        #[test]
        fn the_rate_is_the_derivative(points in points(), share in 0.01..0.99f64) {
            let curve = curve(&points);
            let (first, last) = (points[0].0, points[points.len() - 1].0);
            let t = first + share * (last - first);
            let difference = (curve.at(t + 1e-7) - curve.at(t - 1e-7)) / 2e-7;
            prop_assert!((curve.rate(t) - difference).abs() < 1e-2 * (1.0 + difference.abs()));
        }
    }
}
