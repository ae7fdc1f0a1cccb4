//! Ground and bodies as triangles, for every generator that draws triangles.
//!
//! ```text
//!  eye, rings --> blocks of the world grid --> fans --> triangles
//!                                                \--> vertices --> height, slopes, albedo (landscape, closed form)
//!  triangles, landscape --> HeightError (metres, pixels) --> fit_where: finer rings until the tolerance or the limit
//! ```
//!
//! # Law
//!
//! - **Rings.** Squares around the eye, each twice as wide and twice as coarse as the one inside it, up to the borders of the bank
//!   (all its levels). Their corners lie on the world grid, which begins at the south-western corner of the bank, so vertices
//!   stay where they are while the eye moves.
//! - **No cracks.** A ring consists of blocks of 2 x 2 cells, each a fan around its middle. On a side that meets the coarser
//!   ring, the fan leaves out the vertex in the middle of the side. So no vertex lies inside an edge of another triangle, and
//!   both rings have the same vertices.
//! - **Small features.** A vertex shows the ground as samples as far apart as its ring's cells can: craters smaller than a cell are left
//!   out, those of twice its size are whole ([`landscape::Landscape::at_spacing`]). On the border of two rings the coarser one
//!   rules. What is left out counts in the error.
//! - **Borders.** The grid is cut at the northern and eastern border of the bank: its last row and column may be narrower. Where a bank
//!   whose levels do not nest has no ground, there are no triangles.
//! - **Error** is measured, not derived: see [`HeightError`].
//!
//! Axes: x north, y east, h up (m), a left-handed triple. Corners of triangles run counter-clockwise seen from above, with north up and east
//! to the right, as corners of solids do seen from outside.
//!
//! # Threads
//!
//! Heights and errors are worked out by the threads of the caller's pool. Each vertex and each triangle is a function of its own, and errors are
//! put together by their maximum, so the number of threads does not matter.
//!
//! # See also
//!
//! `tests/ground_mesh`: closed meshes over random eyes, the error against closed form, its fall with the step, threads, bad input.

mod body;
mod error;
mod fit;
mod grid;
mod height_error;
mod mesh;
mod numbers;
mod rings;

pub use body::{BodyTriangle, body_triangles};
pub use error::MeshError;
pub use fit::{Fitted, Wish};
pub use height_error::HeightError;
pub use mesh::{GroundMesh, Vertex};
pub use rings::{FEWEST_CELLS, MOST_CELLS, Rings};
