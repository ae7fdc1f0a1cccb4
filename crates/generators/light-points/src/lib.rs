//! Light points of every generator: lamps, beacons and stars, in the raster or by a beam of their own (EP-0611021).
//!
//! ```text
//!  diameter, distance --> Disc (diameter, intensity) --> raster: Light (light added, translucency), energy normalised
//!  magnitude ----------->  ^                        \--> beam: Veil, Share (aperture, attenuation) --> budget --> Spot
//! ```
//!
//! # Law
//!
//! - **By distance** (claims 1, 2, 9, 10): a lamp is a disc of its projected diameter. Below a least diameter the disc stays
//!   and its intensity falls, so that intensity times area goes on as the inverse square of the distance.
//! - **Translucency** is 1 less the intensity: a near lamp hides what is behind it, a far one adds its colour.
//! - **Aperture**: a point's light is divided by the number of sampling points that its disc covers. Neither a raster point
//!   that is normalised nor a calligraphic one twinkles as it moves over the sampling points.
//! - **Calligraphic points** (claims 7, 8, 11 to 16) are read out near to far after all other features. A veil store keeps what
//!   each nearer point lets through.
//!
//! Lengths on the screen are in pixels, intensities linear with 1 for the display's white.
//!
//! # See also
//!
//! `tests/light_points`: check values, fly-past, twinkle, dust, two lamps in line, edge of the screen, overload.

mod beam;
mod disc;
mod error;
mod least;
mod light;
mod share;
mod spot;
mod under;
mod veil;

pub use beam::{BeamBudget, BeamPoint, nearest_neighbour};
pub use disc::{Disc, crossover, projected_diameter};
pub use error::LightError;
pub use least::LeastDiameter;
pub use light::{Blending, Light};
pub use share::{Share, add_up};
pub use spot::Spot;
pub use under::{count_under, mask_under};
pub use veil::{Accumulation, Veil};
