//! Who looks at the signals of a group: a probe, or nobody.

use std::ops::Range;

use signal::{LANES, Probe, Real, Waveform};

use crate::record::Recorded;

/// Looks at groups that have run. Nobody, `()`, is not there once it is compiled.
pub trait Look: Sync {
    /// Whether any of `sweeps` is looked at.
    fn wants_any_of(&self, sweeps: Range<u32>) -> bool;

    /// Adds what is wanted of lane `lane`, which is sweep `sweep`, to `waveforms`.
    fn look<S: Real>(
        &self,
        recorded: &Recorded<'_, S>,
        lane: usize,
        sweep: u32,
        waveforms: &mut Vec<Waveform>,
    );
}

impl Look for Probe {
    fn wants_any_of(&self, sweeps: Range<u32>) -> bool {
        Probe::wants_any_of(self, sweeps)
    }

    fn look<S: Real>(
        &self,
        recorded: &Recorded<'_, S>,
        lane: usize,
        sweep: u32,
        waveforms: &mut Vec<Waveform>,
    ) {
        if self.wants_sweep(sweep) {
            waveforms.extend(recorded.waveforms(self, lane, sweep));
        }
    }
}

impl Look for () {
    fn wants_any_of(&self, _sweeps: Range<u32>) -> bool {
        false
    }

    fn look<S: Real>(
        &self,
        _recorded: &Recorded<'_, S>,
        _lane: usize,
        _sweep: u32,
        _waveforms: &mut Vec<Waveform>,
    ) {
    }
}

/// What a frame is worked out for.
#[derive(Debug)]
pub struct Wanted<'a, L> {
    /// Who looks at signals.
    pub look: &'a L,
    /// Sweeps that the picture is wanted of: all, none, or those of some columns.
    pub picture: &'a Range<u32>,
}

impl<L> Clone for Wanted<'_, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L> Copy for Wanted<'_, L> {}

impl<L: Look> Wanted<'_, L> {
    /// Whether anyone wants a sweep of the group that begins at sweep `first`.
    pub fn group(&self, first: u32) -> bool {
        let group = first..first + LANES as u32;
        let is_shown = self.picture.start < group.end && group.start < self.picture.end;
        is_shown || self.look.wants_any_of(group)
    }
}
