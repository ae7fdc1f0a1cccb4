//! Least-squares fit of one level: neighbouring regions share corners, all words are found at once.

mod axis;
mod condition;
mod gradients;
mod normal;
mod precondition;
mod roughness;

use landscape::{CornerWords, Level};
use rayon::prelude::*;

pub use axis::Axis;
pub use gradients::Stop;
pub use normal::{Place, across_line, both, dot};

use crate::error::SurveyError;
use crate::fill::MeanPlane;
use crate::patch::Patch;
use normal::Normal;
use precondition::{AxisFactor, Preconditioner};
use roughness::{AxisMatrix, Roughness, axis_matrix};

/// How stiff the fitted ground is, and how strongly it follows filled voids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// Length in region sizes; ground waves shorter than about 2 pi times this are smoothed. The penalty is the
    /// integral of `h_xx^2 + 2 h_xy^2 + h_yy^2` times the fourth power of the length, over the area of a sample.
    /// Default 0.03.
    pub smoothing: f64,
    /// Weight of a filled height against 1 for a sample; its inverse bounds the condition that voids add.
    /// Default 0.05.
    pub filled_weight: f64,
}

impl Default for Stiffness {
    fn default() -> Self {
        Self { smoothing: 0.03, filled_weight: 0.05 }
    }
}

/// A fitted level and how the solution went.
#[derive(Debug)]
pub struct Fit {
    /// Level of terrain coefficients that was fitted.
    pub level: Level,
    /// Samples to the north and to the east, by region.
    pub axes: [Axis; 2],
    /// Number of iterations that the solution took.
    pub iterations: usize,
    /// Last relative residual of the normal equations.
    pub relative_residual: f64,
    /// Condition of each axis without voids, words at unit diagonal.
    pub condition_of_axes: [f64; 2],
    /// Condition that voids add (Lanczos values of the preconditioned equations).
    pub condition_of_voids: f64,
    /// Bytes of the vectors of the solution.
    pub memory: usize,
}

/// Fits a level of `regions` with side `size` (m), origin (0, 0), to the samples that `places`
/// marks as used and, weakly, to the `filled` heights above their mean plane.
///
/// # Errors
/// If the words cannot form a level (never for finite samples and a positive size).
pub fn fit(
    patch: &Patch,
    places: &[Place],
    filled: &(MeanPlane, Vec<f64>),
    size: f64,
    regions: [usize; 2],
    stiffness: Stiffness,
    stop: Stop,
    progress: &mut dyn FnMut(usize, f64),
) -> Result<Fit, SurveyError> {
    let axes = [0, 1].map(|k| Axis::new(regions[k], size, patch.first[k], patch.step[k], patch.count[k]));
    let bending = fourth(smoothing_length(size, patch.step, stiffness));
    let per_region = patch.step.map(|step| size / step);
    let roughness = Roughness::new(per_region[0] * per_region[1] * bending);
    let [north, east] = &axes;
    let normal = Normal {
        north,
        east,
        places,
        columns: patch.count[1],
        filled_weight: stiffness.filled_weight,
        roughness: &roughness,
    };
    let bend = axis_matrix(2);
    let bends: [AxisMatrix; 2] = per_region.map(|samples| bend.map(|row| row.map(|v| samples * bending * v)));
    let factors = [0, 1].map(|k| AxisFactor::new(&axes[k], &bends[k]));
    let condition_of_axes = [0, 1].map(|k| condition::of_grid(&axes[k], &bends[k], &factors[k]));
    let [north_factor, east_factor] = factors;
    let preconditioner = Preconditioner::new(north_factor, east_factor);

    let [rows, row] = normal.corners();
    let mut right = vec![[0.0; 9]; rows * row];
    let mut sums: Vec<CornerWords> = vec![[0.0; 9]; 2 * row * (rows - 1)];
    normal.project(&filled.1, &mut right, &mut sums);
    let solution = gradients::solve(&normal, &preconditioner, right, &mut sums, stop, progress);
    let mut words = solution.words;
    add_plane(&filled.0, size, row, &mut words);
    let memory = (5 * rows * row + sums.len()) * size_of::<CornerWords>();
    Ok(Fit {
        level: Level::new(size, [0.0; 2], [rows, row], words)?,
        iterations: solution.iterations,
        relative_residual: solution.residual,
        condition_of_axes,
        condition_of_voids: condition::of_lanczos(&solution.lanczos),
        memory,
        axes,
    })
}

/// Smoothing length in region sizes; a region smaller than three samples is smoothed over three samples.
fn smoothing_length(size: f64, step: [f64; 2], stiffness: Stiffness) -> f64 {
    stiffness.smoothing * (3.0 * step[0].max(step[1]) / size).max(1.0)
}

/// Fraction of the sample places of each region that are void, 0 where there is no place.
pub fn lacking(patch: &Patch, [north, east]: &[Axis; 2]) -> Vec<f64> {
    let of_strip = |strip: usize| -> Vec<f64> {
        let of_region = |region: usize| {
            let columns = east.of_region(region);
            let lines = north.of_region(strip);
            let places = lines.len() * columns.len();
            let void = |line: usize| {
                let row = &patch.heights[line * patch.count[1]..][columns.clone()];
                row.iter().filter(|h| h.is_nan()).count()
            };
            if places == 0 { 0.0 } else { lines.map(void).sum::<usize>() as f64 / places as f64 }
        };
        (0..east.regions()).map(of_region).collect()
    };
    (0..north.regions()).into_par_iter().map(of_strip).collect::<Vec<_>>().concat()
}

/// Puts the plane back that was taken out before the fit.
fn add_plane(plane: &MeanPlane, size: f64, row: usize, words: &mut [CornerWords]) {
    for (index, words) in words.iter_mut().enumerate() {
        let place = [index / row, index % row].map(|corner| corner as f64 * size);
        words[0] += plane.at(place);
        words[1] += plane.slope[1] * size;
        words[3] += plane.slope[0] * size;
    }
}

fn fourth(x: f64) -> f64 {
    (x * x) * (x * x)
}
