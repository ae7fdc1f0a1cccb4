//! Figures of a survey.

use crate::elevation::Elevation;
use crate::survey::Grid;

/// The largest residual and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// Height of the file less height of the fit (m).
    pub residual: f64,
    /// Line and column of the file, from 0.
    pub in_file: [i64; 2],
    /// North, east in the bank (m).
    pub place: [f64; 2],
}

/// How the fit behaves where the file has no data: regions without a sample, up to three regions from the nearest
/// region with one. Taken at the places of the missing samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VoidBounds {
    /// Number of regions without data that were looked at.
    pub regions: usize,
    /// Lowest and highest ground (m).
    pub height: [f64; 2],
    /// Steepest ground, rise over run.
    pub slope: f64,
}

/// Figures of one fitted level.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelReport {
    /// Side of a region (m).
    pub region_size: f64,
    /// Corners to the north and east.
    pub corners: [usize; 2],
    /// Words: nine a corner.
    pub coefficients: usize,
    /// Samples that the fit saw.
    pub used: usize,
    /// Sample places without a height, in the level.
    pub void: usize,
    /// Samples kept from the fit to test it.
    pub held_out: usize,
    /// Root mean square of the residuals of the used samples (m).
    pub rms: f64,
    /// Largest residual, used or held out.
    pub worst: Worst,
    /// Root mean square of the residuals of the samples held out (m). In files that were interpolated from coarser
    /// data, neighbours are alike and this says little.
    pub held_out_rms: Option<f64>,
    /// Condition numbers of the normal matrices of both axes without voids, words scaled to unit diagonal. Their
    /// product estimates that of the fit to a full grid (power iteration: from below).
    pub condition_of_axes: [f64; 2],
    /// Condition number that voids and stiffened regions add: of the normal equations relative to the full grid
    /// (Lanczos values of the iteration: from below).
    pub condition_of_voids: f64,
    /// Iterations of conjugate gradients.
    pub iterations: usize,
    /// Residual of the normal equations over the right-hand side, in the norm of the preconditioner.
    pub relative_residual: f64,
    /// Lowest and highest fitted ground (m), at sample places, voids included.
    pub height: [f64; 2],
    /// Steepest fitted ground, rise over run, at sample places, voids included.
    pub slope: f64,
    /// Behaviour in voids; `None` if no region is without samples.
    pub in_voids: Option<VoidBounds>,
}

impl LevelReport {
    /// Angle of the steepest fitted ground (rad).
    pub fn steepest(&self) -> f64 {
        libm::atan(self.slope)
    }
}

/// A whole survey. Holds no times: two runs on the same input give equal reports.
#[derive(Debug, Clone, PartialEq)]
pub struct SurveyReport {
    /// Title of what was surveyed, for people.
    pub title: String,
    /// Area: south, west, north, east in the coordinates of the file (m, or rad where geographic); in metres about
    /// the centre where a geographic file was laid onto an orthographic plane.
    pub area: [f64; 4],
    /// Lines and columns in the area, with what the last regions reach beyond it.
    pub samples: [usize; 2],
    /// From sample to sample, north and east (m).
    pub spacing: [f64; 2],
    /// Lowest and highest sample in the area (m).
    pub height: [f64; 2],
    /// Direction of true north at the centre, clockwise from the bank's north axis (rad), where it is known.
    pub true_north: Option<f64>,
    /// Figures of each level, the finest first.
    pub levels: Vec<LevelReport>,
    /// What the user should know.
    pub warnings: Vec<String>,
    /// Estimate of the largest memory in use (bytes): elevation, patch, grids and vectors of the largest fit.
    pub peak_memory: usize,
}

impl SurveyReport {
    /// Lines and columns of `grid` that `elevation` holds; the others lie beyond the file, under the last regions. Both
    /// must be those of the survey, its samples as they are in the file and not interpolated.
    pub fn held_by_file(&self, elevation: &Elevation, grid: &Grid) -> [usize; 2] {
        let (held, counts) = (elevation.extent(), [grid.lines, grid.columns]);
        [0, 1].map(|axis| {
            if axis == 1 && elevation.grid().turn().is_some() {
                return counts[axis];
            }
            let step = elevation.affine.step[axis].abs();
            let first = self.area[axis] + grid.first[axis] / grid.step[axis] * step;
            let inside = |index: &usize| {
                let at = first + *index as f64 * step;
                at > held[axis] - 0.5 * step && at < held[2 + axis] + 0.5 * step
            };
            (0..counts[axis]).filter(inside).count()
        })
    }
}
