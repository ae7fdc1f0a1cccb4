//! What is looked at: some signals of some sweeps.

use std::ops::Range;

use crate::Signal;

/// One signal of one sweep, in physical units.
#[derive(Debug, Clone, PartialEq)]
pub struct Waveform {
    /// Signal that was recorded.
    pub signal: Signal,
    /// Frame it belongs to.
    pub frame: u64,
    /// Sweep of the frame; of a signal of [`Axis::Line`](crate::Axis::Line) the line, in the order in which lines are scanned.
    pub sweep: u32,
    /// Instants of the values, in samples from the start of the sweep; empty unless the signal is one of
    /// [`Axis::Changes`](crate::Axis::Changes).
    pub times: Vec<f64>,
    /// One value a sample, a line, a column or an instant, as the signal's axis says.
    pub values: Vec<f64>,
}

/// A request for waveforms, and what came of it. Without wishes it costs nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Probe {
    patterns: Vec<String>,
    sweeps: Range<u32>,
    /// What was recorded, by sweep, then by signal table order.
    pub waveforms: Vec<Waveform>,
}

impl Probe {
    /// Nothing is looked at.
    pub fn off() -> Self {
        Self::default()
    }

    /// Signals that match any of `patterns` (see [`Signal::matches`]) in `sweeps`.
    pub fn new(patterns: Vec<String>, sweeps: Range<u32>) -> Self {
        Self { patterns, sweeps, waveforms: Vec::new() }
    }

    /// Whether any signal is wanted.
    pub fn is_on(&self) -> bool {
        !self.patterns.is_empty() && !self.sweeps.is_empty()
    }

    /// Whether any signal of a sweep of `sweeps` is wanted.
    pub fn wants_any_of(&self, sweeps: Range<u32>) -> bool {
        self.is_on() && sweeps.start < self.sweeps.end && self.sweeps.start < sweeps.end
    }

    /// Whether any signal of `sweep` is wanted.
    pub fn wants_sweep(&self, sweep: u32) -> bool {
        self.sweeps.contains(&sweep) && !self.patterns.is_empty()
    }

    /// Whether `signal` is wanted in the sweeps looked at.
    pub fn wants(&self, signal: &Signal) -> bool {
        self.patterns.iter().any(|pattern| signal.matches(pattern))
    }
}
