//! Residuals of a survey on the raster of its samples.

use crate::PlotError;
use crate::axis::round_up;

/// Sample minus fitted ground (m) on a raster; NaN where there is no sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residuals<'a> {
    /// Place of the first sample: north, east (m).
    pub first: [f64; 2],
    /// From one row to the next and from one column to the next (m); negative where they run south or west.
    pub spacing: [f64; 2],
    /// Number of rows and columns.
    pub samples: [usize; 2],
    /// Row by row, columns fastest.
    pub values: &'a [f64],
}

/// What a pixel of the map shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Spot {
    /// The raster does not reach this pixel.
    Outside,
    /// A raster without a sample.
    Void,
    /// The residual of largest magnitude in the pixel (m).
    Worst(f64),
}

/// Figures of all residuals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Figures {
    pub count: usize,
    pub voids: usize,
    pub rms: f64,
    pub worst: f64,
    /// Round limit of the scale, which holds 99.5 % of the samples.
    pub limit: f64,
}

impl Residuals<'_> {
    pub(crate) fn check(&self) -> Result<(), PlotError> {
        let [rows, columns] = self.samples;
        let expected = rows.saturating_mul(columns);
        if self.values.len() != expected {
            return Err(PlotError::Count { what: "residuals".into(), found: self.values.len(), expected });
        }
        for (what, number) in [("first", self.first), ("spacing", self.spacing)] {
            for found in number {
                if !found.is_finite() || (what == "spacing" && found == 0.0) {
                    let what = format!("residuals.{what}");
                    return Err(PlotError::Value {
                        what,
                        found,
                        expected: "a finite length, not 0 for spacing",
                    });
                }
            }
        }
        Ok(())
    }

    pub(crate) fn figures(&self) -> Result<Figures, PlotError> {
        let mut sizes: Vec<f64> = self.values.iter().filter(|v| v.is_finite()).map(|v| v.abs()).collect();
        if sizes.is_empty() {
            return Err(PlotError::Empty { what: "residuals".into() });
        }
        let count = sizes.len();
        let rms = (sizes.iter().map(|v| v * v).sum::<f64>() / count as f64).sqrt();
        let worst = sizes.iter().copied().fold(0.0, f64::max);
        let place = (count - 1) * 995 / 1000;
        let (_, most, _) = sizes.select_nth_unstable_by(place, f64::total_cmp);
        let limit = round_up(*most);
        Ok(Figures { count, voids: self.values.len() - count, rms, worst, limit })
    }

    /// What lies between two norths and two easts (m).
    pub(crate) fn spot(&self, north: [f64; 2], east: [f64; 2]) -> Spot {
        let (rows, columns) = (self.indices(0, north), self.indices(1, east));
        if rows.is_empty() || columns.is_empty() {
            return Spot::Outside;
        }
        let worst = rows
            .flat_map(|row| columns.clone().map(move |column| self.values[row * self.samples[1] + column]))
            .filter(|value| value.is_finite())
            .fold(None, |worst: Option<f64>, value| match worst {
                Some(worst) if worst.abs() >= value.abs() => Some(worst),
                _ => Some(value),
            });
        worst.map_or(Spot::Void, Spot::Worst)
    }

    /// Samples whose middle lies between two places; the nearest one where there is none.
    fn indices(&self, axis: usize, [from, to]: [f64; 2]) -> std::ops::Range<usize> {
        let index = |place: f64| (place - self.first[axis]) / self.spacing[axis];
        let (low, high) = (index(from).min(index(to)), index(from).max(index(to)));
        let count = self.samples[axis] as f64;
        let first = low.round();
        let end = high.round().max(first + 1.0);
        if end <= 0.0 || first >= count {
            return 0..0;
        }
        first.max(0.0) as usize..end.min(count) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::{Residuals, Spot};

    const VALUES: [f64; 6] = [0.1, -0.5, 0.3, f64::NAN, f64::NAN, 0.2];

    fn residuals() -> Residuals<'static> {
        // First row in the north, as image files have it.
        Residuals { first: [100.0, 0.0], spacing: [-10.0, 20.0], samples: [2, 3], values: &VALUES }
    }

    #[test]
    fn a_pixel_shows_its_worst_sample() {
        let all = residuals();
        assert_eq!(all.spot([95.0, 105.0], [-10.0, 50.0]), Spot::Worst(-0.5));
        assert_eq!(all.spot([89.0, 91.0], [-1.0, 1.0]), Spot::Void);
        assert_eq!(all.spot([99.0, 101.0], [39.0, 40.0]), Spot::Worst(0.3));
        assert_eq!(all.spot([70.0, 75.0], [0.0, 1.0]), Spot::Outside);
    }

    #[test]
    fn figures_leave_voids_out() {
        let found = residuals().figures().unwrap();
        assert_eq!((found.count, found.voids, found.worst), (4, 2, 0.5));
        assert!((found.rms - (0.39f64 / 4.0).sqrt()).abs() < 1e-15);
        let voids = [f64::NAN];
        assert!(Residuals { samples: [1, 1], values: &voids, ..residuals() }.figures().is_err());
    }

    #[test]
    fn rasters_that_cannot_be_are_refused() {
        assert!(residuals().check().is_ok());
        assert!(Residuals { samples: [3, 3], ..residuals() }.check().is_err());
        assert!(Residuals { spacing: [0.0, 1.0], ..residuals() }.check().is_err());
        assert!(Residuals { first: [f64::NAN, 1.0], ..residuals() }.check().is_err());
    }
}
