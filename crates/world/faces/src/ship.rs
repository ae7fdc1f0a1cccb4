//! Ships as face models, made from public dimensions.
//!
//! Axes: forward, starboard, up from the waterline amidships (m); left-handed like north, east, up.

mod hide;
mod hull;
mod motion;
mod pieces;
mod types;

pub use hide::{Arrangement, Hiding, PITCH, Wedges, bow_gap, box_error};
pub use motion::{Attitude, Motion, Wave};

/// Shape of the hull at one height above the water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Level {
    /// Height above the water (m), negative below.
    pub up: f64,
    /// Half breadth amidships, as a part of half the beam.
    pub breadth: f64,
    /// Part of the length over which it narrows to a point at the bow.
    pub entrance: f64,
    /// Part of the length over which it narrows to the stern.
    pub run: f64,
    /// Half breadth at the stern, as a part of that amidships.
    pub transom: f64,
    /// Distance of its bow behind the foremost point (m).
    pub cut_back: f64,
}

/// A box upon the deck: part of the island, the superstructure, a mast or a gun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Aft and forward end (m).
    pub along: [f64; 2],
    /// Port and starboard side (m).
    pub across: [f64; 2],
    /// Bottom and top (m above the water).
    pub up: [f64; 2],
    /// Part of its length and breadth that its top has.
    pub taper: f64,
}

/// A rectangle painted on the deck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marking {
    /// Aft and forward end (m).
    pub along: [f64; 2],
    /// Port and starboard side (m).
    pub across: [f64; 2],
}

/// A type of ship. Length, beam and draught are public figures; the other shapes are chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ship {
    /// Name of the type.
    pub name: &'static str,
    /// Length of the hull overall (m).
    pub length: f64,
    /// Beam at the waterline (m).
    pub beam: f64,
    /// Draught below the waterline (m).
    pub draught: f64,
    /// Hull from the keel to the deck, the waterline among the levels.
    pub levels: [Level; 5],
    /// Boxes upon the deck.
    pub blocks: &'static [Block],
    /// Markings of the deck.
    pub markings: &'static [Marking],
}
