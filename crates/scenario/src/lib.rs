//! Missions, paths, poses: as written and as meant.
//!
//! A scenario file is read (`written`; every fault of the file is listed) into what it means: [`Scenario`], SI
//! inside, complete. [`PoseTable`] puts the vehicle on the ground for every frame.
//!
//! - [`Scenario::read`], [`Scenario::parse`]: the file, described in `docs/scenario-format.md`.
//! - [`Path`]: waypoints joined by smooth curves in time. [`Vehicle`]: how it stands on the ground.
//! - [`PoseTable`]: eye and attitude of each frame, with [`LimitReport`]s of what the vehicle cannot do.
//! - [`words`]: keys that scenarios and hardware models share.

mod curve;
mod laws;
mod limits;
mod meant;
mod path;
mod pose;
mod pose_problem;
mod pose_table;
mod range;
mod raster;
mod scenery;
mod vehicle;
pub mod words;
mod written;

pub use laws::{
    BodyVisibility, Curvature, FeatureLight, LawWishes, Laws, Occlusion, PixelRule, Projection,
    ShadowedBodies, TextureInShadow,
};
pub use limits::{Limit, LimitReport};
pub use meant::{Ground, Length, Scenario};
pub use path::{Path, PathError, Station, Waypoint};
pub use pose::Pose;
pub use pose_problem::{PathProblem, PathProblems, PoseFault};
pub use pose_table::{PoseRow, PoseTable, poses_csv};
pub use range::{RangeLaw, RangeProgramme};
pub use raster::{Display, FieldOfView, RasterWishes, Scalar};
pub use scenery::{Scenery, Standing, TrackPatch};
pub use vehicle::{Stand, Vehicle};
pub use written::FORMAT;
