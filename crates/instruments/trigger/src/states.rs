//! States: stretches of samples in which a clause holds.

use crate::condition::{Per, Test};
use crate::sweep::{Points, Sweep};
use crate::trigger::Limit;

/// Share of its limit at which a voltage counts as at it: single precision rounds.
const AT_LIMIT: f64 = 1.0 - 1e-6;

/// Values of one signal that pass a test one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// Instant at which the test begins to pass.
    pub begin: f64,
    /// The first value that passes.
    pub from: usize,
    /// The first after it that does not.
    pub until: usize,
}

/// Samples `first..end`, which hold from `begin` on, at or before the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    pub begin: f64,
    pub first: usize,
    pub end: usize,
}

/// The runs of `values`, which are those of `points` or made from them.
pub fn runs(points: &Points<'_>, values: &[f64], test: &Test) -> Vec<Run> {
    let mut found: Vec<Run> = Vec::new();
    let mut is_open = false;
    for (index, &value) in values.iter().enumerate() {
        let holds = test.holds(value);
        if holds && !is_open {
            found.push(Run { begin: begin(points, values, index, test), from: index, until: values.len() });
        }
        if let (false, true, Some(run)) = (holds, is_open, found.last_mut()) {
            run.until = index;
        }
        is_open = holds;
    }
    found
}

fn begin(points: &Points<'_>, values: &[f64], index: usize, test: &Test) -> f64 {
    match index.checked_sub(1) {
        Some(before) if points.is_curve() => crossing(before, [values[before], values[index]], test),
        _ => points.time(index),
    }
}

/// Where the straight line from sample `before` to the next passes the border of `test`.
fn crossing(before: usize, [from, to]: [f64; 2], test: &Test) -> f64 {
    let share = test.border(from, to).map_or(1.0, |border| (border - from) / (to - from));
    // What has no slope yet, or none at all, is met at the sample.
    let share = if share.is_nan() { 1.0 } else { share.clamp(0.0, 1.0) };
    before as f64 + share
}

/// The samples that see the runs: what comes and goes between two of them is seen by none.
fn stretches(points: &Points<'_>, values: &[f64], test: &Test, samples: usize) -> Vec<Stretch> {
    let sample = |index: usize| if index < values.len() { points.sample(index) } else { samples };
    let stretch = |run: Run| Stretch { begin: run.begin, first: sample(run.from), end: sample(run.until) };
    runs(points, values, test)
        .into_iter()
        .map(stretch)
        .filter(|stretch| stretch.first < stretch.end)
        .collect()
}

/// Where a signal, or its slope, passes a test.
pub fn level(sweep: &Sweep<'_>, points: &Points<'_>, slope: Option<Per>, test: &Test) -> Vec<Stretch> {
    let Some(per) = slope else { return stretches(points, points.values(), test, sweep.samples) };
    let slopes = slopes(sweep, points, per);
    let sampled = stretches(points, &slopes, test, sweep.samples);
    // A slope is that of a whole step: it has no instant within.
    sampled.into_iter().map(|stretch| Stretch { begin: stretch.first as f64, ..stretch }).collect()
}

/// The slope of the step that ends at each sample; none at the first.
fn slopes(sweep: &Sweep<'_>, points: &Points<'_>, per: Per) -> Vec<f64> {
    let values = points.values();
    let length = |k: usize| match per {
        Per::Sample => 1.0,
        Per::Microsecond => sweep.sample_us,
        Per::Metre => {
            sweep.range_at(k as f64).zip(sweep.range_at(k as f64 - 1.0)).map_or(f64::NAN, |(b, a)| b - a)
        }
    };
    let slope = |k: usize| if k == 0 { f64::NAN } else { (values[k] - values[k - 1]) / length(k) };
    (0..values.len()).map(slope).collect()
}

/// Where any of some voltages is at its limit.
pub fn saturated(sweep: &Sweep<'_>, limits: &[Limit]) -> Vec<Stretch> {
    let mut most = vec![0.0_f64; sweep.samples];
    let mut wave = None;
    for limit in limits {
        let Some(points) = sweep.of(limit.signal.name) else { continue };
        for (most, &value) in most.iter_mut().zip(points.values()) {
            *most = most.max(limit.share(value));
        }
        wave = Some(points);
    }
    wave.map_or_else(Vec::new, |points| stretches(&points, &most, &Test::AtLeast(AT_LIMIT), sweep.samples))
}

/// Whether a value is at its limit.
pub fn is_saturated(limit: &Limit, value: f64) -> bool {
    limit.share(value) >= AT_LIMIT
}

/// Where both hold; the later begins it.
pub fn both(a: &[Stretch], b: &[Stretch]) -> Vec<Stretch> {
    let (mut a, mut b) = (a.iter().peekable(), b.iter().peekable());
    let mut found = Vec::new();
    while let (Some(x), Some(y)) = (a.peek(), b.peek()) {
        let common =
            Stretch { begin: x.begin.max(y.begin), first: x.first.max(y.first), end: x.end.min(y.end) };
        if common.first < common.end {
            found.push(common);
        }
        if x.end <= y.end {
            a.next()
        } else {
            b.next()
        };
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{Stretch, both};

    fn stretch(first: usize, end: usize) -> Stretch {
        Stretch { begin: first as f64 - 0.5, first, end }
    }

    #[test]
    fn what_two_lists_have_in_common() {
        let a = [stretch(0, 4), stretch(6, 20)];
        let b = [stretch(2, 8), stretch(9, 10), stretch(19, 30)];
        assert_eq!(both(&a, &b), [stretch(2, 4), stretch(6, 8), stretch(9, 10), stretch(19, 20)]);
        assert_eq!(both(&a, &b), both(&b, &a));
        assert_eq!(both(&a, &[]), []);
    }
}
