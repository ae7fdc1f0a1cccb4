//! Plain coefficients: an NPY array [m north, n east, 3p+q].

use crate::{BankError, Level, WORDS};
use files::{Npy, NpyData};

/// Why an array is not the corners of a level.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CornersError {
    /// The shape is not [north, east, 9].
    #[error("array of shape {found:?}: expected [corners north, corners east, 9 words], words fastest")]
    Shape {
        /// Shape of the array that was found.
        found: Vec<usize>,
    },
    /// The values are not f64.
    #[error("array of type {found}: expected f64, as fourth derivatives need its digits; save it as float64")]
    Type {
        /// Name of the number type that was found.
        found: &'static str,
    },
    /// The corners do not make a level.
    #[error(transparent)]
    Level(#[from] BankError),
}

/// The level of an array `[m north, n east, 3p+q]`: words `d^(p+q) h_(x^p y^q)` in metres, m and n ascending from
/// the origin (north, east, m). Byte order and Fortran order are the NPY reader's affair.
///
/// # Errors
/// If shape or type are wrong, or [`Level::new`] refuses.
pub fn import_corners(array: Npy, region_size: f64, origin: [f64; 2]) -> Result<Level, CornersError> {
    let (shape, data) = array.into_parts();
    let &[north, east, WORDS] = shape.as_slice() else {
        return Err(CornersError::Shape { found: shape });
    };
    let NpyData::F64(values) = data else {
        return Err(CornersError::Type { found: type_name(&data) });
    };
    let words = values.as_chunks::<WORDS>().0.to_vec();
    Ok(Level::new(region_size, origin, [north, east], words)?)
}

/// The corners of a level as an array `[m north, n east, 3p+q]` of f64.
pub fn export_corners(level: &Level) -> Npy {
    let [north, east] = level.corners();
    let values = level.words().as_flattened().to_vec();
    Npy::new(vec![north, east, WORDS], values).expect("a level has nine words for each of its corners")
}

fn type_name(data: &NpyData) -> &'static str {
    match data {
        NpyData::U8(_) => "u8",
        NpyData::I8(_) => "i8",
        NpyData::U16(_) => "u16",
        NpyData::I16(_) => "i16",
        NpyData::U32(_) => "u32",
        NpyData::I32(_) => "i32",
        NpyData::U64(_) => "u64",
        NpyData::I64(_) => "i64",
        NpyData::F32(_) => "f32",
        NpyData::F64(_) => "f64",
    }
}
