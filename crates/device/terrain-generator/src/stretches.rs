//! A sweep on its way from stretch to stretch: between two events the registers stand still and both ramps are straight.

use std::ops::Range;

use sweep_program::SweepProgram;

use crate::{Registers, TerrainGenerator};

/// One sweep on its way.
pub(crate) struct Walk<'p> {
    program: &'p SweepProgram,
    pub(crate) registers: Registers,
    next_step: usize,
    /// First sample that the present stretch does not cover.
    until: usize,
    /// First sample beyond the end of the profile.
    pub(crate) last: usize,
}

/// Samples between two events.
pub(crate) struct Stretch {
    pub(crate) samples: Range<usize>,
    /// Ground ranges at which it begins and ends (m).
    pub(crate) ends: [f64; 2],
}

impl<'p> Walk<'p> {
    /// A walk from sample `first` on.
    pub(crate) fn new(generator: &TerrainGenerator<'_>, program: &'p SweepProgram, first: usize) -> Self {
        Self {
            program,
            registers: Registers::at_start(program),
            next_step: 0,
            until: first,
            last: first_beyond(generator.ranges, program.end_range),
        }
    }

    /// The next stretch that begins before sample `end`, with the registers as they stand in it; none beyond the profile.
    pub(crate) fn next(&mut self, generator: &TerrainGenerator<'_>, end: usize) -> Option<Stretch> {
        let sample = self.until;
        if sample >= end.min(self.last) {
            return None;
        }
        let begin = self.apply_due(generator, sample);
        let end = self.end_of_stretch(generator.ranges, sample);
        Some(Stretch { samples: sample..self.until, ends: [begin, end] })
    }

    /// Range at which the present stretch begins, after all steps up to `sample` are done.
    fn apply_due(&mut self, generator: &TerrainGenerator<'_>, sample: usize) -> f64 {
        let mut begin = generator.ranges[sample.saturating_sub(1)];
        let ahead = self.program.steps[self.next_step..].iter();
        let mut due = 0;
        for step in ahead.take_while(|step| step.sample <= sample) {
            self.registers.apply(step, generator.buffer);
            if step.kind.changes_hold() && step.range > begin {
                begin = step.range;
            }
            due += 1;
        }
        self.next_step += due;
        begin
    }

    /// Sets the first sample that the stretch does not cover; the range at which it ends.
    fn end_of_stretch(&mut self, ranges: &[f64], sample: usize) -> f64 {
        let ahead = &self.program.steps[self.next_step..];
        let next = ahead.iter().find(|step| step.kind.changes_hold());
        self.until = next.map_or(self.last, |step| step.sample.min(self.last)).max(sample + 1);
        next.map_or(self.program.end_range, |step| step.range).min(ranges[ranges.len() - 1])
    }

    /// Values and rates of both ramps at a place `lambda` (in regions).
    #[inline]
    pub(crate) fn ramps(&self, lambda: f64) -> [(f64, f64); 2] {
        let (start, folds) = (&self.program.start, self.registers.folds());
        std::array::from_fn(|axis| start.ramps[axis].at(folds[axis], lambda))
    }

    /// Cosine and sine of the sweep's azimuth.
    pub(crate) fn direction(&self) -> [f64; 2] {
        self.program.start.direction
    }
}

/// First of some ranges that lies beyond `end`; how many there are if none does, as of most sweeps.
fn first_beyond(ranges: &[f64], end: f64) -> usize {
    match ranges.last() {
        Some(&last) if last <= end => ranges.len(),
        _ => ranges.partition_point(|&range| range <= end),
    }
}
