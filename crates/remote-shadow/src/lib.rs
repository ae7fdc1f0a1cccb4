//! Remote shadow before the mission: sun-parallel profiles, boundaries, tiles.

mod axes;
mod bank;
mod body;
mod cache;
mod caster;
mod control_net;
mod cover;
mod ground;
mod point;
mod profile;
mod segment;
mod sheet;
mod strip;
#[cfg(test)]
mod tests;
mod tile;

pub use bank::{Resolution, ShadowBank};
pub use body::cast_by_body;
pub use segment::Segment;
pub use tile::Tile;
