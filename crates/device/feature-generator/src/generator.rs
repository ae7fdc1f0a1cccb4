//! Signal side: a group of sweeps, from programs to profiles.

use std::mem;

use features::Features;
use signal::{LANES, Real};

use crate::bank::Bank;
use crate::steps::Step;
use crate::{FeatureProfile, FeatureProgram, Kink};

/// What the block is set to for one frame.
#[derive(Debug, Clone, Copy)]
pub struct FeatureGenerator<'a> {
    /// Ground range of each sample, ascending (m).
    pub ranges: &'a [f64],
}

/// One sweep of the group.
struct Sweep<'a> {
    ranges: &'a [f64],
    lane: usize,
    /// First sample beyond the end of the profile.
    last: usize,
}

impl FeatureGenerator<'_> {
    /// Runs the programs of a group side by side into `profile`; `features` are those from which the programs were
    /// written.
    pub fn run<S: Real>(
        &self,
        features: &Features,
        programs: &[FeatureProgram; LANES],
        profile: &mut FeatureProfile<S>,
    ) {
        profile.clear(self.ranges.len());
        let mut bank = mem::take(&mut profile.bank);
        for (lane, program) in programs.iter().enumerate() {
            let last = self.ranges.partition_point(|&range| range <= program.end_range);
            bank.load(program, features);
            Sweep { ranges: self.ranges, lane, last }.run(&mut bank, profile);
        }
        profile.bank = bank;
    }
}

impl Sweep<'_> {
    /// Stretch by stretch: between two steps no sub-generator changes its zone.
    fn run<S: Real>(&self, bank: &mut Bank, profile: &mut FeatureProfile<S>) {
        let steps = mem::take(&mut bank.steps);
        let mut sample = 0;
        for &step in &steps {
            let next = sample + step.sample(&self.ranges[sample..]);
            bank.draw(self.ranges, sample..next.min(self.last), self.lane, profile);
            if next >= self.last {
                break;
            }
            sample = next;
            if sample == 0 || step.is_late() {
                bank.apply(step);
            } else {
                profile.kinks[self.lane].push(self.kink(step, sample, bank));
            }
        }
        bank.steps = steps;
    }

    /// Applies a step between two samples; what it changes.
    fn kink<S: Real>(&self, step: Step, sample: usize, bank: &mut Bank) -> Kink<S> {
        let (near, far) = (self.ranges[sample - 1], self.ranges[sample]);
        let ([[height, along, across], after], idle) = (bank.around(step), bank.is_idle());
        bank.apply(step);
        Kink {
            sample,
            share: S::from_f64((step.range() - near) / (far - near)),
            range: step.range(),
            height: S::from_f64(height),
            before: [along, across].map(S::from_f64),
            after: [after[1], after[2]].map(S::from_f64),
            present: [!idle, !bank.is_idle()],
        }
    }
}
