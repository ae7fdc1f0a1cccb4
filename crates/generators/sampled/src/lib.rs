//! The sampled image generator of 1988 (EP-0611021): every feature is a polygon or a disc that is sampled at points of each pixel.
//!
//! ```text
//!  ground, bodies --> triangles --> clip --> Faces ----------> lists by sub-area --+
//!  sheets, overlays ---^                                                           v
//!  lamps, stars -----> discs ------> lists by sub-area --------------------> Sampler: stacks --> colours --> planes
//!  Earth, sun -------> discs of the sky -----------------------------------------^  |
//!                                                     calligraphic points: shares --+--> beam --> spots --> planes
//! ```
//!
//! # Law
//!
//! - **Ground** is a mesh about the eye, with its colours at the corners (`ground-mesh`), of all levels of the bank. Between
//!   corners colours are linear over the triangle. Light is the scene's law of reflection without remote shadow.
//! - **Bodies** are the triangles of their faces, lit at their corners.
//! - **Coverage, distance**: `raster`. **Stacks, colour, losses**: `translucency`. **Light points, beam**: `light-points`.
//! - **Colour in a pixel**: a surface has the colour of its pixel's middle at all sampling points of the pixel. Dust has the
//!   translucency of the path through the middle. A disc of the sky has the mean of the points that it covers.
//! - **Planes.** `range` and `distance` are of the nearest opaque surface over all sampling points of a pixel, along the ray of its
//!   middle. `label` is of that surface, or of a light, sheet or overlay that weighs more than a half before it.
//! - Perspective is the true one under every law of projection; roll is the yoke's.
//!
//! # Run parameters
//!
//! | key | range | default | what it is |
//! |---|---|---|---|
//! | `sampled.pattern` | `1`, `4`, `8`, `16`, `grid16`, `lattice32`, `off-centre16` | `4` | sampling points of a pixel; the last is a fault |
//! | `sampled.rotate` | true, false | false | the pattern is turned from pixel to pixel |
//! | `sampled.filter` | `box`, `tent`, `gaussian` | `box` | how sampling points make a pixel |
//! | `sampled.translucent` | -1 to 1000 | 4 | translucent surfaces that a sampling point keeps; -1 is without limit |
//! | `sampled.lights` | -1 to 1000 | 1 | light points that it keeps; -1 is without limit |
//! | `sampled.shared_stack` | true, false | false | both share one stack |
//! | `sampled.least_diameter_px` | above what the pattern can miss, to 100 | 1.5 | least diameter of a light point |
//! | `sampled.normalise` | true, false | true | a light point's light is divided by what its disc covers |
//! | `sampled.blending` | `hiding`, `additive` | `hiding` | how a light point meets what is behind it |
//! | `sampled.veil` | `points`, `stack-only` | `points` | whether calligraphic points dim those behind them |
//! | `sampled.spot_px` | 0.05 to 100 | 0.6 | deviation of the beam's spot |
//! | `sampled.overload` | `drop-smallest`, `drop-farthest` | `drop-smallest` | what a full list leaves out |
//! | `sampled.ground_half_side_m` | 0.1 to 100000 | 32 | half the side of the innermost square of ground |
//! | `sampled.ground_cells` | 8 to 16384, a multiple of 4 | 128 | cells along half the side of every square of ground |
//!
//! # Timing
//!
//! The gear (`hardware-models/programs/sampled.toml`) has ticks, memories and the beam. A frame's units are geometry, lists, sampler, stack,
//! pixels, light points and beam. Pictures depend on its memories and beam alone. Sub-areas are drawn by the threads of the current
//! rayon pool, and put together in their order: the bits do not depend on the number of threads.
//!
//! # Not modelled
//!
//! Remote shadow, texture, far silhouettes and vehicle tracks are listed as omissions.

mod camera;
mod faces;
mod hardware;
mod inputs;
mod lights;
mod overload;
mod parameters;
mod picture;
mod reading;
mod row;
mod rows;
mod scene;
#[cfg(test)]
mod scenes;
mod session;
mod store;
mod tile;
mod timed;
mod wedge;
mod work;

pub use hardware::{Hardware, Memory};
pub use overload::Overload;
pub use parameters::Parameters;
pub use row::ROW;
pub use session::Sampled;
pub use timed::Clocked;
