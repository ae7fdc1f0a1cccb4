//! Line of sight and viewshed: what ground hides from an observer.
//!
//! ```text
//!  heights --> Posts --> pyramid of highest posts
//!                |              |
//!  observer, target --> ray --> strips: past blocks that the line clears, else piece by piece --> Sight, LineOfSight
//!  observer, all posts --> rays by all threads --> viewshed, least heights
//!
//!  landscape --> Terrain --> planes above its regions, craters of each region
//!                   |              |
//!  observer, target --> way --> regions: past those that the line clears --> stretches between circles of craters
//!                                            halved until a bound tells --> Sight, LineOfSight
//! ```
//!
//! # Law
//!
//! - **Mesh** ([`Posts`]): posts of a regular grid, each cell cut from north-west to south-east into two triangles. The height of the
//!   ground above the datum is linear over a triangle. So the line is compared where it crosses the sides and diagonals of cells. Over a
//!   curved datum the point between two crossings at which it comes nearest is known in closed form.
//! - **Landscape** ([`Terrain`]): the polynomial of the finest level at each place, and all craters there. Texture is no ground. Within a
//!   region and between circles of craters the ground along the line is a polynomial of degree 10 and multiples of distances from
//!   centres. Bernstein coefficients, and the convexity of distances and of the sphere, bound the second derivative of the clearance. A
//!   stretch passes where that bound keeps it clear, else it is halved. Nothing is sampled, so no ridge is stepped over. Ground less
//!   than `2e-14` of heights and distance above the line counts as touching: that is the rounding of f64.
//! - **Touching is visible.** A target is hidden where ground stands above the line, not where it reaches the line.
//! - **Ends.** Observer and target do not hide each other: the ground of their own places is not compared.
//! - **Voids** hide nothing and show nothing. Where known ground hides the target it is hidden; else a line across a void is unknown.
//! - **Off the mesh**, and off all levels of a landscape, there is no ground. An observer may stand there, at a height above the datum.
//! - **Curvature** is flat, a parabola or a sphere, in the frame of the observer ([`Curvature`]). There is no refraction unless it is
//!   asked for. A target beyond the end of the sphere is refused.
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
mod line;
mod over_mesh;
mod over_terrain;
mod posts;
mod pyramid;
mod raster;
mod ray;
mod search;
mod sightline;
mod stretch;
mod terrain;
mod tier;
mod viewshed;
mod way;

pub use curvature::Curvature;
pub use error::SightError;
pub use posts::Posts;
pub use raster::Raster;
pub use sightline::{Blocker, Height, LineOfSight, Point, Sight};
pub use terrain::Terrain;
