//! The way through a mission, sweep by sweep.

use std::ops::Range;

use signal::Waveform;

use crate::{Hit, Trigger};

/// Which of the places are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Which {
    /// One of them, counted from 1.
    Nth(u64),
    /// All places of the search.
    All,
}

/// A search that is on its way.
#[derive(Debug, Clone)]
pub struct Search<'t> {
    trigger: &'t Trigger,
    armed: Range<usize>,
    which: Which,
    met: u64,
}

impl<'t> Search<'t> {
    /// A search for `trigger` at the samples `armed` of every sweep.
    pub fn new(trigger: &'t Trigger, which: Which, armed: Range<usize>) -> Self {
        Self { trigger, armed, which, met: 0 }
    }

    /// Looks at the next sweep; the places in it that are wanted, each with its number in the mission, from 1.
    pub fn look_at(&mut self, waveforms: &[Waveform]) -> Vec<(u64, Hit)> {
        if self.is_over() {
            return Vec::new();
        }
        let first = self.met + 1;
        let hits = self.trigger.find(waveforms, self.armed.clone());
        self.met += hits.len() as u64;
        let is_wanted = |number: u64| match self.which {
            Which::Nth(wanted) => number == wanted,
            Which::All => true,
        };
        (first..).zip(hits).filter(|(number, _)| is_wanted(*number)).collect()
    }

    /// Whether nothing that comes could be wanted.
    pub fn is_over(&self) -> bool {
        matches!(self.which, Which::Nth(wanted) if self.met >= wanted)
    }

    /// Places met so far.
    pub fn met(&self) -> u64 {
        self.met
    }
}
