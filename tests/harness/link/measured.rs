//! What is measured in a still.

use super::Still;

/// Michelson contrast of 5th and 95th percentile over all pixels of water.
pub fn contrast(still: &Still) -> f64 {
    let mut light: Vec<f64> = still.shown().filter(|light| !light.is_nan()).collect();
    light.sort_by(f64::total_cmp);
    let at = |part: f64| light[(part * (light.len() - 1) as f64) as usize];
    let [low, high] = [at(0.05), at(0.95)];
    (high - low) / (high + low)
}

/// Mean light of all pixels of water.
pub fn mean(still: &Still) -> f64 {
    let light: Vec<f64> = still.shown().filter(|light| !light.is_nan()).collect();
    light.iter().sum::<f64>() / light.len() as f64
}

/// Largest step of light between two neighbours of a line in the lower half, over the mean.
pub fn largest_step(still: &Still) -> f64 {
    let light: Vec<f64> = still.shown().collect();
    let lines: Vec<&[f64]> = light.chunks(still.columns()).collect();
    let lower = &lines[lines.len() / 2..];
    let steps = lower.iter().flat_map(|line| line.windows(2).map(|pair| (pair[1] - pair[0]).abs()));
    steps.filter(|step| !step.is_nan()).fold(0.0, f64::max) / mean(still)
}

/// Mean distance of light between two stills, over the mean of the first.
pub fn apart(a: &Still, b: &Still) -> f64 {
    let pairs = a.shown().zip(b.shown()).map(|(a, b)| (a - b).abs());
    let apart: Vec<f64> = pairs.filter(|apart| !apart.is_nan()).collect();
    apart.iter().sum::<f64>() / apart.len() as f64 / mean(a)
}

/// A number as the page prints it.
pub fn told(value: f64) -> String {
    format!("{value:.3}")
}
