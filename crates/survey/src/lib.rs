//! Elevation files into coefficient banks.
//!
//! [`read()`] takes a GeoTIFF, a PDS3 image or a `.npy` array and gives an [`Elevation`]; [`survey()`] cuts an
//! [`Area`] out of it and fits the Lagrange 2-2 lattice to the samples by least squares, all words at once.
//! Axes of the bank: x north, y east, origin at the south-west corner of the area.
//!
//! - [`Projection`]: closed forms of the map projections that lunar files use.
//! - [`SurveyReport`]: what the fit leaves, how well it is determined, and how it behaves in voids.

mod area;
mod elevation;
mod error;
mod fill;
mod fit;
mod measure;
mod patch;
mod projection;
mod read;
mod report;
mod survey;

pub use area::{Area, Plane};
pub use elevation::{Affine, Elevation, Frame};
pub use error::SurveyError;
pub use fit::Stiffness;
pub use projection::{Method, Projection};
pub use read::{ReadOptions, read};
pub use report::{LevelReport, SurveyReport, VoidBounds, Worst};
pub use survey::{Grid, Step, Survey, SurveyOptions, survey};
