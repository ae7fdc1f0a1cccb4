//! Reads two-dimensional `.npy` arrays as elevations.

use std::path::Path;

use limits::Limit;

use super::options::ReadOptions;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::words::Decider;
use crate::elevation::{Elevation, Frame};
use crate::error::SurveyError;

/// Reads heights; NaN is a void.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let array = files::read_npy(path, Limit::ElevationBytes)?;
    let [lines, columns] = *array.shape() else {
        let advice = "save a 2-D array: heights, line by line";
        return Err(field(path, "shape", format!("{:?}", array.shape()), "[lines, columns]", advice));
    };
    check_raster(path, lines as u64, columns as u64)?;
    let place = options.own_place(lines).ok_or_else(|| SurveyError::NoSpacing(path.to_path_buf()))?;
    let conversion = Conversion::new(path, options, Said::default())?;
    let mut heights = array.data().to_f64();
    let notes = conversion.convert(path, &mut heights, columns)?;
    let mut elevation = Elevation::new(lines, columns, heights, place, Frame::Plane(None));
    elevation.sources = vec![path.to_path_buf()];
    elevation.notes = [notes, Decider::new(path, options).finish()?].concat();
    Ok(elevation)
}
