//! Random numbers that are named by seed, item and use, so that no order and no count changes them.

use quantities::unit_interval;

/// Names the crate's use of the house's hash.
const BUILDER: u64 = u64::from_be_bytes(*b"terrainb");

/// What a number of an item is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Use {
    Longitude,
    Latitude,
    Radius,
    Wall,
    Depth,
    Yaw,
    Shape,
}

/// A number in `[0, 1)`: the hash of seed, item, use and attempt ([`quantities::unit_interval`], the finaliser of SplitMix64
/// word by word).
pub(crate) fn draw(seed: u64, item: u64, purpose: Use, attempt: u64) -> f64 {
    unit_interval(seed, &[BUILDER, item, purpose as u64, attempt])
}
