//! Tiles of a terrain with levels of detail (a thesis on synthetic terrain for tests of navigation, for Draper Laboratory).
//!
//! ```text
//!  heights, tile order ─▶ Terrain ──────────────┐
//!  ranges, morph shares ─▶ Levels ─▶ State ◀── eye: a level and a fraction for every tile, neighbours one level apart
//!                                      │         │
//!                     Edges, Stitch ─▶ Surface ──┴─▶ heights of vertices, triangles of blocks, height under a place
//! ```
//!
//! # Law
//!
//! - **Tiles** have `2^n + 1` posts a side and share those of their borders. Level 0 is the finest; level l has every `2^l`-th post.
//! - **Cells** are cut from top left to bottom right, at every level.
//! - **Morphing.** A vertex that the next level lacks moves towards the mean of the two vertices between which it lies there: left and right,
//!   bottom and top, or top left and bottom right. At fraction 1 the level is the next one, triangle for triangle.
//! - **Levels** follow from the distance of the eye from the middle post of a tile, at its finest height. A tile that is more than one level coarser
//!   than a neighbour is refined, until none is; it then looks like the coarser level ([`State`]).
//! - **Edges.** Vertices on an edge between two tiles have a fraction of the edge ([`Edges::Shared`]), so both sides draw the same line. The document
//!   has one fraction a tile ([`Edges::PerTile`]), and cracks.
//! - **Stitching.** On an edge the finer tile leaves out the vertices that its neighbour lacks ([`Stitch::FineSide`]), or the coarser one has them too
//!   ([`Stitch::CoarseSide`]). With the second no ground moves when a level changes.
//!
//! Axes: x to the right, y up on the map, z up (m).
//!
//! # See also
//!
//! `tests/lod_tiles`: the flight of the document's chapter 6 over ground in closed form, edges without gaps over random states, ends of morphing.

mod edges;
mod error;
mod inserted;
mod levels;
mod pieces;
mod state;
mod surface;
mod terrain;

pub use edges::{Edges, Side};
pub use error::TileError;
pub use levels::{Level, Levels};
pub use pieces::{TilePieces, Version};
pub use state::{State, TileState};
pub use surface::{Origin, Stitch, Surface, TileMesh};
pub use terrain::{Terrain, Tile};
