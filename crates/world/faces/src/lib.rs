//! Smooth-shaded faces: lists with a sun of their own, patterns of false normals, faces that take turns.
//!
//! ```text
//!  vertices, faces --> Mesh --> CornerNormals --+
//!                                               +--> brightness at corners --> Ramp of a scan line --> sample
//!  SunProgramme, frame --> sun vector ----------+
//!  frame, signal --> Sequence --> faces that show --> Group        priority, depth --> Order --> face that is seen
//! ```
//!
//! # Law
//!
//! - **Axes.** North, east, up (m): the axes of [`solids::Body`]. The triple is left-handed, so a cross product of components is
//!   reversed here. Corners run counter-clockwise seen from the front. Azimuths run from north towards east (radians).
//! - **Shading.** Normals are averaged, then made unit vectors, then multiplied with the sun ([`brightness`]).
//! - **Frames** count turns in whole numbers, so a film closes to the bit ([`Turn`]).
//! - **Priority.** The lower number wins; equal numbers are refused ([`check_priorities`]).
//!
//! # See also
//!
//! [`solids`] reads files of shapes.

mod check;
mod cut;
mod error;
mod face;
mod group;
mod mesh;
mod normals;
mod priority;
mod ramp;
mod sequence;
mod shade;
mod sun;
mod warning;

pub use cut::Cut;
pub use error::FaceError;
pub use face::{Face, Shading, Sides, Vertex};
pub use group::{Detail, Group};
pub use mesh::{Loaded, Mesh};
pub use normals::{CornerNormals, Weights};
pub use priority::{Cover, Order, check_priorities};
pub use ramp::{End, Interpolation, Ramp, Scan, ScreenCorner};
pub use sequence::{Drive, Mode, Sequence};
pub use shade::{brightness, in_space, lit, screen_error};
pub use sun::{SunProgramme, Turn, TurningSun, sun_vector};
pub use warning::{Degenerate, Warning};
