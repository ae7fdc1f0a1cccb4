//! The affine between pixels and the image plane.
//!
//! `x = A1 I + B1 J + C1`, `y = A2 I + B2 J + C2`: micrometres of pixels. The centre of a pixel lies at half a pixel.

use crate::CameraError;

/// Least determinant that can be inverted, by the size of the coefficients squared (chosen).
const LEAST_DETERMINANT: f64 = 1e-12;

/// An affine from pixels to micrometres, with its inverse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine {
    first: [f64; 3],
    second: [f64; 3],
    determinant: f64,
}

impl Affine {
    /// The affine of the rows (A1, B1, C1) and (A2, B2, C2): micrometres a pixel, micrometres a pixel, micrometres.
    ///
    /// # Errors
    ///
    /// If a coefficient is not finite, or the affine maps the picture onto a line.
    pub fn new(first: [f64; 3], second: [f64; 3]) -> Result<Self, CameraError> {
        for value in first.into_iter().chain(second) {
            CameraError::figure("affine coefficient", value, "a finite number", |_| true)?;
        }
        let determinant = first[0] * second[1] - first[1] * second[0];
        let size = [first[0], first[1], second[0], second[1]]
            .into_iter()
            .fold(0.0, |size: f64, c| size.max(c.abs()));
        let inverts = determinant.abs() > LEAST_DETERMINANT * size * size;
        if !inverts {
            return Err(CameraError::NoInverse { determinant, size });
        }
        Ok(Self { first, second, determinant })
    }

    /// Image coordinates x, y (micrometres) of a pixel I, J.
    pub fn image(&self, [i, j]: [f64; 2]) -> [f64; 2] {
        [self.first, self.second].map(|[a, b, c]| a * i + b * j + c)
    }

    /// Pixel I, J of image coordinates x, y (micrometres).
    pub fn pixel(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([a1, b1, c1], [a2, b2, c2]) = (self.first, self.second);
        let (x, y) = (x - c1, y - c2);
        [(x * b2 - y * b1) / self.determinant, (y * a1 - x * a2) / self.determinant]
    }

    /// The rows (A1, B1, C1) and (A2, B2, C2), in micrometres a pixel and micrometres.
    pub fn rows(&self) -> [[f64; 3]; 2] {
        [self.first, self.second]
    }
}
