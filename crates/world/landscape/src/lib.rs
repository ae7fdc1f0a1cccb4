//! Lunoid, coefficient banks, light, axes; height, slope and albedo at any point.
//!
//! Everything that draws, shadows or drives asks this crate for the ground, so that all of them mean the same
//! ground. Axes: x north, y east, h up, metres; the origin is a corner of the problem area (section 4).
//!
//! **Layers.** A [`Landscape`] has two: the bank, which is the elevation, and a map of albedo over it. Elevation grids of
//! surveys and seeded reliefs become banks (`survey`, [`relief`]), so that all generators have one surface with slopes in closed
//! form. Nothing draws a grid itself: a grid as a third layer waits for a generator that does.
//!
//! - [`basis`]: the quintic Hermite functions of the Lagrange 2-2 polynomial (report III.A.1).
//! - [`bernstein`], [`patch`]: terrain along a straight line as a polynomial with bounds.
//! - [`Level`], [`Bank`]: nine words a corner; [`bank_file`] is their container.
//! - [`projection`], [`MapFrame`]: map projections, and how a bank lies in the map of its elevation file.
//! - [`Landscape`]: bank, albedo and lunoid together; the one query for height, slope and albedo.
//! - [`AlbedoMap`]: albedo from place to place, over the one number of the landscape.
//! - [`Sun`], [`Photometry`]: direction of light, laws of reflection; [`SweepLight`], [`GroupLight`]: along sweeps.
//! - [`Texture`]: small detail of the foreground; [`CraterGrain`]: what craters do to it.
//! - [`Silhouette`]: mountains beyond the stored area.
//! - [`Attitude`], [`axes`]: rotations between vehicle and terrain axes.
//! - [`relief`]: seeded landscapes with a realistic height spectrum.

mod albedo;
pub mod axes;
mod bank;
pub mod bank_file;
pub mod basis;
pub mod bernstein;
mod crater_grain;
mod light;
mod lunoid;
mod map_frame;
pub mod patch;
mod places;
mod posts;
pub mod projection;
mod query;
pub mod relief;
mod silhouette;
mod texture;

pub use albedo::{AlbedoMap, AlbedoMapError, Texels};
pub use axes::Attitude;
pub use bank::{Bank, BankError, CornerWords, Georeference, Level, WORDS};
pub use crater_grain::{CraterGrain, MOST_GAIN};
pub use light::{GroupLight, Sun, SweepLight, shade};
pub use lunoid::{LUNOID_RADIUS, is_same_body, parabolic_drop, spherical_drop};
pub use map_frame::{FileCoordinates, MapFrame, SPACING_RULE};
pub use photometry::Photometry;
pub use posts::Posts;
pub use query::Landscape;
pub use silhouette::{Silhouette, SilhouetteError};
pub use texture::{Hashed, Lattice, Layer, MOST_LAYERS, Source, Stored, Texture, TextureError};
