//! Height profiles of mountains beyond the stored area (section 8).

use std::f64::consts::TAU;

use quantities::wrap_heading;

/// Why an outline cannot be one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SilhouetteError {
    /// Fewer than two points.
    #[error("{0} points: expected at least 2, which a line joins")]
    TooFewPoints(usize),
    /// A point that is no point.
    #[error(
        "point {index}: azimuth {azimuth} rad, tangent {tangent}: expected finite numbers, the tangent of at most {STEEPEST} either way"
    )]
    Point {
        /// Which, counted from 0.
        index: usize,
        /// Azimuth of the point (rad).
        azimuth: f64,
        /// Its tangent of elevation.
        tangent: f64,
    },
    /// Azimuths do not ascend.
    #[error("point {0}: azimuth not above that of the point before; list the points clockwise")]
    Order(usize),
    /// The outline runs around more than once.
    #[error("outline of {0} rad: expected at most one turn")]
    MoreThanATurn(f64),
    /// Reflectivity out of range.
    #[error("reflectivity {0}: expected 0 to 1")]
    Reflectivity(f64),
}

/// Largest tangent of elevation of an outline, either way.
const STEEPEST: f64 = 1000.0;

/// By how much an azimuth may miss the outline's end (rad): turns are taken off in floating point.
const ROUNDING: f64 = 1e-12;

/// The outline of far mountains: elevation against azimuth, of one reflectivity. It is drawn as a last point of the
/// profile: where it stands above all ground, it is seen down to that ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Silhouette {
    outline: Vec<[f64; 2]>,
    reflectivity: f64,
}

impl Silhouette {
    /// An outline of azimuths (rad, clockwise from north, ascending over at most one turn) and tangents of elevation,
    /// and what it returns (0..=1).
    ///
    /// # Errors
    /// If there are fewer than two points, if a number is out of its range or if azimuths do not ascend.
    pub fn new(outline: Vec<[f64; 2]>, reflectivity: f64) -> Result<Self, SilhouetteError> {
        if outline.len() < 2 {
            return Err(SilhouetteError::TooFewPoints(outline.len()));
        }
        let is_good = |[azimuth, tangent]: &[f64; 2]| azimuth.is_finite() && tangent.abs() <= STEEPEST;
        if let Some(index) = outline.iter().position(|point| !is_good(point)) {
            let [azimuth, tangent] = outline[index];
            return Err(SilhouetteError::Point { index, azimuth, tangent });
        }
        if let Some(before) = outline.windows(2).position(|pair| pair[1][0] <= pair[0][0]) {
            return Err(SilhouetteError::Order(before + 1));
        }
        let width = outline[outline.len() - 1][0] - outline[0][0];
        if width > TAU + ROUNDING {
            return Err(SilhouetteError::MoreThanATurn(width));
        }
        if !(0.0..=1.0).contains(&reflectivity) {
            return Err(SilhouetteError::Reflectivity(reflectivity));
        }
        Ok(Self { outline, reflectivity })
    }

    /// Azimuth (rad) and tangent of elevation of each point, clockwise.
    pub fn outline(&self) -> &[[f64; 2]] {
        &self.outline
    }

    /// What it returns, 0..=1.
    pub fn reflectivity(&self) -> f64 {
        self.reflectivity
    }

    /// Tangent of the elevation at `azimuth` (rad, any turn), straight between points; `None` beside the outline.
    pub fn tangent(&self, azimuth: f64) -> Option<f64> {
        let first = self.outline[0][0];
        let way = wrap_heading(azimuth - first);
        let after = self.outline.partition_point(|point| point[0] - first <= way);
        let [near, low] = *self.outline.get(after.checked_sub(1)?)?;
        let Some([far, high]) = self.outline.get(after) else {
            return (way - (near - first) <= ROUNDING).then_some(low);
        };
        Some(low + (high - low) * ((way - (near - first)) / (far - near)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Silhouette, SilhouetteError};
    use proptest::prelude::{prop_assert, proptest};
    use std::f64::consts::TAU;

    #[test]
    fn straight_between_points_and_nothing_beside() {
        let ridge = Silhouette::new(vec![[1.0, 0.0], [1.5, 0.1], [2.0, 0.05]], 0.6).unwrap();
        for (azimuth, expected) in [(1.0, 0.0), (1.25, 0.05), (1.5, 0.1), (1.75, 0.075), (2.0, 0.05)] {
            for turn in [-2.0, 0.0, 1.0] {
                let found = ridge.tangent(azimuth + turn * TAU);
                // The near end itself may be missed by rounding of the turn.
                if azimuth > 1.0 || turn == 0.0 {
                    assert!((found.unwrap() - expected).abs() < 1e-14, "{azimuth} + {turn} turns");
                }
            }
        }
        assert_eq!(ridge.tangent(2.0), Some(0.05));
        assert_eq!(ridge.tangent(0.99), None);
        assert_eq!(ridge.tangent(2.01), None);
        assert_eq!(ridge.tangent(2.01 - TAU), None);
    }

    #[test]
    fn an_outline_runs_through_north() {
        let ridge = Silhouette::new(vec![[6.0, 0.1], [6.6, 0.3]], 1.0).unwrap();
        assert!((ridge.tangent(0.0).unwrap() - (0.1 + 0.2 * (TAU - 6.0) / 0.6)).abs() < 1e-14);
        assert!((ridge.tangent(6.3 - TAU).unwrap() - 0.2).abs() < 1e-14);
    }

    proptest! {
        /// A ring has no gap, wherever it starts.
        #[test]
        fn a_ring_has_no_gap(start in -7.0..7.0f64, azimuth in -20.0..20.0f64) {
            let points = (0..=8).map(|k| [start + f64::from(k) * TAU / 8.0, 0.2]).collect();
            let ring = Silhouette::new(points, 0.5).unwrap();
            prop_assert!(ring.tangent(azimuth).is_some_and(|tangent| (tangent - 0.2).abs() < 1e-15));
        }
    }

    #[test]
    fn impossible_outlines_are_refused() {
        let refused =
            |points: &[[f64; 2]], reflectivity| Silhouette::new(points.to_vec(), reflectivity).unwrap_err();
        assert_eq!(refused(&[[0.0, 0.0]], 0.5), SilhouetteError::TooFewPoints(1));
        assert_eq!(refused(&[[0.0, 0.0], [0.0, 0.1]], 0.5), SilhouetteError::Order(1));
        assert!(matches!(
            refused(&[[0.0, 0.0], [f64::NAN, 0.1]], 0.5),
            SilhouetteError::Point { index: 1, .. }
        ));
        assert!(matches!(refused(&[[0.0, 2e3], [1.0, 0.1]], 0.5), SilhouetteError::Point { index: 0, .. }));
        assert_eq!(refused(&[[0.0, 0.0], [7.0, 0.1]], 0.5), SilhouetteError::MoreThanATurn(7.0));
        assert_eq!(refused(&[[0.0, 0.0], [1.0, 0.1]], 1.5), SilhouetteError::Reflectivity(1.5));
    }
}
