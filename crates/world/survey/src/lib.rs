//! Elevation files into coefficient banks.
//!
//! [`read()`] takes a GeoTIFF, a PDS3 image, a PDS4 array, an ISIS cube, an ENVI raster, an Arc ASCII grid, a DTED cell, an
//! SRTM tile or a `.npy` array and gives an [`Elevation`]; [`open()`] reads its header alone, and then a [`Window`] of it;
//! [`survey()`] cuts an [`Area`] out of it and fits the Lagrange 2-2 lattice to the samples by least squares, all words at
//! once. [`VOCABULARIES`] has every name that the readers know, and what becomes of each.
//! Axes of the bank: x north, y east, origin at the south-west corner of the area.
//!
//! - [`Projection`]: closed forms of the map projections that lunar files use.
//! - [`write_geotiff`]: a raster with the place of its samples.
//! - [`SurveyReport`]: what the fit leaves, how well it is determined, and how it behaves in voids.
//!
//! Voids are never averaged. They are filled harmonically first and the fit follows the filled heights with a small
//! weight: that bounds the ground in a void by the heights around it, and the condition of the fit by the inverse of
//! the weight.
//!
//! ```
//! use survey::{Affine, Elevation, Frame, SurveyOptions, survey};
//!
//! let heights = (0..60 * 60).map(|sample| 0.1 * (sample / 60) as f64).collect();
//! let place = Affine { first: [0.0; 2], step: [2.0; 2] };
//! let elevation = Elevation::new(60, 60, heights, place, Frame::Plane(None));
//! let found = survey(&elevation, &SurveyOptions::new(10.0), &mut |_| {})?;
//! assert_eq!(found.bank.finest().corners(), [13, 13]);
//! assert!(found.report.levels[0].rms < 1e-9);
//! # Ok::<(), survey::SurveyError>(())
//! ```

mod area;
mod elevation;
mod error;
mod fill;
mod fit;
mod measure;
mod patch;
mod read;
mod report;
mod survey;
mod told;
mod window;
mod write;

pub use area::{Area, Plane};
pub use elevation::{Affine, Elevation, Frame};
pub use error::SurveyError;
pub use fit::Stiffness;
pub use landscape::projection::{Method, Projection};
pub use read::{Fate, Opened, ReadOptions, VOCABULARIES, Vocabulary, Window, Word, open, read, words_page};
pub use report::{SurveyReport, Worst};
pub use survey::{Grid, Step, Survey, SurveyOptions, survey};
pub use told::SurveyTold;
pub use write::{PlacedRaster, RasterSamples, write_geotiff};
