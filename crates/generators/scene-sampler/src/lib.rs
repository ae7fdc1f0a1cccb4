//! A scene of faces, light points and discs of the sky, drawn by sampling points: for every generator that draws faces.
//!
//! ```text
//!  Ground of the generator -+
//!  bodies of the stage -----+--> clip --> Faces ------> Lists by sub-area --+
//!  sheets, overlays --------+                                                v
//!  lamps, stars ------------> discs ----> Lights by sub-area ----------> Sampler: stacks --> colours --> Picture --> planes
//!  Earth, sun --------------> discs of the sky --------------------------^   |
//!                                                   calligraphic points: shares --+--> Beam --> spots
//! ```
//!
//! # Law
//!
//! - **Ground** comes from the generator as triangles with colours at their corners ([`Ground`]). A map may replace the colours
//!   ([`GroundMap`]): each pixel then has the map's colour in its middle, whatever the triangles are.
//! - **Bodies** are the triangles of their faces, lit at their corners.
//! - **Coverage, distance**: `raster`. **Stacks, colour, losses**: `translucency`. **Light points, beam**: `light-points`.
//! - **Colour in a pixel**: a surface has the colour of its pixel's middle at all sampling points of the pixel. Dust has the
//!   translucency of the path through the middle. A disc of the sky has the mean of the points that it covers.
//! - **Planes.** `range` and `distance` are of the nearest opaque surface over all sampling points of a pixel, along the ray of
//!   its middle. `label` is of that surface, or of a light, sheet or overlay that weighs more than a half before it.
//! - Perspective is the true one under every law of projection; roll is the yoke's.
//!
//! Run parameters of sampling are the same keys in the table of every generator that draws with it ([`Parameters`]). Limits of lists are the
//! generator's own: it hands the lists over.
//!
//! # Threads
//!
//! Sub-areas are drawn by the threads of the current rayon pool, and put together in their order: the bits do not depend on the number
//! of threads.
//!
//! # See also
//!
//! `crates/generators/sampled/tests/sampled`: a second evaluator of every pixel, bodies, sheets, lights, filters, threads.

mod band;
mod beam;
mod camera;

mod faces;
mod fields;
mod filled;
mod ground;
mod ground_map;
mod judged;
mod lights;
mod made_ready;
mod parameters;
mod picture;
mod pixel_rows;
mod point;
mod reading;
mod scene;
mod slopes;
mod tile;
mod untimed;
mod wedge;

pub use beam::Beam;
pub use camera::Camera;
pub use faces::{Corner, FaceError, Faces, Look, Mapped, NEAR, Surface, Work};
pub use fields::{Field, Fields, Shown, expect_course, pose};
pub use filled::Filled;
pub use ground::Ground;
pub use ground_map::{Axis, GroundMap};
pub use judged::faces as judged_faces;
pub use lights::{Lights, Point};
pub use made_ready::{omissions, screen, small_craters};
pub use parameters::{BeamLayer, BeamOrder, Parameters};
pub use picture::{PLANES, Picture, area_of, draw, fill};
pub use pixel_rows::{pixel_scan, record_pixel_rows};
pub use reading::Reading;
pub use scene::Scene;
pub use slopes::{Slopes, slopes_between};
pub use tile::SIDE;
pub use untimed::{draw_untimed, with_pixel};
pub use wedge::Wedge;
