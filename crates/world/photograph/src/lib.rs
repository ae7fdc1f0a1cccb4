//! A photograph of the ground: what it shows at a ground point.
//!
//! ```text
//!  picture file --> codes ----------------------+
//!                                               v
//!  camera file --> Placement: camera or map --> Photograph --> level, light at a ground point
//!             \--> sun, grey curve -------------^    |
//!                                                    +--> footprint, ground sample
//!                                                    +--> coverage: how many points it shows
//! ```
//!
//! # Law
//!
//! - **Pixels.** I counts columns to the right, J counts lines downward, from the upper left corner of the picture. The centre
//!   of the first pixel is (0.5, 0.5). A place is inside where `0 <= I < columns` and `0 <= J < lines`.
//! - **Look-up.** Bilinear between the four nearest centres. Within half a pixel of the edge the outermost centres hold.
//! - **Level** is the code over the largest code, 0 to 1. **Light** is `white * level^gamma` by the photograph's grey curve.
//!   Light is looked up bilinearly in light, not in codes. A photograph without a grey curve has light equal to its level.
//! - **Camera.** A ground point has a pixel where it lies in front of the camera. Ground that hides other ground is not known here.
//! - **Map.** A georeferenced picture has no perspective: an affine leads from pixels to east and north. The height has no effect.
//! - **Colour** becomes grey by its luminance, as the crate `photographs` does it.
//!
//! # See also
//!
//! `tests/photograph`: closed forms, a second look-up, files that are refused.

mod coverage;
mod error;
mod file;
mod map;
mod photograph;
mod placement;
mod sampling;

pub use coverage::Coverage;
pub use error::PhotoError;
pub use file::{PhotoFile, read_photo_file};
pub use map::{Map, MapUnit};
pub use photograph::Photograph;
pub use placement::Placement;
