//! Missions, paths, poses: as written and as meant.
//!
//! A scenario file is read by `written` (every fault of the file is listed) into what it means: [`Scenario`], SI
//! inside, complete. [`PoseTable`] puts the vehicle on the ground for every frame.

mod laws;
mod range;
mod pose;
mod raster;

pub use laws::{Curvature, LawWishes, Laws, Occlusion, PixelRule, Projection};
pub use pose::Pose;
pub use range::{RangeLaw, RangeProgramme};
pub use raster::{Display, FieldOfView, RasterWishes, Scalar};
