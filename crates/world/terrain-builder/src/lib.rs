//! A landscape as a text file of features over a base: never as edited heights.
//!
//! ```text
//!  ground.toml --> Description (features in the order of their names)
//!       ^                 |                        elevation file --> survey --> Base
//!       |                 v                                                       |
//!  add, remove      Ground: base + craters + growth + roughness  <----------------/
//!  (journal: undo)        |--> Heights (posts, slopes) --> LightMap (rays, or a sweep)
//!                         |--> boulders on the ground --> bodies of the polyhedron generator
//!                         \--> craters --> nearest craters of type 2
//!                  Textures: pictures --> albedo at a place
//! ```
//!
//! # Laws
//!
//! - **Any order, the same bits.** Heights are `base + sum of the enabled features`. Features are added up in the order of their
//!   names, items of a distribution in the order of their numbers. The order of the file, and what was added and removed before,
//!   change no bit; nor does the number of threads.
//! - **Item 17 stays item 17.** Every random number is a hash of seed, item and use, so a distribution may grow without moving the
//!   items that it has.
//! - **Undo** lives in a journal beside the file ([`Journal`]), not in the file: the file says what the landscape is, the journal how
//!   it came about. Undoing restores the text to the byte.
//! - **Textures** lie over the ground and change no height: the texture of a tile before that of the whole ground, bilinear between texels
//!   ([`Textures`]). Their pictures are read when somebody asks for the albedo.
//! - **As reported.** The builder follows a thesis on synthetic terrain for tests of navigation. Where the builder does otherwise, a
//!   [`Switch`] takes the document's way, and [`effects()`] says what that changes in metres.
//!
//! Axes: x north, y east, h up, metres, about the centre of the range of longitude and latitude ([`Frame`]). Heights are above the mean
//! radius; curvature is left to whoever draws.
//!
//! ```
//! use terrain_builder::{Base, Description, Ground};
//! let text = r#"
//! format = 1
//! [area]
//! longitude_deg = [3.0, 3.1]
//! latitude_deg = [26.0, 26.1]
//! resolution_m = 50.0
//!
//! [[feature]]
//! id = "crater"
//! kind = "crater"
//! longitude_deg = 3.05
//! latitude_deg = 26.05
//! radius_m = 500.0
//! wall_percent = 4.0
//! depth_percent = 20.0
//! "#;
//! let description = Description::parse("ground.toml", text, std::path::Path::new(""))?;
//! let ground = Ground::new(description, Base::Level(0.0))?;
//! assert!((ground.height([0.0, 0.0]) + 100.0).abs() < 1e-9);
//! assert!((ground.height([500.0, 0.0]) - 20.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod base;
mod boulder;
mod crater;
mod description;
mod distribution;
mod draw;
mod edit;
mod effects;
mod export;
mod frame;
mod grid;
mod ground;
mod growth;
mod height_grid;
mod heights;
mod journal;
mod landscape_file;
mod lay;
mod light_map;
mod places;
mod reading;
mod refused;
mod relief;
mod roughness;
mod size_law;
mod sunlight;
mod switches;
mod texture;
mod told;

pub use base::{Base, BaseError, ElevationBase};
pub use boulder::{Boulder, Shape};
pub use crater::{Crater, CraterForm, Decay, Nearest, NoNearest};
pub use description::{BaseWish, BoulderLook, Description, Feature, Kind};
pub use distribution::{Distribution, Item};
pub use edit::{EditError, add, import, remove};
pub use effects::{Effect, effects};
pub use export::Export;
pub use frame::{Frame, FrameWarning, MOON_RADIUS};
pub use grid::{Axis, Grid};
pub use ground::{Ground, GroundError, PlacedBoulder};
pub use growth::{ControlPoint, Growth, GrowthReported, Pick, runs};
pub use height_grid::{Area, HeightGrid, Posts, bilinear};
pub use heights::Heights;
pub use journal::{Edit, Journal, JournalError};
pub use landscape_file::{LandscapeFile, LandscapeFileError};
pub use light_map::{Apart, LightMap, Method};
pub use reading::FORMAT;
pub use refused::Refused;
pub use relief::Relief;
pub use roughness::Roughness;
pub use size_law::{CHI_SQUARED_END, SizeLaw};
pub use sunlight::Light;
pub use switches::{Reported, Switch};
pub use texture::{TextureError, TextureWish, Textures};
pub use told::{FeatureTold, Warning};
