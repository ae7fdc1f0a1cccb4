//! A terrain in one file: tiles of heights, light, boulders, the errors of levels, and the text that it was built from.
//!
//! ```text
//!  Contents (posts, heights, light, boulders, text) --> Database: errors and bounds of every tile
//!                                                           |  ^
//!                                                    write  v  |  open: every hash is checked
//!  file: | magic, version | header | table of blocks | hash | places | tiles | heights ... | light ... | boulders | text |
//! ```
//!
//! # Law
//!
//! - **Axes.** x east, y north, z up (m), about the latitude and longitude of [`Frame`]. Posts stand row by row from the south, each
//!   row from the west. Heights are above the sphere; curvature is left to the reader.
//! - **Tiles** have `2^n + 1` posts a side and share those of their borders. A post is stored once: the block of a tile has its own
//!   posts without those of the tiles east and north of it. Tiles are numbered row by row from the south-west.
//! - **Levels.** Level l has every `2^l`-th post. It is a decimation of level 0, so only level 0 is stored. The file has the largest
//!   difference of each level to level 0 ([`Tile::errors`]).
//! - **Heights** are exact: every bit of an `f64`, or whole steps of [`Contents::step`]. Rows are differences of first or second order
//!   in both directions, in the code of Rice, whose parameter each row has.
//! - **Hashes.** The header and each block have a BLAKE3 hash. A damaged block is named by its kind and tile.
//! - **The same bytes.** A file that is opened and written again has the same bytes, with any number of threads.
//!
//! ```
//! use terrain_database::{Contents, Database, Frame};
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("terrain.lod");
//! let places = || (0..5).map(|post| 100.0 * f64::from(post)).collect();
//! let frame = Frame { radius: 1_737_400.0, latitude: 0.4, longitude: 0.1, origin: [0.0; 2] };
//! let contents = Contents::new(frame, 1, [places(), places()], (0..25).map(f64::from).collect());
//! let database = Database::new(contents)?;
//! database.write(&path)?;
//! assert_eq!(Database::open(&path)?, database);
//! assert_eq!(database.tile(3).bounds, [12.0, 24.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # See also
//!
//! `lod-tiles` draws levels of such tiles; `terrain-builder` makes the ground. `docs/terrain.md` has the commands.

mod blocks;
mod boulders;
mod bytes;
mod check;
mod contents;
mod database;
mod error;
mod header;
mod heights;
mod layout;
mod levels;
mod read;
mod reading;
mod rice;
mod rows;
mod tiling;
mod write;

pub use blocks::Block;
pub use contents::{Boulder, Contents, Frame, Map, Range, Shape};
pub use database::{Database, Tile};
pub use error::{DatabaseError, Unfit};
pub use header::VERSION;
pub use layout::documented_bytes;
