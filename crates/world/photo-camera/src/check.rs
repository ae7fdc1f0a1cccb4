//! Control points: how far a photograph and its ground disagree.

use glam::DVec3;

use crate::{Camera, CameraError, Image};

/// Fewest control points: a shift has two unknowns, and one point would always fit it.
const LEAST_POINTS: usize = 2;

/// A feature found on the ground and in the photograph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ControlPoint {
    /// Georectangular place of the feature (m).
    pub ground: DVec3,
    /// Pixel I, J where the photograph shows it.
    pub pixel: [f64; 2],
}

/// What control points say of a camera, in pixels.
#[derive(Debug, Clone, PartialEq)]
pub struct Residuals {
    /// Measured pixel less projected pixel (dI, dJ) of each point, in the order of the list.
    pub residuals: Vec<[f64; 2]>,
    /// Root of the mean squared distance.
    pub root_mean_square: f64,
    /// Shift (dI, dJ) of the projected pixels that leaves the least squares: the mean residual.
    pub best_shift: [f64; 2],
    /// Root of the mean squared distance that the best shift leaves.
    pub root_mean_square_shifted: f64,
    /// Index of the point of the largest distance; the first of equals.
    pub worst: usize,
}

impl Residuals {
    /// Whether the root mean square is at most `threshold` pixels.
    pub fn within(&self, threshold: f64) -> bool {
        self.root_mean_square <= threshold
    }
}

/// The residuals of control points.
///
/// # Errors
///
/// If there are fewer than two points, a coordinate is not finite, or a point lies behind the camera.
pub fn check(camera: &Camera, points: &[ControlPoint]) -> Result<Residuals, CameraError> {
    let pixel = |ground: DVec3| match camera.project(ground) {
        Image::Front { pixel, .. } => Some(pixel),
        Image::Behind { .. } => None,
    };
    check_by(pixel, points)
}

/// The residuals of control points whose pixels `pixel` projects: none where a point has no image.
///
/// # Errors
///
/// As [`check`].
pub fn check_by(
    pixel: impl Fn(DVec3) -> Option<[f64; 2]>,
    points: &[ControlPoint],
) -> Result<Residuals, CameraError> {
    if points.len() < LEAST_POINTS {
        return Err(CameraError::TooFewPoints { found: points.len(), least: LEAST_POINTS });
    }
    let residuals = points
        .iter()
        .enumerate()
        .map(|(index, point)| residual(&pixel, index, point))
        .collect::<Result<Vec<_>, _>>()?;
    let count = residuals.len() as f64;
    let best_shift = [0, 1].map(|k| residuals.iter().map(|residual| residual[k]).sum::<f64>() / count);
    let worst = (1..residuals.len()).fold(0, |worst, index| {
        if square(residuals[index]) > square(residuals[worst]) { index } else { worst }
    });
    Ok(Residuals {
        root_mean_square: root_mean_square(&residuals, [0.0; 2]),
        root_mean_square_shifted: root_mean_square(&residuals, best_shift),
        residuals,
        best_shift,
        worst,
    })
}

fn residual(
    pixel: &impl Fn(DVec3) -> Option<[f64; 2]>,
    index: usize,
    point: &ControlPoint,
) -> Result<[f64; 2], CameraError> {
    for value in point.ground.to_array().into_iter().chain(point.pixel) {
        CameraError::figure("coordinate of a control point", value, "a finite number", |_| true)?;
    }
    let projected = pixel(point.ground).ok_or(CameraError::Behind { index })?;
    Ok([0, 1].map(|k| point.pixel[k] - projected[k]))
}

fn square([i, j]: [f64; 2]) -> f64 {
    i * i + j * j
}

fn root_mean_square(residuals: &[[f64; 2]], shift: [f64; 2]) -> f64 {
    let sum: f64 = residuals.iter().map(|[i, j]| square([i - shift[0], j - shift[1]])).sum();
    (sum / residuals.len() as f64).sqrt()
}
