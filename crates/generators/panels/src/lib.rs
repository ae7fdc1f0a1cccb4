//! Photographs over panels of ground, seen from anywhere: the program of a thesis of the Naval Postgraduate School, with all that its
//! author wished for.
//!
//! ```text
//!  landscape --> posts --> panels: two triangles a cell -------------------+
//!  photographs --> drape: who sees what --> light of panels, of vertices --+--> scene sampler
//!                    |                      or of each pixel --------------+
//!                    \--> albedo --> light of the scenario's sun (relight) +
//! ```
//!
//! # Law
//!
//! - **Posts** are the finest level of the bank at `spacing_m`, divided by `subdivide`, without craters smaller than that.
//! - **Panels.** Each cell is cut along its shorter diagonal in space, or along the one from south-east to north-west, as the thesis states.
//! - **Coarser panels.** With `coarser_px`, a frame takes larger triangles of posts where no point of them lies farther beside the panels on the screen. The
//!   light of a pixel is still looked up in the photographs.
//! - **Light** is that of the photographs, with their own sun and shadows: looked up in each pixel's footprint, or one light a panel, or that of the
//!   vertices, mixed in space. A panel has the mean of the pixels whose centres lie in it; one that is too small for that has a look at its middle. A
//!   vertex has the mean of its panels, by area.
//! - **Unseen** ground that seen ground encloses has its light from around; it counts as inferred. Ground beside the photographs has one light,
//!   `outside`.
//! - **Relight** lays the scenario's sun on the albedo that the photographs give, and with `[shadows]` the shadows that its posts cast.
//! - **Who sees what, footprints, albedo**: `photo-drape`. **Everything else** of the picture, clipping, depth and sampling: `scene-sampler`. Every
//!   pixel is drawn once, and sky has a label of its own.
//!
//! # Run parameters
//!
//! | key | range | default | what it is |
//! |---|---|---|---|
//! | `panels.spacing_m` | 0.01 to 1000000 | longer side of the ground / 512 | distance of posts |
//! | `panels.subdivide` | 1 to 64 | 1 | cells along each side of a cell |
//! | `panels.panel_pixels` | 0.01 to 1000000 | none | pixels of the first photograph on a panel in the middle of the ground, at most; in place of `subdivide` |
//! | `panels.diagonal` | `shorter`, `stated` | `shorter` | how cells are cut |
//! | `panels.coarser_px` | 0 to 100 | 0 | pixels up to which coarser panels may lie beside the panels; 0: none are coarser |
//! | `panels.drape` | `texture`, `gouraud`, `panel` | `texture` | light of each pixel, of vertices, or one a panel |
//! | `panels.choice` | `best`, `blend` | `best` | which photograph rules where several see the ground |
//! | `panels.infer` | true, false | true | unseen ground has light from around, where seen ground encloses it |
//! | `panels.outside` | 0 to 1 | 0 | light of ground beside the photographs |
//! | `panels.relight` | true, false | false | the scenario's sun on albedo, in place of the photograph's own light |
//! | `panels.restrictions` | true, false | false | all findings of the listing; `panel-program` draws |
//! | `panels.quadrant` | true, false | `restrictions` | the lower left quadrant of the field fills the screen ([`panel_program::Restrictions`]) |
//! | `panels.real4` | true, false | `restrictions` | coordinates, axes and distances have 24 bits ([`panel_program::Restrictions`]) |
//! | `panels.signed_bytes` | true, false | `restrictions` | greys are signed bytes ([`panel_program::Restrictions`]) |
//! | `panels.box_average` | true, false | `restrictions` | greys are averaged over a box ([`panel_program::Restrictions`]) |
//! | `panels.skewed_axes` | true, false | `restrictions` | axes come from two posts and the middle of the body ([`panel_program::Restrictions`]) |
//! | `panels.linear_depth` | true, false | `restrictions` | depth is linear on the screen ([`panel_program::Restrictions`]) |
//! | `panels.mirror_behind` | true, false | `restrictions` | ground behind the eye is projected ([`panel_program::Restrictions`]) |
//! | `panels.mean_void` | true, false | `restrictions` | voids have the mean of all posts ([`panel_program::Restrictions`]) |
//! | `panels.discard_partial` | true, false | `restrictions` | a panel with a corner beyond the screen is left out ([`panel_program::Restrictions`]) |
//! | `panels.both_ends` | true, false | `restrictions` | a span has both its ends ([`panel_program::Restrictions`]) |
//! | `panels.limits` | true, false | `restrictions` | at most 50 x 50 posts, 512 panels and 512 x 512 pixels ([`panel_program::Restrictions`]) |
//! | `panels.fill` | `edge-buffer`, `fence`, `seed`, `span`, `rasteriser` | none | `panel-program` draws, and fills panels in this way |
//! | `panels.posts` | a table | none | `panel-program` draws posts of its own, a second of arc apart: [`PostTable`] |
//! | `panels.voids` | `fill`, `mark` | `fill` | `mark`: `panel-program` draws, and panels that touch a void have the light `outside` |
//! | `panels.boundary_blend` | true, false | false | `panel-program` draws, and pixels on both sides of a border of panels have their mean |
//! | `panels.pattern` | `1`, `4`, `8`, `16`, `grid16`, `lattice32`, `off-centre16` | `4` | sampling points of a pixel |
//! | `panels.rotate` | true, false | false | the pattern is turned from pixel to pixel |
//! | `panels.filter` | `box`, `tent`, `gaussian` | `box` | how sampling points make a pixel |
//! | `panels.translucent` | -1 to 1000 | 4 | translucent surfaces that a sampling point keeps; -1 is without limit |
//! | `panels.lights` | -1 to 1000 | 1 | light points that it keeps; -1 is without limit |
//! | `panels.shared_stack` | true, false | false | both share one stack |
//! | `panels.least_diameter_px` | above what the pattern can miss, to 100 | 1.5 | least diameter of a light point |
//! | `panels.normalise` | true, false | true | a light point's light is divided by what its disc covers |
//! | `panels.blending` | `hiding`, `additive` | `hiding` | how a light point meets what is behind it |
//! | `panels.veil` | `points`, `stack-only` | `points` | whether calligraphic points dim those behind them |
//! | `panels.spot_px` | 0.05 to 100 | 0.6 | deviation of the beam's spot |
//! | `panels.beam_order` | `near-to-far`, `nearest-neighbour` | `near-to-far` | order in which the beam draws its points |
//! | `panels.beam_layer` | `both`, `raster`, `beam` | `both` | layers that a picture shows |
//!
//! # Signals
//!
//! A row of the picture stands for a sweep of the probe: panel, depth, grey, source, and as written writes and voids of each pixel.
//!
//! # Timing
//!
//! The scene sampler takes no time. The program of the thesis, with both ends of a span, is a batch program: [`tasks`] turns the work that `panel-program`
//! counts into seconds of a [`Hardware`], beside those that the thesis reports ([`REPORTED`]).
//!
//! # Threads
//!
//! Posts, panels and sub-areas are functions of their own, put together in their order: the bits do not depend on the number of threads.
//!
//! # Not modelled
//!
//! Coarser levels of the bank, remote shadow of ground that is not lit anew, texture, far silhouettes and vehicle tracks are listed as omissions. So is the scenario's sun, where it differs from
//! the photographs' by more than 5 degrees and nothing is lit anew.

mod coarser;
mod faults;
mod frame_ground;
mod greys;
mod mesh;
mod name;
mod panels;
mod parameters;
mod place;
mod prepared;
mod program;
mod relit;
mod row;
mod session;
mod signals;
mod time;

pub use coarser::{Bounds, Choice};
pub use mesh::Mesh;
pub use panels::Panels;
pub use parameters::{Diagonal, Fineness, Parameters, Shading};
pub use program::{Block, PostTable, ProgramKeys};
pub use row::ROW;
pub use time::{Hardware, REPORTED, tasks};
