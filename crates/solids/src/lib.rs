//! Convex polyhedra: rocks and culture, their shapes, files and places (report III.A.3, section 12).
//!
//! A solid has body axes (forward, starboard, up), metres, with its foot point at the origin. A body is a solid
//! placed on the ground: x north, y east, h up.

mod body;
mod solid;

pub use body::{Body, Kind};
pub use solid::{Face, Solid, SolidError};
