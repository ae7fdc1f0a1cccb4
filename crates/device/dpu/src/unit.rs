//! The unit that answers folds: what it is made of, and what it finds in the storage buffer.

use hardware_model::{Cpu, LoadDelay, Loader};
use landscape::Level;
use quantities::{SweepClock, SweepTime, Tick, Timebase};
use sweep_program::{Fold, Step};

use crate::watch::CornerArrival;

/// A fold and its instant.
pub type TimedFold = Step<Fold>;

/// A corner that a sweep may ask for and that the data bank has not delivered when the frame begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MissingCorner {
    /// Index in the level.
    pub corner: u32,
    /// When it comes; `None` if not in this frame.
    pub arrival: Option<Tick>,
}

/// The unit that answers folds with coefficient words.
#[derive(Debug, Clone, Copy)]
pub struct CrossingService<'a> {
    /// Terrain whose corners are delivered.
    pub level: &'a Level,
    /// How fast, and what happens to late words.
    pub loader: &'a Loader,
    /// Processor, which serves folds itself in some models.
    pub cpu: &'a Cpu,
    /// Clocks of the run.
    pub timebase: &'a Timebase,
    /// What is not in the storage buffer, in order of corners.
    pub missing: &'a [MissingCorner],
    /// Ticks from the start of the sweep in which a processor that serves the crossings is at a set-up that no interrupt
    /// breaks.
    pub held: u64,
    /// Seed of the model.
    pub seed: u64,
}

impl CrossingService<'_> {
    /// Whether every fold finds its words: wired through, nothing held back, nothing missing, no end of the service.
    pub(crate) fn has_all_at_once(&self) -> bool {
        let Loader { delays, stop_after_crossings, .. } = self.loader;
        self.loader.is_wired_through()
            && delays.is_empty()
            && stop_after_crossings.is_none()
            && self.missing.is_empty()
    }

    pub(crate) fn delays(&self, frame: u64, sweep: u32, crossing: u32) -> impl Iterator<Item = &LoadDelay> {
        self.loader.delays.iter().filter(move |delay| {
            delay.frame.is_none_or(|wanted| wanted == frame)
                && delay.sweep == sweep
                && delay.crossing == crossing
        })
    }

    /// When a processor that serves the crossings is done with the set-up that no interrupt breaks.
    pub(crate) fn held_until(&self, clock: &SweepClock) -> Tick {
        match self.held {
            0 => Tick(0),
            held => Tick(clock.tick_at_or_after(SweepTime(0.0)).0 + held),
        }
    }

    /// When `corner` is in the storage buffer.
    pub(crate) fn arrival_of(&self, corner: u32) -> CornerArrival {
        match self.missing.binary_search_by_key(&corner, |missing| missing.corner) {
            Ok(index) => self.missing[index].arrival.map_or(CornerArrival::NotInFrame, CornerArrival::At),
            Err(_) => CornerArrival::BeforeFrame,
        }
    }
}
