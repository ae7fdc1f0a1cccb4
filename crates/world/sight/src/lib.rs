//! Line of sight and viewshed: what ground hides from an observer.
//!
//! ```text
//!  heights --> Posts --> pyramid of highest posts
//!                |              |
//!  observer, target --> ray --> strips: past blocks that the line clears, else piece by piece --> Sight, LineOfSight
//!  observer, all posts --> rays by all threads --> viewshed, least heights
//! ```
//!
//! # Law
//!
//! - **Ground** is a mesh: posts of a regular grid, each cell cut from north-west to south-east into two triangles. The height of the
//!   ground above the datum is linear over a triangle. So the line is compared where it crosses the sides and diagonals of cells. Over a
//!   curved datum the point between two crossings at which it comes nearest is known in closed form.
//! - **Touching is visible.** A target is hidden where ground stands above the line, not where it reaches the line.
//! - **Ends.** Observer and target do not hide each other: the ground of their own places is not compared.
//! - **Voids** hide nothing and show nothing. Where known ground hides the target it is hidden; else a line across a void is unknown.
//! - **Off the mesh** there is no ground. An observer may stand there, at a height above the datum.
//! - **Curvature** is flat or a parabola ([`Curvature`]). There is no refraction unless it is asked for.
//! - **Levels** are the same mesh with a stride ([`Posts::level`]).
//!
//! # Speed
//!
//! A strip of 2^l rows (or columns, whichever the line crosses more of) is passed in one step where the lowest point of the line over it
//! is not below the highest post of its blocks. This leaves out only ground that cannot block, so the answer is that of all crossings.
//!
//! # Threads
//!
//! Each target is a function of its own, so the number of threads does not matter.
//!
//! # See also
//!
//! `tests/sight`: closed forms, a second evaluator over all triangles, voids, threads, bad input.
//!
//! Axes: north and east on the map (m), heights above the datum (m).

mod curvature;
mod error;
mod judges;
mod posts;
mod pyramid;
mod ray;
mod sightline;
mod viewshed;

pub use curvature::Curvature;
pub use error::SightError;
pub use posts::Posts;
pub use sightline::{Blocker, Height, LineOfSight, Point, Sight};
