//! Service of the crossings: from folds to a sweep program.

use hardware_model::{Cpu, LoadDelay, Loader};
use landscape::Level;
use quantities::{SweepClock, SweepTime, Tick, Timebase};
use sweep_program::{Fold, SweepProgram, SweepStart};

use crate::Pointers;
use crate::service::Service;
use crate::watch::{CornerArrival, Watch};

/// A fold and its instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedFold {
    /// When, on the sweep clock.
    pub time: SweepTime,
    /// Ground range then (m).
    pub range: f64,
    /// Which stop.
    pub fold: Fold,
}

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
    /// Writes the program of the sweep at `place` (frame, sweep) into `program`, whose buffers are reused. `folds`
    /// ends where the profile ends, at `end_range` (m); `range_at` gives the range of an instant. `watch` is told
    /// what happens, `&mut ()` if nobody wants to know.
    pub fn write_program(
        &self,
        place: (u64, u32),
        start: SweepStart,
        folds: impl Iterator<Item = TimedFold>,
        end_range: f64,
        range_at: impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
        watch: &mut impl Watch,
    ) {
        program.start = start;
        program.registers = Pointers::at_start(&start).home_registers(self.level);
        program.end_range = end_range;
        program.steps.clear();
        program.misses.clear();
        let mut service = Service::new(self, place, &start, watch);
        service.look_up_home(program);
        for fold in folds {
            service.reach(fold, &range_at, program);
            service.serve(fold, program);
        }
        service.finish(&range_at, program);
        while program.steps.last().is_some_and(|step| step.range > end_range) {
            program.steps.pop();
        }
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
