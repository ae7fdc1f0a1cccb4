//! Samples that go through the array together: part by part, so that what a part is and what it remembers stay in the
//! registers of the computer.

use signal::{Lanes, Real};

use super::basis::{Fed, UNITS};

/// Samples of a block: few enough that a block stays in the first cache, and that a bit of a u32 tells one.
pub(super) const BLOCK: usize = 16;

/// A wire at the samples of a block.
pub(super) type Row<S> = [Lanes<S>; BLOCK];

/// Wires of the array at the samples of a block.
#[derive(Debug, Clone)]
pub(super) struct Block<S> {
    /// What ramps feed function generators with: X, Y.
    pub(super) fed: [[Fed<S>; BLOCK]; 2],
    /// Function generators with their signs: X.
    pub(super) x: [Factor<S>; UNITS],
    /// And Y.
    pub(super) y: [Row<S>; UNITS],
    /// What meets at the amplifiers of the first stages, sum by sum.
    pub(super) partial: Vec<Row<S>>,
    /// Height and slopes.
    pub(super) sums: [Row<S>; 3],
}

/// First input of multipliers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factor<S> {
    pub(super) value: Row<S>,
    pub(super) square: Row<S>,
    /// Since the sample before.
    pub(super) change: Row<S>,
}

impl<S: Real> Default for Block<S> {
    fn default() -> Self {
        let row = [Lanes::default(); BLOCK];
        Self {
            fed: [[Fed::default(); BLOCK]; 2],
            x: [Factor { value: row, square: row, change: row }; UNITS],
            y: [row; UNITS],
            partial: Vec::new(),
            sums: [row; 3],
        }
    }
}
