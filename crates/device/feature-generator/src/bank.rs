//! The bank of sub-generators while a sweep runs.

use std::ops::Range;

use features::Features;
use signal::Real;

use crate::steps::{Step, collect};
use crate::sub_generator::{SubGenerator, Zone};
use crate::{FeatureProfile, FeatureProgram};

/// All sub-generators that a sweep uses, load by load, and those that are in a footprint now.
#[derive(Debug, Clone, Default)]
pub(crate) struct Bank {
    sub_generators: Vec<SubGenerator>,
    /// Number of the load and zone, ascending in the load: the order of the sum.
    at_work: Vec<(u32, Zone)>,
    /// Changes of zone of the whole sweep.
    pub steps: Vec<Step>,
}

impl Bank {
    /// Takes over the loads of a sweep.
    pub fn load(&mut self, program: &FeatureProgram, features: &Features) {
        self.sub_generators.clear();
        self.at_work.clear();
        self.steps.clear();
        for (number, load) in (0..).zip(&program.loads) {
            let crater = &features.crater(load.crater);
            self.sub_generators.push(SubGenerator::new(crater, load));
            collect(crater, load, number, &mut self.steps);
        }
        self.steps.sort_unstable();
    }

    /// Whether the sweep is in no footprint.
    pub fn is_idle(&self) -> bool {
        self.at_work.is_empty()
    }

    /// Sets the sub-generator of a step to its new zone.
    pub fn apply(&mut self, step: Step) {
        let (at_work, load, [_, to]) = (&mut self.at_work, step.load(), step.zones());
        match (at_work.binary_search_by_key(&load, |(load, _)| *load), to) {
            (Ok(place), Zone::Outside) => {
                at_work.remove(place);
            }
            (Ok(place), zone) => at_work[place].1 = zone,
            (Err(place), zone) => at_work.insert(place, (load, zone)),
        }
    }

    /// Height, slope along and slope across where a step lies, just before it and just after it: all sub-generators but its
    /// own answer once for both.
    pub fn around(&self, step: Step) -> [[f64; 3]; 2] {
        let (range, crossed, [_, to]) = (step.range(), step.load(), step.zones());
        let mut sums = [[0.0; 3]; 2];
        let mut add = |load: u32, zone: Zone, sides: Range<usize>| {
            let one = self.sub_generators[load as usize].at(zone, range);
            sums[sides].iter_mut().for_each(|sum| (0..3).for_each(|signal| sum[signal] += one[signal]));
        };
        let place = self.at_work.partition_point(|(load, _)| *load < crossed);
        let (lower, own) = self.at_work.split_at(place);
        let upper = own.iter().position(|(load, _)| *load > crossed).unwrap_or(own.len());
        let (own, upper) = own.split_at(upper);
        lower.iter().for_each(|&(load, zone)| add(load, zone, 0..2));
        own.iter().for_each(|&(load, zone)| add(load, zone, 0..1));
        add(crossed, to, 1..2);
        upper.iter().for_each(|&(load, zone)| add(load, zone, 0..2));
        sums
    }

    /// Adds what is at work to samples of a lane.
    pub fn draw<S: Real>(
        &self,
        ranges: &[f64],
        samples: Range<usize>,
        lane: usize,
        profile: &mut FeatureProfile<S>,
    ) {
        if self.is_idle() || samples.is_empty() {
            return;
        }
        profile.present[samples.clone()].iter_mut().for_each(|sample| sample[lane] = S::ONE);
        let mut surface = profile.surface();
        for &(load, zone) in &self.at_work {
            self.sub_generators[load as usize].add(zone, ranges, samples.clone(), lane, &mut surface);
        }
    }
}
