//! Craters of a group: their loads, their profiles, their light.

use std::array;

use control_plane::{FeatureLoads, MachineStage};
use feature_generator::FeatureGenerator;
use landscape::SweepLight;
use signal::{LANES, Real};

use super::Group;
use crate::feature_light::Lamp;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    pub(super) fn draw_features(
        &self,
        first: u32,
        sweeps: &[u32; LANES],
        light: &[SweepLight; LANES],
        work: &mut Workspace<S>,
    ) {
        let MachineStage { landscape, settings, .. } = self.stage;
        let ranges = self.table.ranges();
        let ends: [f64; LANES] = array::from_fn(|lane| self.end_range(lane, work));
        self.find_craters(sweeps, ends.into_iter().fold(0.0, f64::max), &mut work.craters);
        let loads = self.loads_among(&work.craters);
        for (lane, &drawn) in sweeps.iter().enumerate() {
            loads.write([drawn, first + lane as u32], ends[lane], &mut work.features[lane]);
        }
        let profile = &mut work.feature_profile;
        match &self.parts.features {
            None => FeatureGenerator { ranges }.run(landscape.features(), &work.features, profile),
            Some(parts) => {
                let directions = self.directions(sweeps);
                let (features, chains) = (landscape.features(), &mut work.chains);
                parts.run(features, ranges, &work.features, &directions, chains, profile);
                for (gate, edges) in work.presence.iter_mut().zip(&chains.gates) {
                    gate.follow(false, edges, ranges);
                }
            }
        }
        if let Some(amplifiers) = &self.parts.amplifiers {
            amplifiers.drive_features(&self.directions(sweeps), profile, &mut work.amplifiers);
        }
        let lit = if self.parts.features.is_some() { &work.chains.lit } else { &profile.present };
        let lamp = Lamp { law: settings.laws.feature_light, light, ranges };
        lamp.run(&work.profile, profile, lit, &mut work.lit);
        if let Some(amplifiers) = &self.parts.amplifiers {
            amplifiers.drive_feature_light(
                &work.profile.reflectivity,
                lit,
                &mut work.lit,
                &mut work.amplifiers,
            );
        }
    }

    /// Words of features, of which only `craters` are in question.
    pub fn loads_among<'c>(&'c self, craters: &'c [u32]) -> FeatureLoads<'c> {
        let absent = &self.digital.absent_craters;
        FeatureLoads { stage: self.stage, table: self.clock, plan: self.plan, among: Some(craters), absent }
    }

    /// All craters that sweeps of the group can meet up to range `end` (m): the index is asked once a group.
    fn find_craters(&self, sweeps: &[u32; LANES], end: f64, found: &mut Vec<u32>) {
        let [left, right] = sweeps.iter().fold([u32::MAX, 0], |[l, r], &sweep| [l.min(sweep), r.max(sweep)]);
        let edges = [left, right].map(|sweep| self.plan.direction(sweep));
        let eye = [self.plan.eye[0], self.plan.eye[1]];
        self.stage.landscape.features().between(eye, edges, end, found);
    }
}
