//! Order of convergence: the slope of log error over log step.

use serde::Serialize;

/// Neighbouring slopes of a straight part differ by no more than this from their mean.
const STRAIGHT: f64 = 0.5;
/// Rungs of a straight part that is believed at once.
const ENOUGH: usize = 4;
/// Slopes that differ by no more than this are alike.
const ALIKE: f64 = 0.02;
/// Where an error jumps from rung to rung, as a crest lies nearer to one sample or another: its logarithms lie this near
/// to a line (root mean square).
const SCATTER: f64 = 0.4;
/// Slopes below this are no convergence: error that does not depend on the step.
const LEAST: f64 = 0.25;

/// How an error falls with the step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Order {
    /// `d log error / d log step`, least squares.
    pub slope: f64,
    /// Smallest and largest step of the straight part.
    pub steps: [f64; 2],
    /// Number of rungs on the straight part.
    pub rungs: usize,
}

/// The order on the straightest part of at least four rungs, or on the longest of three that is nearly straight; `None` if
/// there is none. `points` are steps and errors; those that are not above 0 are left out.
///
/// A ladder bends at its ends: where steps are coarse the error is not yet of one order, and where they are fine something
/// else remains.
pub fn fit(points: &[[f64; 2]]) -> Option<Order> {
    let mut logs: Vec<[f64; 2]> = points
        .iter()
        .filter(|point| point.iter().all(|value| value.is_finite() && *value > 0.0))
        .map(|point| point.map(libm::log))
        .collect();
    logs.sort_by(|a, b| a[0].total_cmp(&b[0]));
    logs.dedup_by(|next, kept| next[0] == kept[0]);
    let (from, to) = straightest(&logs)
        .or_else(|| longest(&logs, is_near_a_line))
        .or_else(|| longest(&logs, |part| spread(part).is_some()))?;
    let part = &logs[from..to];
    Some(Order {
        slope: slope(part),
        steps: [part[0][0], part[part.len() - 1][0]].map(libm::exp),
        rungs: part.len(),
    })
}

/// Parts of at least `least` rungs.
fn parts(rungs: usize, least: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..rungs).flat_map(move |from| (from + least..=rungs).map(move |to| (from, to)))
}

/// The part whose slopes differ least; of several alike the longest, of these the one with the finest steps, nearer to what
/// theory speaks of.
fn straightest(logs: &[[f64; 2]]) -> Option<(usize, usize)> {
    let straight = parts(logs.len(), ENOUGH).filter_map(|(from, to)| {
        let bend = (spread(&logs[from..to])? / ALIKE).floor() as u32;
        Some(((bend, usize::MAX - (to - from), from), (from, to)))
    });
    straight.min().map(|(_, part)| part)
}

/// The longest part of at least three rungs of which `suits` is true; of several the one with the finest steps.
fn longest(logs: &[[f64; 2]], suits: fn(&[[f64; 2]]) -> bool) -> Option<(usize, usize)> {
    let suiting = parts(logs.len(), 3).filter(|&(from, to)| suits(&logs[from..to]));
    suiting.max_by_key(|&(from, to)| (to - from, usize::MAX - from))
}

fn is_near_a_line(part: &[[f64; 2]]) -> bool {
    let (slope, count) = (slope(part), part.len() as f64);
    let mean = [0, 1].map(|axis| part.iter().map(|point| point[axis]).sum::<f64>() / count);
    let off = |point: &[f64; 2]| point[1] - mean[1] - slope * (point[0] - mean[0]);
    let squares: f64 = part.iter().map(|point| off(point) * off(point)).sum();
    slope > LEAST && (squares / count).sqrt() <= SCATTER
}

/// By how much neighbouring slopes differ from their mean; `None` where the part is not straight.
fn spread(part: &[[f64; 2]]) -> Option<f64> {
    let slopes = part.windows(2).map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]));
    let mean = slopes.clone().sum::<f64>() / (part.len() - 1) as f64;
    let most = slopes.map(|slope| (slope - mean).abs()).fold(0.0, f64::max);
    (mean > LEAST && most <= STRAIGHT).then_some(most)
}

/// Least squares of the second over the first.
fn slope(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let mean = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / count);
    let sum = |axis: usize| -> f64 {
        points.iter().map(|point| (point[0] - mean[0]) * (point[axis] - mean[axis])).sum()
    };
    sum(1) / sum(0)
}

#[cfg(test)]
mod tests {
    use super::fit;

    #[test]
    fn a_pure_power_has_its_order() {
        let points: Vec<[f64; 2]> = (0..6).map(|k| libm::ldexp(1.0, -k)).map(|h| [h, 3.0 * h * h]).collect();
        let order = fit(&points).unwrap();
        assert!((order.slope - 2.0).abs() < 1e-12);
        assert_eq!(order.rungs, 6);
        assert!((order.steps[0] - 1.0 / 32.0).abs() < 1e-12 && (order.steps[1] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn floor_and_coarse_end_are_no_part_of_it() {
        // Order 4 between a plateau and a floor of rounding.
        let error = |h: f64| (h * h * h * h).min(1e-3) + 1e-12;
        let points: Vec<[f64; 2]> = (0..14).map(|k| libm::ldexp(1.0, -k)).map(|h| [h, error(h)]).collect();
        let order = fit(&points).unwrap();
        assert!((order.slope - 4.0).abs() < 0.15, "{order:?}");
        assert!(order.steps[0] < 5e-3 && order.steps[1] < 0.3, "{order:?}");
    }

    #[test]
    fn the_straightest_part_is_the_one_that_theory_speaks_of() {
        // Height between samples, measured: order 1.3 where steps are coarse, 1.9 where they are fine.
        let errors = [2.252, 0.9050, 0.3041, 0.08870, 0.02374, 0.00604, 0.00152];
        let points: Vec<[f64; 2]> = (0..7).map(|k| [libm::ldexp(1.0, -k), errors[k as usize]]).collect();
        let order = fit(&points).unwrap();
        assert!((order.slope - 1.96).abs() < 0.03, "{order:?}");
        assert!((order.steps[0] - 1.0 / 64.0).abs() < 1e-12, "{order:?}");
    }

    #[test]
    fn an_error_that_jumps_has_the_order_of_all_rungs() {
        // A crest between samples: measured on a small scene.
        let errors = [2.98e-2, 3.89e-3, 1.58e-3, 2.28e-4, 1.41e-4];
        let points: Vec<[f64; 2]> = (0..5).map(|k| [libm::ldexp(1.0, -k), errors[k as usize]]).collect();
        let order = fit(&points).unwrap();
        assert_eq!(order.rungs, 5);
        assert!((order.slope - 1.95).abs() < 0.02, "{order:?}");
    }

    #[test]
    fn what_does_not_converge_has_none() {
        assert_eq!(fit(&[[1.0, 0.2], [0.5, 0.2], [0.25, 0.2], [0.125, 0.2]]), None);
        assert_eq!(fit(&[[1.0, 1.0], [0.5, 0.25]]), None, "two rungs make every order");
        assert_eq!(fit(&[[1.0, 0.0], [0.5, f64::NAN], [0.25, 1.0]]), None);
    }
}
