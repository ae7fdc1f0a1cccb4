//! What someone may want to know of the service of the crossings.

use quantities::{SweepTime, Tick};
use sweep_program::{Colour, Fold, Load};

/// Use of one line of the loader in one sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LineUse {
    /// Ticks of service.
    pub busy: u64,
    /// Most sets that waited at once.
    pub longest_queue: u32,
}

/// Told what the service does; every method may be left out. Nobody is told at no cost: `()`.
pub trait Watch {
    /// Whether anyone is told: what only a listener needs is not worked out for nobody.
    const LISTENS: bool = true;

    /// A stop was seen at `tick`.
    fn fold(&mut self, _tick: Tick, _fold: Fold) {}
    /// A set was asked for.
    fn wanted(&mut self) {}
    /// The last word of a set came.
    fn loaded(&mut self) {}
    /// A set was overwritten before a fold used it.
    fn wasted(&mut self) {}
    /// A set was no longer wanted before it came.
    fn cancelled(&mut self) {}
    /// Words come at `tick`.
    fn arrival(&mut self, _tick: Tick, _load: &Load) {}
    /// A fold used a set that came `slack` ticks before it; below 0 it was late.
    fn transfer(&mut self, _slack: i64) {}
    /// At `tick`, on the sweep clock `at`, a set was asked of a corner that was not in the storage buffer and comes at
    /// `arrival`, if within the frame.
    fn starved(
        &mut self,
        _tick: Tick,
        _at: SweepTime,
        _colour: Colour,
        _corner: u32,
        _arrival: Option<Tick>,
    ) {
    }
    /// The sweep is over.
    fn end(&mut self, _lines: &[LineUse; 4]) {}
}

impl Watch for () {
    const LISTENS: bool = false;
}
