//! Reads two-dimensional `.npy` arrays as elevations.

use std::path::Path;

use files::npy_layout;

use super::bands;
use super::kind::Kind;
use super::opened::Opened;
use super::options::ReadOptions;
use super::raw::Raw;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::words::Decider;
use crate::elevation::{Frame, Grid};
use crate::error::SurveyError;

/// Opens an array; NaN is a void.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let layout = npy_layout(path)?;
    let [lines, columns] = *layout.shape else {
        let advice = "save a 2-D array: heights, line by line";
        return Err(field(path, "shape", format!("{:?}", layout.shape), "[lines, columns]", advice));
    };
    bands::of_raw(path, options, 1)?;
    check_raster(path, lines as u64, columns as u64)?;
    let affine = options.own_place(lines).ok_or_else(|| SurveyError::NoSpacing(path.to_path_buf()))?;
    let kind = Kind {
        bytes: layout.value_bytes,
        real: layout.is_real,
        signed: layout.is_signed,
        little: layout.is_little,
    };
    let raw = Raw::lines_of(path, [lines, columns], kind, layout.offset);
    // In Fortran's order the columns stand one after the other.
    let by_columns = Raw { block: [lines, 1], block_step: (lines * kind.bytes) as u64, ..raw.clone() };
    let raw = if layout.fortran_order { by_columns } else { raw };
    Ok(Opened {
        grid: Grid { lines, columns, affine, frame: Frame::Plane(None) },
        path: path.to_path_buf(),
        title: String::new(),
        sources: vec![path.to_path_buf()],
        notes: Decider::new(path, options).finish()?,
        conversion: Conversion::new(path, options, Said { stored: kind.stored(), ..Said::default() })?,
        samples: Box::new(raw),
    })
}
