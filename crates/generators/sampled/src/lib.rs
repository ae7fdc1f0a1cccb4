//! The sampled image generator of 1988 (EP-0611021): every feature is a polygon or a disc, sampled at points of each pixel.
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
//!   corners colours are linear over the triangle. Light is the scene's law of reflection without remote shadow. Craters smaller
//!   than a cell are left out. Rings are chosen once for a mission, from the view of frame 0: they have 8, 16, ... cells until the
//!   error is within `ground_error_px`.
//! - **Bodies** are the triangles of their faces, lit at their corners.
//! - **Coverage, distance**: `raster`. **Stacks, colour, losses**: `translucency`. **Light points, beam**: `light-points`.
//! - **Colour in a pixel**: a surface has the colour of its pixel's middle at all sampling points of the pixel. Dust has the
//!   translucency of the path through the middle. A disc of the sky has the mean of the points that it covers.
//! - **Planes.** `range` and `distance` are of the nearest opaque surface over all sampling points of a pixel, along the ray of
//!   its middle. `label` is of that surface, or of a light, sheet or overlay that weighs more than a half before it.
//! - Perspective is the true one under every law of projection; roll is the yoke's.
//!
//! # Run parameters
//!
//! | key | range | default | what it is |
//! |---|---|---|---|
//! | `sampled.pattern` | `1`, `4`, `8`, `16`, `grid16`, `lattice32`, `off-centre16` | `4` | sampling points of a pixel |
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
//! | `sampled.beam_order` | `near-to-far`, `nearest-neighbour` | `near-to-far` | order in which the beam draws its points |
//! | `sampled.beam_layer` | `both`, `raster`, `beam` | `both` | layers that a picture shows |
//! | `sampled.ground_half_side_m` | 0.1 to 100000 | 32 | half the side of the innermost square of ground |
//! | `sampled.ground_cells` | 8 to 16384, a multiple of 4 | 128 | most cells along half the side of every square of ground |
//! | `sampled.ground_error_px` | 0 to 100 | 0.5 | error of the ground in frame 0 that is allowed, in pixels; 0 always takes most cells |
//! | `sampled.overload` | `drop-smallest`, `drop-farthest`, `late`, `extend` | `drop-smallest` | which triangles lose their places in a full list, and what is shown when time runs out |
//!
//! # Timing
//!
//! Geometry and lists of a frame are worked out in the frame before. The sampler then reads sub-area after sub-area, in raster
//! order. Pixels of one sub-area are written while the next is read. The beam draws calligraphic points in the field after the
//! frame.
//!
//! | unit | a piece of work is | ticks |
//! |---|---|---|
//! | `geometry` | a feature: a face, light point or disc of the sky | `feature_ticks` |
//! | `geometry` | a corner of what clipping left, seen from behind or not | `corner_ticks` |
//! | `lists` | a pair (feature, sub-area) that is found, with a place or without | 1 |
//! | `sampler` | a sub-area | its entries (triangles and raster points), at least `least_ticks` |
//! | `stack` | a feature that the deepest sampling point of a sub-area holds | `insert_ticks` - 1, added to the sampler's |
//! | `light-points` | a sub-area that the disc of a calligraphic point meets | 1, added to the sampler's |
//! | `pixels` | a pixel | 1 / `pixels_tick`, rounded up for a sub-area |
//! | `beam` | a point that is drawn | `jump_us` + `dwell_us` |
//!
//! A frame is full while sampler, stack and light points together take at most `sampler_hz` / update rate. A timing record has
//! these deadlines; slack is in ticks, or in places at a tick each.
//!
//! | deadline | what is due | cause of a miss |
//! |---|---|---|
//! | `frame-tasks` | geometry and lists, before the frame begins | `processor` |
//! | `list` | a place in a list, where those are limited | `occupied` |
//! | `light-store` | a place in the light point store, where that is limited | `occupied` |
//! | `sub-area` | a sub-area of row j of n is read out when (j + 1) / n of the frame has gone by | `queue` |
//! | `beam` | a point is drawn before the field after the frame ends | `queue` |
//! | `stack` | the features of a sub-area have slots at all its sampling points, where stacks are limited | `occupied` |
//! | `update` | the picture is complete when its field ends, under `extend` | `queue` |
//!
//! Events are the sub-areas as they are read out, each with its entries, then the points of the beam. Sub-areas are drawn by the threads of the current rayon pool, and put together in their
//! order: the bits do not depend on the number of threads.
//!
//! # Gear
//!
//! The keys stand in `hardware-models/programs/sampled.toml`. Memories and beam decide what a picture loses; the sampler
//! decides its timing alone, and under `late` and `extend` the picture too.
//!
//! | key | range | shipped | what it is |
//! |---|---|---|---|
//! | `sampler.sampler_hz` | 1000 to 10^12, whole | 40e6 | ticks in a second |
//! | `sampler.feature_ticks` | 0 to 1000000 | 1 | ticks of a feature |
//! | `sampler.corner_ticks` | 0 to 1000000 | 1 | ticks of a corner |
//! | `sampler.least_ticks` | 0 to 1000000 | 8 | least ticks of a sub-area |
//! | `sampler.insert_ticks` | 1 to 1000000 | 1 | ticks of an insertion, the entry's with it |
//! | `sampler.pixels_tick` | 1 to 1000000 | 8 | pixels that are written in a tick |
//! | `memory.list_entries` | 0 to 2^32 - 1 | 0 | entries of all lists; 0 is without limit |
//! | `memory.list_depth` | 0 to 2^32 - 1 | 0 | entries of the list of a sub-area; 0 is without limit |
//! | `memory.points` | 0 to 2^32 - 1 | 0 | light points of a frame; 0 is without limit |
//! | `beam.jump_us` | 0 to 1000000 | 4 | jump to a calligraphic point |
//! | `beam.dwell_us` | 0 to 1000000 | 6 | time for which it is drawn |
//!
//! # Overload
//!
//! A list that is too long keeps its worthiest triangles: the largest on the screen, or the nearest in the middle of the
//! sub-area. Of equals the smaller numbers stay. A list memory that is full drops entries of all sub-areas by the same order. A
//! full light point store keeps the brightest points. What is lost is counted: `lost_entries`, `lost_points`, `beam_dropped`.
//!
//! `late` and `extend` keep the largest triangles, and show earlier frames (`shown.rs`): a late sub-area shows the frame before
//! as if that were in time, black in frame 0; a frame that needs more than a field is shown when it is complete, and the last complete
//! picture until then. Both are functions of the mission and the number of the frame, whose course the stage must have. The plane
//! `overload` marks every loss.
//!
//! # Signals
//!
//! Rows of sub-areas stand for sweeps (`rows.rs`): place across the view, ground range, entries, ticks, deepest stack, largest
//! rest, light points.
//!
//! # Not modelled
//!
//! Remote shadow, texture, far silhouettes and vehicle tracks are listed as omissions. Insertions that a nearer feature undoes
//! take no time, and discs of the sky take no place in lists.

mod deadlines;
mod drawn;
mod faults;
mod ground;
mod hardware;
mod inputs;
mod ladders;
mod map;
mod overload;
mod parameters;
mod policy;
mod row;
mod rows;
mod sampled;
#[cfg(test)]
mod scenes;
mod session;
mod shown;
mod sizing;
mod store;
mod timed;
mod work;

pub use hardware::{Hardware, Memory};
pub use parameters::Parameters;
pub use policy::Overload;
pub use row::ROW;
pub use sampled::Sampled;
pub use scene_sampler::{BeamLayer, BeamOrder};
pub use timed::Clocked;
