//! Coarser panels where the eye sees no difference.
//!
//! The posts are the corners of a square of 2^n cells that two triangles part, those two again, and so on: each triangle has its longest side
//! halved at the post in its middle. A frame halves what lies more than a stated number of pixels beside the panels, and no more.
//!
//! A post that halves two triangles has a bound for all that lies below them: how far (m) the panels lie above or below, and in what
//! sphere. A bound holds those of the posts below it. So both triangles beside a longest side are halved together, and the ground has no crack.

mod bounds;
mod choice;
mod half;

pub use bounds::Bounds;
pub use choice::Choice;
