//! Reads two-dimensional `.npy` arrays as elevations.

use std::path::Path;

use limits::Limit;

use super::opened::{Opened, Samples};
use super::options::ReadOptions;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::stretch::Window;
use super::words::Decider;
use crate::elevation::{Frame, Grid};
use crate::error::SurveyError;

/// Opens an array, which is read whole at once; NaN is a void.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let array = files::read_npy(path, Limit::ElevationBytes)?;
    let [lines, columns] = *array.shape() else {
        let advice = "save a 2-D array: heights, line by line";
        return Err(field(path, "shape", format!("{:?}", array.shape()), "[lines, columns]", advice));
    };
    check_raster(path, lines as u64, columns as u64)?;
    let affine = options.own_place(lines).ok_or_else(|| SurveyError::NoSpacing(path.to_path_buf()))?;
    Ok(Opened {
        grid: Grid { lines, columns, affine, frame: Frame::Plane(None) },
        path: path.to_path_buf(),
        title: String::new(),
        sources: vec![path.to_path_buf()],
        notes: Decider::new(path, options).finish()?,
        conversion: Conversion::new(path, options, Said::default())?,
        samples: Box::new(Whole { columns, numbers: array.data().to_f64() }),
    })
}

/// All stored numbers, line by line.
struct Whole {
    columns: usize,
    numbers: Vec<f64>,
}

impl Samples for Whole {
    fn read(&mut self, window: &Window, _: &mut Vec<String>) -> Result<Vec<f64>, SurveyError> {
        if window.count() == self.numbers.len() {
            return Ok(std::mem::take(&mut self.numbers));
        }
        let line = |line: usize| &self.numbers[line * self.columns..][window.columns.clone()];
        Ok(window.lines.clone().flat_map(|at| line(at).iter().copied()).collect())
    }
}
