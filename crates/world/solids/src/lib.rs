//! Convex polyhedra: rocks and culture, their shapes, files and places (report III.A.3, section 12).
//!
//! A solid has body axes (forward, starboard, up), metres, with its foot point at the origin. A body is a solid
//! placed on the ground: x north, y east, h up. Both triples are left-handed (section 4), so seen from outside
//! the corners of a face run counter-clockwise while the cross product of its edges, taken by components,
//! points inwards.
//!
//! - [`Solid`]: checked on making; [`Solid::hull`], [`Solid::boxed`], [`Solid::prism`] make common ones.
//! - [`Solid::open`]: a surface that need not close. [`Solid::coloured`], [`Solid::with_normals`]: colour, smooth light.
//! - [`Body`]: a solid in its place; bounding sphere, light of its faces, meeting with a ray.
//! - [`shape_files`]: solids from files of shapes.
//! - [`rocks`]: seeded shapes of rocks; [`RockField`]: rocks by a size law, addressed by position.
//! - [`culture`]: man-made things by name.
//!
//! Albedo is relative to the scale of the ground's albedo, which is 1 unless a scenario says otherwise.

mod body;
mod check;
pub mod culture;
mod edges;
mod eights;
mod error;
mod hull;
mod looks;
mod rock_field;
pub mod rocks;
pub mod shape_files;
mod shapes;
mod solid;
mod split;

pub use body::{Body, Hit, Kind};
pub use edges::EdgeWords;
pub use eights::{EightFaces, Eights};
pub use error::SolidError;
pub use rock_field::{Rock, RockField, RockFieldError, SizeLaw};
pub use solid::{Face, Solid};
