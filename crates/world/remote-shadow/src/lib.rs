//! Remote shadow before the mission: sun-parallel profiles, boundaries, tiles (report II.D, III.B; section 11.1).
//!
//! ```text
//!  landscape --> ceilings (once) --+--> highest caster beyond a tile --+
//!                                  |                                   +--> intervals of each --> boundaries --> tile
//!  sun --> axes p (across), q -----+--> 65 profiles of a tile ---------+    profile              of its strips
//!  eye, reach, sector --> cover: which tiles, how fine
//! ```
//!
//! # Law
//!
//! With `G(q) = h(q) + q tan e` along a line parallel to the sun's azimuth, q away from the sun, a point is in shadow
//! (local or remote) exactly if G was larger somewhere before. h is [`landscape::Landscape::at`]: terrain of the finest
//! level that has the place, and features. Ground outside the problem area casts nothing; light does not bend over
//! the lunoid: the map is flat. The sun is a point.
//!
//! # Method
//!
//! - **Ceilings.** Over squares of each level an upper bound of the height: the corners' heights plus what the
//!   bending (Bernstein form of the region's second derivatives) allows, plus the highest of each crater there;
//!   above them the pyramid of maxima.
//! - **Casters.** The largest G before a tile's sunward edge is that of all places of the lattice
//!   ([`Resolution::finest`]) on the profile, then of the top or kink beside the best. The search enters only squares
//!   and stretches that can hold more than is known, whatever their distance; what it leaves out changes no bit.
//!   Tiles of one spacing that lie one behind the other share the search: each looks only behind the edge of the one before.
//! - **Profiles.** A tile has 64 strips; G is taken at as many places along each profile. Starts (where G turns down, or
//!   the kink) and ends (where G is back) are halved down to 2^-12 of the spacing.
//! - **Boundaries.** Intervals of neighbouring profiles that overlap are one shadow; what overlaps nothing ends in a
//!   tip. Each tile is closed by its own edges, so that windings along any line start and end at 0.
//!
//! # Errors
//!
//! Along a profile: 2^-12 of the tile's spacing for what is wider than the spacing; a shadow narrower than that can be
//! missed. Across: one spacing, where a shadow begins, ends, splits or joins between two profiles; the tips are laid so
//! that the area has no bias. Areas are good to 0.5 % at an eighth of the smallest feature's radius.
//!
//! # Tiles
//!
//! The spacing is [`Resolution::finest`] times a power of two, at most [`Resolution::angle`] times the distance from the
//! eye. Places of all tiles lie on one lattice in the sun's axes, so a tile does not depend on the frame that asked for
//! it. Tiles are kept in memory for the last three suns, and on disk if there is a folder for them.
//!
//! # Not modelled
//!
//! Penumbra (half a degree of sun). Light reflected from lit ground. Mountains known by their silhouette only.
//!
//! ```
//! use std::sync::Arc;
//! use features::{Crater, Features, Shape};
//! use landscape::{Bank, Landscape, Level, Sun};
//! use remote_shadow::{Resolution, ShadowBank};
//!
//! let level = Level::new(250.0, [0.0, 0.0], [2, 2], vec![[0.0; 9]; 4])?;
//! let bowl = Crater::new([125.0, 125.0], Shape::Bowl { r1: 50.0 }, 12.0, 0.0)?;
//! let landscape = Landscape::new(Bank::new("a bowl", vec![level], None)?, 1.0)
//!     .with_features(Features::new(vec![bowl]));
//! let shadows = ShadowBank::new(Arc::new(landscape), Resolution { finest: 0.5, angle: 2e-3 });
//! let tiles = shadows.around(&Sun { azimuth: 0.0, elevation: 0.1 }, [20.0, 125.0], 200.0, None);
//! assert!(tiles.iter().any(|tile| !tile.outlines.is_empty()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axes;
mod bank;
mod body;
mod cache;
mod caster;
mod chains;
mod control_net;
mod cover;
mod footing;
mod ground;
mod lattice;
mod numbers;
mod outlines;
mod point;
mod profile;
mod segment;
mod shade;
mod sheet;
mod strip;
#[cfg(test)]
mod tests;
mod tile;

pub use bank::{Resolution, ShadowBank};
pub use cache::{has_tiles, is_tile_file};
pub use footing::{Footings, UnderSun};
pub use outlines::{Corners, Outlines};
pub use segment::Segment;
pub use shade::Shade;
pub use tile::Tile;
