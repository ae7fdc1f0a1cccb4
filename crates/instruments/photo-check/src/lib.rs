//! Whether a photograph and an elevation grid agree.
//!
//! ```text
//!  elevation file --> fill of voids --> Ground: posts in the photograph's axes --> Coverage
//!                                          |        \--> Relief: light of each post under the photograph's sun
//!                                          |                     |
//!  photograph -----------------------------+--> Overlay: both in map geometry --> page, correlation
//!                                          \--> line drawing, heights magnified
//!  control points -------------------------+--> residuals, best shift
//! ```
//!
//! # Law
//!
//! - **Axes.** A camera in the axes of a landscape takes grids in metres: east, north, height. A camera over a body takes grids in
//!   degrees or in a known map projection. A map in metres takes grids in metres, a map in degrees takes grids in degrees.
//! - **Voids** are filled as asked; the mask of what was void stays with every post and marks every picture.
//! - **Relief.** `max(n . s, 0)` from central differences of the heights, albedo 1, and 0 where ground of the grid stands before the
//!   sun. The way to the sun is looked at once a post.
//! - **Overlay.** Both pictures are north up, over the whole grid. The photograph is looked up bilinearly in light at the ground
//!   point of each pixel. Ground that other ground of the grid hides from the camera shows nothing: lines of sight are looked at
//!   where they cross lines of posts.
//! - **Likeness** is Pearson's correlation of the photograph's light and the relief, over the pixels that have both. The offset is
//!   the whole number of overlay pixels, up to [`REACH`] each way, by which features of the photograph lie beside those of the relief
//!   where the correlation is largest.
//! - **Line drawing.** Rows and columns of the grid in the photograph's pixels. Heights above and below the mean are magnified.
//!
//! # See also
//!
//! `tests/photo_check`: closed forms, bad input. `docs/photo.md`: the command.

mod alike;
mod error;
mod filling;
mod ground;
mod lines;
mod overlay;
mod page;
mod points;
mod relief;
mod report;
mod rule;
mod sun;
mod visible;

pub use alike::{Likeness, REACH};
pub use error::GroundError;
pub use filling::fill_voids;
pub use ground::Ground;
pub use lines::drawing;
pub use overlay::Overlay;
pub use page::page;
pub use points::{Control, read_points};
pub use relief::Relief;
pub use report::Report;
pub use sun::{FoundSun, SunError, find_sun};
