//! Conditioning of the survey fit, by size of the regions and by the share of the samples that is missing.

use quantities::unit_interval;
use serde::Serialize;
use survey::{Affine, Elevation, Frame, SurveyOptions, survey};

/// Samples of a side, a metre apart.
const SIDE: usize = 48;
/// Region sizes (m, that is samples).
const SIZES: [f64; 5] = [1.5, 3.0, 6.0, 12.0, 24.0];
/// Share of the samples that is missing.
const HOLES: [f64; 4] = [0.0, 0.1, 0.5, 0.9];
/// Side of a hole (samples): holes are squares, as shadows in photographs are no single samples.
const HOLE: usize = 6;
/// Noise that is put on the heights (m), either way.
const NOISE: f64 = 1e-3;

/// Outcome of one survey fit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FitOutcome {
    /// Side of a region (samples).
    pub region: f64,
    /// Share of the samples that is missing.
    pub holes: f64,
    /// Condition number of the fit to a full grid: product of both axes.
    pub condition: f64,
    /// What holes multiply it by.
    pub condition_of_holes: f64,
    /// Largest change of the fitted heights, where there is a sample, over the largest noise put on the samples.
    pub growth: f64,
    /// The same over the whole area, holes included.
    pub growth_in_holes: f64,
    /// Number of iterations that the fit took.
    pub iterations: usize,
    /// Why there is no fit.
    pub refused: Option<String>,
}

/// Every region size with every share of holes.
pub fn survey_fits() -> Vec<FitOutcome> {
    SIZES.iter().flat_map(|&region| HOLES.map(|holes| outcome(region, holes))).collect()
}

fn outcome(region: f64, holes: f64) -> FitOutcome {
    let mut outcome = FitOutcome {
        region,
        holes,
        condition: 0.0,
        condition_of_holes: 0.0,
        growth: 0.0,
        growth_in_holes: 0.0,
        iterations: 0,
        refused: None,
    };
    let options = SurveyOptions { held_out: 0.0, ..SurveyOptions::new(region) };
    let fits = [0.0, NOISE].map(|noise| survey(&ground(holes, noise), &options, &mut |_| {}));
    let [Ok(clean), Ok(noisy)] = &fits else {
        let why = fits.into_iter().find_map(Result::err).map(|error| error.to_string());
        return FitOutcome { refused: why, ..outcome };
    };
    let report = &clean.report.levels[0];
    let changes = clean.fitted.values.iter().zip(&noisy.fitted.values).zip(&clean.residuals.values);
    for ((clean, noisy), residual) in changes {
        let change = (noisy - clean).abs() / NOISE;
        // Places beyond the file have no height; NaN compares as no larger.
        outcome.growth_in_holes = outcome.growth_in_holes.max(change);
        if residual.is_finite() {
            outcome.growth = outcome.growth.max(change);
        }
    }
    FitOutcome {
        condition: report.condition_of_axes[0] * report.condition_of_axes[1],
        condition_of_holes: report.condition_of_voids,
        iterations: report.iterations,
        ..outcome
    }
}

/// Rolling ground with square holes.
fn ground(holes: f64, noise: f64) -> Elevation {
    let height = |sample: usize| {
        let (line, column) = (sample / SIDE, sample % SIDE);
        let hole = (line / HOLE * SIDE + column / HOLE) as u64;
        if unit_interval(11, &[hole]) < holes {
            return f64::NAN;
        }
        let (x, y) = (line as f64, column as f64);
        let wave = 3.0 * libm::sin(0.11 * x + 0.3) * libm::cos(0.07 * y) + 0.02 * x;
        wave + noise * (2.0 * unit_interval(12, &[sample as u64]) - 1.0)
    };
    let heights = (0..SIDE * SIDE).map(height).collect();
    Elevation::new(SIDE, SIDE, heights, Affine { first: [0.0; 2], step: [1.0; 2] }, Frame::Plane(None))
}
