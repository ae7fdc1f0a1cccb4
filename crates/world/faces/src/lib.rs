//! Smooth-shaded faces: lists with a sun of their own, patterns of false normals, faces that take turns.
//!
//! ```text
//!  vertices, faces --> Mesh --> CornerNormals --+
//!                                               +--> brightness at corners --> Ramp of a scan line --> sample
//!  SunProgramme, frame --> sun vector ----------+
//!  Pattern, Cone --> false normals of a Board --> Sea --> Group
//!  frame, signal --> Sequence --> faces that show --> Group        priority, depth --> Order --> face that is seen
//! ```
//!
//! # Law
//!
//! - **Axes.** North, east, up (m): the axes of [`solids::Body`]. The triple is left-handed, so a cross product of components is
//!   reversed here. Corners run counter-clockwise seen from the front. Azimuths run from north towards east (radians).
//! - **Shading.** Normals are averaged, then made unit vectors, then multiplied with the sun ([`brightness`]).
//! - **Contrast** of a pattern is `cot alpha cot elevation` (derived), where nothing is clamped to black ([`Cone`]).
//! - **Patterns** are functions of place and seed, so extent and threads do not matter ([`Pattern`]).
//! - **Frames** count turns in whole numbers, so a film closes to the bit ([`Turn`]).
//! - **Priority.** The lower number wins; equal numbers are refused ([`check_priorities`]).
//!
//! # See also
//!
//! - [`ship`]: LPH-2 and DD963, their motion, and ways to hide the hull.
//! - [`solids`] reads files of shapes.

mod board;
mod body;
mod bow_wake;
mod check;
mod clip;
mod cone;
mod cut;
mod effect;
mod error;
mod face;
mod flight;
mod group;
mod levels;
mod mesh;
mod model;
mod normals;
mod pattern;
mod plume;
mod priority;
mod ramp;
mod roads;
mod sea;
mod sequence;
mod shade;
pub mod ship;
mod states;
mod sun;
mod warning;

pub use board::{Board, GridVertex};
pub use body::{BodyFaces, BodyNormals, BodyTriangle};
pub use bow_wake::{BOW_FACES, BowWake, Side, blend};
pub use clip::Half;
pub use cone::Cone;
pub use cut::Cut;
pub use effect::{Effect, Setting};
pub use error::FaceError;
pub use face::{Face, Shading, Sides, Vertex};
pub use flight::{Flight, MOON};
pub use group::{Detail, Group};
pub use levels::Level;
pub use mesh::{Loaded, Mesh};
pub use model::{Model, ModelShading};
pub use normals::{CornerNormals, Weights};
pub use pattern::{Pattern, TwoSine};
pub use plume::Plume;
pub use priority::{Cover, Order, check_priorities};
pub use ramp::{End, Interpolation, Ramp, Scan, ScreenCorner};
pub use roads::{Animate, renumbered, steps_of};
pub use sea::Sea;
pub use sequence::{Drive, Mode, Sequence};
pub use shade::{brightness, in_space, lit, screen_error};
pub use states::{Mean, SeaState};
pub use sun::{SunProgramme, Turn, TurningSun, sun_vector};
pub use warning::{Degenerate, Warning};
