//! What someone may want to know of the service of the crossings.

use quantities::{SweepTime, Tick};
use sweep_program::{Colour, Fold, Load, PreloadRegister};

/// Use of one line of the loader in one sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LineUse {
    /// Ticks of service.
    pub busy: u64,
    /// Of these, interrupts: recognition, save, restore, pointers.
    pub interrupts: u64,
    /// Most sets that waited at once.
    pub longest_queue: u32,
}

/// A corner that a register asks of the storage buffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskedCorner {
    /// When its access begins.
    pub tick: Tick,
    /// The same on the sweep clock.
    pub at: SweepTime,
    /// The fold that asks, counted from 0 in the sweep; none for home registers.
    pub crossing: Option<u32>,
    /// Whose register.
    pub colour: Colour,
    /// Which preload register; none for hold, and for the corner beyond both stops.
    pub register: Option<PreloadRegister>,
    /// Index in the level.
    pub corner: u32,
    /// When it is in the buffer.
    pub arrival: CornerArrival,
}

/// When the data bank has delivered a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CornerArrival {
    /// Before the frame began.
    BeforeFrame,
    /// Within it.
    At(Tick),
    /// Not in this frame.
    NotInFrame,
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
    /// A set was asked of the storage buffer.
    fn corner(&mut self, _asked: &AskedCorner) {}
    /// The sweep is over.
    fn end(&mut self, _lines: &[LineUse; 4]) {}
}

impl Watch for () {
    const LISTENS: bool = false;
}
