//! Missions, paths, poses: as written and as meant.
//!
//! A scenario file is read (`written`; every fault of the file is listed) into what it means: [`Scenario`], SI
//! inside, complete. [`PoseTable`] puts the vehicle on the ground for every frame.
//!
//! - [`Scenario::read`], [`Scenario::parse`]: the file, described in `docs/scenario-format.md`.
//! - [`Path`]: waypoints joined by smooth curves in time. [`Vehicle`]: how it stands on the ground.
//! - [`PoseTable`]: eye and attitude of each frame, with [`LimitReport`]s of what the vehicle cannot do.
//! - [`Driven`]: a drive that grows pose by pose, as a closed loop drives it.
//! - [`Scenery`]: light, bodies and tracks over time: [`Object`]s and their [`Event`]s, [`Rocks`], [`Tracks`], a sun
//!   that may [`Drift`] or have a date ([`Sunlight`]).
//! - [`EffectWishes`]: lamps, stars, sheets, overlays and discs of the sky as a scenario asks for them; [`Effects`]: the same
//!   at one time.
//! - [`Channel`]: one of several views from the vehicle.
//! - [`words`]: keys that scenarios and hardware models share.

mod channel;
mod course;
mod craters;
mod curve;
mod drift;
mod driven;
mod effect_placing;
mod effect_wishes;
mod effects;
mod face_lists;
mod face_wishes;
mod guests;
mod laws;
mod lights;
mod limits;
mod looks;
mod meant;
mod objects;
mod path;
mod placing;
mod polygon;
mod pose;
mod pose_problem;
mod pose_table;
mod range;
mod raster;
mod ride;
mod rocks;
mod scenery;
mod scenery_problem;
mod sheets;
mod sky_discs;
mod stars;
mod sunlight;
mod tracks;
mod turns;
mod vehicle;
mod vehicle_shape;
mod view;
pub mod words;
mod written;
mod yoke;

pub use channel::Channel;
pub use course::Course;
pub use craters::{CraterList, CraterPopulation, CraterWishes};
pub use drift::Drift;
pub use driven::{Driven, DrivenError};
pub use effect_wishes::{
    EarthSeen, EarthWish, EffectWishes, LightPlace, LightWish, OverlayWish, Presence, SheetPlace, SheetWish,
    Spot,
};
pub use effects::{Carried, Effects};
pub use face_lists::{
    Carrier, DrawnBy, FaceKind, FaceList, FaceLists, ListAxes, OpenSea, OtherSide, ShipCourse,
};
pub use face_wishes::{
    EffectFileWish, FacePlace, FaceWishes, PlumeWish, SeaWish, ShipWish, SternWakeWish, WaveWish,
};
pub use guests::{Frame, Group, GroupSun, Guest, MoveStation, Moves};
pub use laws::{
    BodyShading, BodyVisibility, Curvature, FeatureLight, LawWishes, Laws, Occlusion, PixelRule, Projection,
    ShadowedBodies, TextureInShadow,
};
pub use lights::{Flash, LightPoint, LightSource, Lobe};
pub use limits::{Limit, LimitReport};
pub use looks::{AlbedoMapWish, MapCurve, PhotographWish, RollDisplay, ShadowFineness, TextureWish};
pub use meant::{GroundSource, Length, Scenario};
pub use objects::{Action, Event, Object, Stance};
pub use path::{HeightOver, Path, PathError, Station, Waypoint};
pub use polygon::PolygonFault;
pub use pose::Pose;
pub use pose_problem::{PathProblem, PathProblems, PoseFault};
pub use pose_table::{PoseRow, PoseTable, poses_csv};
pub use range::{LevelSwitch, RangeLaw, RangeProgramme};
pub use raster::{Display, FieldOfView, FieldWish, RasterWishes, Scalar};
pub use rocks::{RockArea, Rocks};
pub use scenery::{Scenery, Standing, TrackPatch};
pub use scenery_problem::{SceneryProblem, SceneryProblems};
pub use sheets::{Medium, Overlay, Sheet};
pub use sky_discs::{DiscFace, SkyDisc};
pub use stars::{SeededSky, Star, StarSource, StarWish};
pub use sunlight::{DatedSky, SubSolarPoint, SunDate, Sunlight};
pub use tracks::Tracks;
pub use vehicle::{Stand, Vehicle};
pub use vehicle_shape::VehicleShape;
pub use view::View;
pub use written::{FORMAT, Overrides, other_unit};
pub use yoke::Yoke;
