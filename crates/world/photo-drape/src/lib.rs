//! Photographs over ground: which of them shows a place, its light there, and albedo out of it.
//!
//! ```text
//!  landscape --> Ground: posts ----+--> viewshed of each camera --> posts that it sees
//!                                  |                                     |
//!  photographs --> layers: smaller and smaller pictures ---------------> Drape --> light at a place, in a footprint
//!                                  |                                     \--> light in a triangle
//!                                  +--> normals, shadows of the photograph's sun --> albedo of posts
//! ```
//!
//! # Law
//!
//! - **Axes** are those of a landscape: north, east, up (m). [`Drape::new`] says how those of photographs lie in them.
//! - **Seen.** A camera sees a post where no triangle of the posts stands before it, by the exact viewshed of `sight`. It sees a place
//!   where posts that it sees weigh at least a half of the four around it. A map sees all. So nothing is painted through a hill onto what lies behind it.
//! - **Weight** of a photograph at a place is the number of its pixels on a square metre of the ground there: `n . v` over the squared
//!   ground sample. The heaviest rules ([`Choice::Best`]), or all are mixed by their weights ([`Choice::Blend`]).
//! - **Footprint.** What a pixel of the new picture covers of the ground is an ellipse. Light is the mean of up to [`MOST_PROBES`] looks
//!   along its longer axis, each into the smaller picture whose pixels are as large as its shorter one. Smaller pictures are means of 2 x 2
//!   pixels; looks are linear between them.
//! - **Triangle.** The mean light of the pixels whose centres lie in it. A centre on the side of two triangles is in one of them.
//! - **Albedo** is light over `max(n . s, 0.1)`, with s the photograph's sun. In the photograph's shadow, and so near it that pixels have a part of it, there is none, and the posts around fill
//!   it harmonically.
//! - All work is in light, never in codes.
//!
//! # Threads
//!
//! Each post and each place is a function of its own, so the number of threads does not matter.
//!
//! # See also
//!
//! `tests/photo_drape`: closed forms, hills that hide, stereo, footprints, shadows, bad input.

mod albedo;
mod drape;
mod error;
mod footprint;
mod ground;
mod layer;
mod pyramid;
mod rule;
mod shadow;
mod triangle;

pub use albedo::{Albedo, LEAST_COSINE};
pub use drape::{Choice, Drape, Shown};
pub use error::DrapeError;
pub use footprint::Footprint;
pub use ground::Ground;
pub use layer::MOST_PROBES;
pub use triangle::pixels as triangle_pixels;
