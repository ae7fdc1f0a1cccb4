//! Exact rasteriser of triangles for every generator that draws by sampling points (EP-0611021).
//!
//! ```text
//!  triangles in camera axes --> clip, fan --> snap to 1/256 pixel --> Triangle (edge functions, integers)
//!         |                                                                |
//!         v                                                                v
//!  DistancePlane (1/w, linear on the screen)      Screen (sub-areas) --> Lists --> Coverage (bits a pixel) --> Filter
//! ```
//!
//! # Law
//!
//! - **Positions** of corners are multiples of 1/256 pixel, those of sampling points multiples of 1/64. Edge functions of
//!   them are integers, so no coverage is ever rounded.
//! - **Top-left rule**: a sampling point on an edge that two triangles share belongs to exactly one of them.
//! - **Triangles, no polygons.** What the clipping leaves is fanned. A corner that is snapped may turn a flat angle of a
//!   polygon into a reflex one, and the half-planes of such a polygon lose more than the snapping moved. A triangle stays
//!   convex wherever its corners go.
//! - **Lists** are conservative: no triangle covers a sampling point of a sub-area that does not list it.
//!
//! Axes: x right, y down, in pixels from the top left corner of the screen. Camera axes: x right, y down, z along the view
//! axis, in metres.
//!
//! # Threads
//!
//! Nothing here starts threads or locks. Sub-areas are independent: each thread has a [`Coverage`] of its own.
//!
//! # See also
//!
//! `tests/raster`: a second evaluator that shares no code, partition of meshes, conservative lists, convergence to the
//! exact area. `examples/coverage_cost.rs` measures what a sub-area costs.

mod area;
mod attribute;
mod clip;
mod coverage;
mod filter;
mod fixed;
mod keep;
mod lists;
mod pattern;
mod plane;
mod projection;
mod sampling;
mod screen;
mod triangle;

pub use area::area_within;
pub use attribute::Attribute;
pub use clip::{ClipError, Clipper, Fan, Seen};
pub use coverage::Coverage;
pub use filter::{Filter, Weights};
pub use fixed::{OffRaster, Point};
pub use lists::Lists;
pub use pattern::Pattern;
pub use plane::DistancePlane;
pub use projection::Projection;
pub use sampling::Sampling;
pub use screen::{LARGEST_RASTER, LARGEST_SIDE, Screen, ScreenError, SubArea};
pub use triangle::{Triangle, doubled_area};
