//! Waveforms between the samples of a sweep.
//!
//! ```text
//! machine at samples ────────────────────────────▶┐
//! second engine at every step of a divided clock ─┴▶ waveforms at every step
//! ```
//!
//! **Law.** A part is driven straight from one sample to the next, and its output in between is the exact solution of its differential
//! equation; a word that a D/A takes within the sample divides it. A wire without memory is what it is at the ground range there, which
//! goes straight from sample to sample too. So a part of 20 ns is seen to settle inside a sample of 53 ns.
//! **How it is computed.** The second engine follows the sweep on a divided clock. It agrees with the machine at samples to 1e-9 of
//! full scale; what is left there is taken off in between, straight from sample to sample. At samples the values are the machine's own bits.
//! **Our choices.** A gate is what it is at each instant. A wire on which the second engine has no opinion goes straight from sample to
//! sample, as behind real parts of feature generator, mixing unit and projection processor; a gate of that kind stays, and [`Between::straight`] names them. Beyond the stored ground a wire keeps its value.

mod merge;

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use lockstep::Engines;
use quantities::Timebase;
use rayon::ThreadPool;
use scenario::Pose;
use scope::{Looking, ScopeError};
use signal::{Axis, Waveform};

use crate::merge::merged;

/// Looks at the sweeps of a frame between samples.
pub struct Between<'a> {
    /// Both engines of the machine.
    engines: &'a Engines,
    /// Threads that draw the sweeps.
    pool: &'a ThreadPool,
    /// Number of the frame, counted at the update rate.
    frame: u64,
    /// Where it is seen from.
    pose: &'a Pose,
    /// Clocks of the machine.
    clocks: Timebase,
    /// The same clocks with more steps.
    divided: Timebase,
    /// Wires that went straight from sample to sample so far, and why.
    straight: Mutex<BTreeMap<&'static str, &'static str>>,
}

impl<'a> Between<'a> {
    /// Looks at frame `frame` from `pose`; `divided` are the clocks of the machine with more steps.
    pub fn new(
        engines: &'a Engines,
        pool: &'a ThreadPool,
        (frame, pose): (u64, &'a Pose),
        [clocks, divided]: [Timebase; 2],
    ) -> Self {
        Self { engines, pool, frame, pose, clocks, divided, straight: Mutex::default() }
    }

    /// Wires that went straight from sample to sample in what was looked at so far, and why.
    pub fn straight(&self) -> BTreeMap<&'static str, &'static str> {
        self.straight.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Waveforms of the signals called `names` in a sweep; instants of changes are in divided steps too.
    fn sweep(&self, names: &[String], sweep: u32) -> Result<Vec<Waveform>, ScopeError> {
        let at = (self.frame, self.pose);
        let (mut machine, record) = self.engines.between(at, sweep, names.to_vec(), self.divided)?;
        machine.retain(|wave| names.iter().any(|name| wave.signal.matches(name)));
        let steps = (self.divided.sweep_samples() / self.clocks.sweep_samples()) as usize;
        let mut straight = self.straight.lock().unwrap_or_else(PoisonError::into_inner);
        let one = |wave: Waveform| {
            let why = self.engines.why_straight(wave.signal.name, &record);
            let own = record.signals.get(wave.signal.name).filter(|_| why.is_none());
            if let Some(why) = why.filter(|_| wave.signal.axis == Axis::Ground) {
                straight.insert(wave.signal.name, why);
            }
            merged(wave, own.map(Vec::as_slice), steps)
        };
        Ok(machine.into_iter().map(one).collect())
    }
}

impl Looking for Between<'_> {
    fn at(&self, names: Vec<String>, sweeps: Range<u32>) -> Result<Vec<Waveform>, ScopeError> {
        let all = self
            .pool
            .install(|| sweeps.map(|sweep| self.sweep(&names, sweep)).collect::<Result<Vec<_>, _>>())?;
        Ok(all.into_iter().flatten().collect())
    }
}
