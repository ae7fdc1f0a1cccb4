//! How far the mean of a sample is to be trusted.

use quantities::hash_words;

/// Share of intervals that hold the mean of the whole run.
pub(super) const CONFIDENCE: f64 = 0.95;
/// Samples that are drawn from the sample.
pub(super) const RESAMPLES: usize = 2000;

/// Percentile bootstrap of the mean of `values`; `None` for fewer than two. Errors of sweeps are skew, so no normal law is
/// assumed of them; parts of the run make the interval rather too wide than too narrow.
pub(super) fn interval(seed: u64, values: &[f64]) -> Option<[f64; 2]> {
    let count = values.len();
    if count < 2 {
        return None;
    }
    let drawn = |resample: usize, index: usize| {
        values[(hash_words(seed, &[resample as u64, index as u64]) % count as u64) as usize]
    };
    let mean = |resample: usize| (0..count).map(|index| drawn(resample, index)).sum::<f64>() / count as f64;
    let mut means: Vec<f64> = (0..RESAMPLES).map(mean).collect();
    means.sort_by(f64::total_cmp);
    let tail = (0.5 * (1.0 - CONFIDENCE) * RESAMPLES as f64).round() as usize;
    Some([means[tail], means[RESAMPLES - 1 - tail]])
}

#[cfg(test)]
mod tests {
    use quantities::unit_interval;

    use super::{CONFIDENCE, interval};

    #[test]
    fn a_single_value_has_none_and_equal_ones_a_point() {
        assert_eq!(interval(1, &[2.0]), None);
        assert_eq!(interval(1, &[2.0; 9]), Some([2.0; 2]));
    }

    /// Of the squares of even numbers between 0 and 1 the mean is a third.
    #[test]
    fn it_holds_the_mean_as_often_as_it_says() {
        let holds = |trial: u64| {
            let values: Vec<f64> =
                (0..40).map(|index| unit_interval(7, &[trial, index])).map(|u| u * u).collect();
            let [low, high] = interval(trial, &values).unwrap();
            low <= 1.0 / 3.0 && 1.0 / 3.0 <= high
        };
        let share = (0..200).filter(|trial| holds(*trial)).count() as f64 / 200.0;
        assert!((share - CONFIDENCE).abs() < 0.05, "{share}");
    }
}
