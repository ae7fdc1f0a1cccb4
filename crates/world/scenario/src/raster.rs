//! What is seen: field of view, raster, display transfer.

use quantities::Rate;

/// Half sizes of the view-plane over its distance: the report's screen is 50 x 30 degrees (II.A).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldOfView {
    /// Tangent of half the horizontal angle.
    pub tan_half_width: f64,
    /// Tangent of half the vertical angle.
    pub tan_half_height: f64,
}

/// The field of view that a scenario asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FieldWish {
    /// Both angles are given.
    Both(FieldOfView),
    /// Tangent of half the horizontal angle; pixels are square.
    Across(f64),
}

impl FieldWish {
    /// The field of a picture of `columns` x `lines` pixels.
    pub fn of_picture(self, columns: u32, lines: u32) -> FieldOfView {
        match self {
            Self::Both(field) => field,
            Self::Across(tan_half_width) => {
                let tan_half_height = tan_half_width * f64::from(lines) / f64::from(columns);
                FieldOfView { tan_half_width, tan_half_height }
            }
        }
    }
}

/// The raster that a scenario or a command asks for; what is left open is the model's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RasterWishes {
    /// Sweeps a frame, 1..=8192.
    pub sweeps: Option<u32>,
    /// Samples drawn in one sweep, 2..=65536.
    pub samples: Option<u32>,
    /// Columns of the read-out; as many as sweeps if open.
    pub columns: Option<u32>,
    /// Lines of the read-out; such that pixels are square if open.
    pub lines: Option<u32>,
    /// Pictures computed a second.
    pub update: Option<Rate>,
    /// Pictures shown a second, a whole multiple of `update`.
    pub refresh: Option<Rate>,
}

impl RasterWishes {
    /// These wishes, and `others` where nothing is wished.
    pub fn or(self, others: RasterWishes) -> RasterWishes {
        RasterWishes {
            sweeps: self.sweeps.or(others.sweeps),
            samples: self.samples.or(others.samples),
            columns: self.columns.or(others.columns),
            lines: self.lines.or(others.lines),
            update: self.update.or(others.update),
            refresh: self.refresh.or(others.refresh),
        }
    }
}

/// Scalar type of the analog signals; geometry is f64 always.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scalar {
    /// Single precision: the fast one.
    F32,
    /// Double precision: the reference.
    F64,
}

/// From reflectivity to grey.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Display {
    /// Reflectivity that is shown white (exposure), above 0.
    pub white: f64,
    /// Grey code is `(reflectivity / white)^(1 / gamma)`; 1 is the linear display of the report.
    pub gamma: f64,
}
