//! Error of one picture against another.
//!
//! - [`compare`]: RMSE, PSNR, worst pixel, share of pixels beyond some grey levels, all outside a mask, and
//!   [`ssim`] of the whole picture.
//! - [`compare_any`]: the same of pictures in colour, by luminance and by channel.
//! - [`compare_linear`]: RMSE, PSNR, bias and largest error of linear intensity; [`linear_intensity`] recovers it from a
//!   picture, [`linear_luminance`] from one in colour.
//! - [`flip`]: how different two pictures look to an eye.
//! - [`edge_mask`]: the pixels along ridges, outlines, shadow boundaries and kinks, with their share.
//! - [`ridge_mask`]: the pixels along silhouettes, where a shift by a fraction of a line is a large step.
//! - [`ridge_error`]: by how many lines the horizon lies elsewhere.
//! - [`shadow_agreement`]: where one picture is dark and the other lit.
//! - [`difference_picture`] and [`triptych`]: to look at.
//!
//! ```
//! use picture::{Depth, GreyPicture};
//! let reference = GreyPicture::new(2, 2, Depth::Eight, vec![10, 20, 30, 40])?;
//! let test = GreyPicture::new(2, 2, Depth::Eight, vec![10, 20, 30, 43])?;
//! let comparison = compare::compare(&test, &reference, None, &[2])?;
//! assert_eq!(comparison.beyond[0].count, 1);
//! assert_eq!(comparison.beyond[0].share, 0.25);
//! assert_eq!((comparison.worst.column, comparison.worst.line), (1, 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod colour;
mod difference;
mod edges;
mod flip;
mod linear;
mod metrics;
mod ridges;
mod shadows;
mod ssim;

pub use colour::{AnyComparison, compare_any, difference_any, triptych_any};
pub use difference::{difference_picture, triptych};
pub use edges::{EDGE_PLANES, EdgeLimits, EdgeMask, edge_mask};
pub use flip::{PIXELS_PER_DEGREE, flip};
pub use linear::{LinearComparison, compare_linear, linear_intensity, linear_luminance};
pub use metrics::{Beyond, CompareError, Comparison, compare};
pub use ridges::{RidgeError, horizon_of_picture, horizon_of_range, ridge_error, ridge_mask};
pub use shadows::shadow_agreement;
pub use ssim::ssim;
