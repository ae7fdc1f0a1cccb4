//! Tiles of ground at levels of detail that morph: the viewer of a thesis on synthetic terrain for tests of navigation (for Draper
//! Laboratory).
//!
//! ```text
//!  landscape --> posts --> tiles ---------+
//!  tolerance or ranges --> levels         v
//!  eye ---------------------> state: level and fraction of every tile --> tiles in view --> vertices, triangles --+
//!  sun, slopes of the posts (map) or of the vertices (live) ------------------------------------------------------+--> scene sampler
//! ```
//!
//! # Law
//!
//! - **Posts.** Those of a terrain database ([`landscape::Posts`]), or the ground of all levels of the bank at posts `spacing_m` apart, without craters smaller than that
//!   ([`landscape::Landscape::at_spacing`]). The last tile of a row or column has narrower cells, so that the ground ends where it should.
//! - **Tiles, levels, morphing, edges, stitching**: `lod-tiles`. Distances are those on the flat map.
//! - **Ranges** are given, or they follow from a tolerance: level l goes on to the distance at which the largest move of its vertices is
//!   `tolerance_px` pixels in the middle of the picture, at least to `2^l` tiles. Zones are longer than a tile.
//! - **Light** is looked up pixel by pixel from the slopes of the finest posts, so no level changes it; or it follows from the slopes of the
//!   vertices as they are drawn.
//! - **Everything else** of the picture, and its sampling: `scene-sampler`. Differences from pictures of `sampled` come from the mesh alone.
//! - **Boulders** are drawn by distance: none below a pixel, an octahedron up to twelve, all faces from there.
//! - The eye may stand beside the ground: nothing is drawn where there is none.
//!
//! # Run parameters
//!
//! | key | range | default | what it is |
//! |---|---|---|---|
//! | `lod.order` | 1 to 12 | 5 | n: a tile has `2^n` cells a side, and n + 1 levels |
//! | `lod.spacing_m` | 0.01 to 1000000 | longer side of the ground / 1024 | distance of posts |
//! | `lod.levels` | 1 to n + 1 | n + 1 | most levels; 1 draws the finest mesh alone |
//! | `lod.ranges_m` | rising, one for each level | from `tolerance_px` | ends of the ranges, the finest level first; the last range has no end |
//! | `lod.tolerance_px` | 0.01 to 10000 | 1 | error of a level that is allowed where its range begins |
//! | `lod.morph_percent` | 0 to 100, one or one for each level | 40 | share of a range, at its far end, over which its level morphs |
//! | `lod.transition` | `morph`, `switch` | `morph` | how a level becomes the next one |
//! | `lod.edges` | `shared`, `per-tile` | `shared` | who decides how far an edge has morphed; the document's `per-tile` cracks |
//! | `lod.stitch` | `coarse-side`, `fine-side`, `none` | `coarse-side` | which tile adapts where levels differ; with `fine-side` ground moves a little when a neighbour changes its level; `none` leaves holes |
//! | `lod.light` | `map`, `live`, `stored` | `map` | where the light of the ground comes from; `stored` is the light map of a terrain database |
//! | `lod.show` | `light`, `levels`, `wires` | `light` | what the ground shows: its light, levels and fractions as colours, or the edges of its triangles |
//! | `lod.light_level` | 0 to n | 0 | level whose posts have the slopes of the map |
//! | `lod.percent_bits` | 0 to 24 | 0 | bits of a fraction on its way to the board; 0 leaves it as it is |
//! | `lod.slots` | `unlimited`, `refuse`, `share` | `unlimited` | what becomes of more tiles than the board has slots for |
//! | `lod.clock` | `stepped`, `real-time` | `stepped` | what a frame that takes too long does to the next one |
//! | `lod.boulders` | `ground`, `mean-radius` | `ground` | where boulders stand |
//! | `lod.boulder_px` | 0 to 10000 | 1 | least diameter of a boulder that is drawn; 0 draws all with all faces |
//! | `lod.pattern` | `1`, `4`, `8`, `16`, `grid16`, `lattice32`, `off-centre16` | `4` | sampling points of a pixel |
//! | `lod.rotate` | true, false | false | the pattern is turned from pixel to pixel |
//! | `lod.filter` | `box`, `tent`, `gaussian` | `box` | how sampling points make a pixel |
//! | `lod.translucent` | -1 to 1000 | 4 | translucent surfaces that a sampling point keeps; -1 is without limit |
//! | `lod.lights` | -1 to 1000 | 1 | light points that it keeps; -1 is without limit |
//! | `lod.shared_stack` | true, false | false | both share one stack |
//! | `lod.least_diameter_px` | above what the pattern can miss, to 100 | 1.5 | least diameter of a light point |
//! | `lod.normalise` | true, false | true | a light point's light is divided by what its disc covers |
//! | `lod.blending` | `hiding`, `additive` | `hiding` | how a light point meets what is behind it |
//! | `lod.veil` | `points`, `stack-only` | `points` | whether calligraphic points dim those behind them |
//! | `lod.spot_px` | 0.05 to 100 | 0.6 | deviation of the beam's spot |
//! | `lod.beam_order` | `near-to-far`, `nearest-neighbour` | `near-to-far` | order in which the beam draws its points |
//! | `lod.beam_layer` | `both`, `raster`, `beam` | `both` | layers that a picture shows |
//!
//! # Timing
//!
//! A frame is work of the thesis's computer and of its graphics board (`time`): tiles, words of the uniform array, vertices, triangles, bytes that are
//! read back. `hardware-models/programs/lod-mesh.toml` has the figures. A record names each tile that takes another level.
//!
//! # Threads
//!
//! Posts, tiles and sub-areas are functions of their own, put together in their order: the bits do not depend on the number of threads.
//!
//! # Not modelled
//!
//! Remote shadow, texture, far silhouettes and vehicle tracks are listed as omissions.

mod boulders;
mod detailed;
mod faults;
mod frustum;
mod ground;
mod levels;
mod live;
mod lod_mesh;
mod loss;
mod name;
mod parameters;
mod place;
mod prepared;
mod row;
mod session;
mod signals;
mod slots;
mod sounding;
mod terrain;
mod time;
mod wires;

pub use lod_mesh::LodMesh;
pub use parameters::{Boulders, Clock, GroundLight, Parameters, Show, Slots, Transition};
pub use row::ROW;
pub use time::{Board, Capture, Hardware, Viewer};
