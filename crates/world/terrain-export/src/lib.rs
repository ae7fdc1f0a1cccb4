//! A built landscape for every generator.
//!
//! ```text
//!  Ground --> Exported: Database (tiles, light, boulders, text of the landscape)   terrain.lod
//!                       Survey (bank without the listed craters, residuals)        ground.bank, residuals.npy
//!                       craters of type 2                                          craters.csv
//!                       boulders as closed polyhedra                               boulders/N.obj
//!                       light on every post                                        light.npy
//!  Textures               albedo as a picture                                        albedo.png
//!                       a scenario over bank, craters and boulders                 scenario.toml
//!                       errors of all conversions                                  export.json
//! ```
//!
//! # Law
//!
//! - **One landscape.** All files come from one [`Ground`](terrain_builder::Ground). Bank, craters, boulders and scenario count from
//!   the south-west corner of the posts: x north, y east (m). The database has x east and y north about the centre of the area; its
//!   header says where that corner stands.
//! - **No loss without a number.** The database keeps heights to half of its step. Each crater has the largest difference to its crater
//!   of type 2, each region the largest residual of the fit. A crater that the feature generator cannot draw stays in the bank, and is
//!   named with the reason.
//! - **Whole folders.** The files are written into a folder of another name, which then takes the place of the old one
//!   ([`write_folder`]). A process that is killed leaves the old folder or the new one.
//! - Threads change no byte.
//!
//! # See also
//!
//! `docs/terrain.md` has the commands and their pictures.

mod albedo;
mod bodies;
mod database;
mod error;
mod exported;
mod folder;
mod light;
mod scenario;
mod shaded;
mod start;
mod told;

pub use database::database;
pub use error::ExportError;
pub use exported::{Exported, Wishes};
pub use folder::{FILES, expect_folder, write_folder};
pub use light::light_map;
pub use shaded::shaded;
