//! Samples that go through the array together: part by part, so that what a part is and what it remembers stay in the
//! registers of the computer.

use signal::{Both, Lanes, Real};

use super::basis::{CURVES, Fed};

/// Samples of a block: few enough that a block stays in the first cache, and that a bit of a u32 tells one.
pub(super) const BLOCK: usize = 16;

/// A wire at the samples of a block.
pub(super) type Row<S> = [Lanes<S>; BLOCK];

/// Two wires side by side.
pub(super) type BothRow<S> = [Both<S>; BLOCK];

/// Wires of the array at the samples of a block.
#[derive(Debug, Clone)]
pub(super) struct Block<S> {
    /// What ramps feed function generators with: X, Y.
    pub(super) fed: [[Fed<S>; BLOCK]; 2],
    /// Function generators with their signs, a curve at both ends side by side: X.
    pub(super) x: [Factor<S>; CURVES],
    /// Function generators with their signs, a curve at both ends side by side: Y.
    pub(super) y: [BothRow<S>; CURVES],
    /// What meets at the amplifiers of the first stages, sum by sum.
    pub(super) partial: Vec<Row<S>>,
    /// The three sums: height and both slopes.
    pub(super) sums: [Row<S>; 3],
}

/// First inputs of multipliers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factor<S> {
    pub(super) value: BothRow<S>,
    pub(super) cube: BothRow<S>,
    /// Since the sample before.
    pub(super) change: BothRow<S>,
}

impl<S: Real> Default for Block<S> {
    fn default() -> Self {
        let (row, both) = ([Lanes::default(); BLOCK], [Both::default(); BLOCK]);
        Self {
            fed: [[Fed::default(); BLOCK]; 2],
            x: [Factor { value: both, cube: both, change: both }; CURVES],
            y: [both; CURVES],
            partial: Vec::new(),
            sums: [row; 3],
        }
    }
}
