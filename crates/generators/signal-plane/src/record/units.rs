//! Sub-generators and line generators one by one.

use std::array;

use control_plane::waveforms::Changes;
use feature_generator::{
    ChainScratch, FeatureGenerator, FeatureProfile, FeatureProgram, PartsFeatures, SubGeneratorPlace,
    UNIT_SIGNALS, place_of,
};
use hardware_model::ShadowParts;
use mixing_unit::{FeatureInput, Kink};
use parts::GateEdge;
use shadow_controller::{COMPARATORS, comparator_of};
use signal::{LANES, Probe, Real};

use super::inner::{Together, of_lane};
use super::{Recorded, sampled};
use crate::lane_gate::LaneGate;

impl<S: Real> Recorded<'_, S> {
    /// Height and presence of each sub-generator that `probe` wants: the block runs once more with that one alone.
    pub(super) fn sub_generators(&self, probe: &Probe, lane: usize, sweep: u32) -> Together {
        let mut all = Together::new();
        let wanted =
            UNIT_SIGNALS.chunks_exact(2).filter(|pair| pair.iter().any(|signal| probe.wants(signal)));
        for pair in wanted {
            let place = place_of(pair[0].name).filter(|_| self.group.blocks.features);
            let Some([height, present]) = place.and_then(|place| self.alone(place, lane, sweep)) else {
                continue;
            };
            all.insert(pair[0].name, sampled(height));
            all.insert(pair[1].name, sampled(present));
        }
        all
    }

    /// What one sub-generator puts out, and what its comparator answers; none if it draws nothing.
    fn alone(&self, place: SubGeneratorPlace, lane: usize, sweep: u32) -> Option<[Vec<f64>; 2]> {
        let Self { group, work, .. } = self;
        let (features, ranges) = (group.stage.landscape.features(), group.table.ranges());
        let own = work.features[lane].share_of(place, features);
        if own.loads.is_empty() {
            return None;
        }
        let mut programs: [FeatureProgram; LANES] = Default::default();
        programs[lane] = own;
        let (mut profile, mut chains) = (FeatureProfile::<S>::default(), ChainScratch::default());
        match &group.parts.features {
            None => FeatureGenerator { ranges }.run(features, &programs, &mut profile),
            Some(parts) => {
                let directions = group.directions(&group.sweeps(sweep - lane as u32));
                parts.run(features, ranges, &programs, &directions, &mut chains, &mut profile);
            }
        }
        Some([of_lane(&profile.height, lane), self.answered(&profile, &chains, lane)])
    }

    /// The presence line of a profile behind its comparator.
    fn answered(&self, profile: &FeatureProfile<S>, chains: &ChainScratch<S>, lane: usize) -> Vec<f64> {
        let Some(mixer) = &self.group.parts.mixer else { return of_lane(&profile.present, lane) };
        let kink = |kink: &feature_generator::Kink<S>| Kink {
            sample: kink.sample,
            share: kink.share,
            height: S::ZERO,
            feature: [S::ZERO; 2],
            terrain: S::ZERO,
            present: kink.present,
        };
        let kinks = array::from_fn(|lane| profile.kinks[lane].iter().map(kink).collect());
        let mut gates: [LaneGate<S>; LANES] = Default::default();
        gates[lane].follow(false, &chains.gates[lane], self.group.table.ranges());
        let lists = LaneGate::lists(&gates);
        let has_comparators = self.group.parts.features.as_ref().is_some_and(PartsFeatures::has_comparators);
        // The presence line asks for no light.
        let input = FeatureInput {
            height: &profile.height,
            present: &profile.present,
            reflectivity: &profile.present,
            lit: &profile.present,
            kinks: &kinks,
            gates: has_comparators.then_some(&lists),
        };
        mixer.presence(&input, lane)
    }

    /// Where the comparator behind a line generator answers; nothing of a machine that has none.
    pub(super) fn line_generator(&self, name: &str, lane: usize, sweep: u32) -> Changes {
        let mut changes = Changes::default();
        let Some(number) = comparator_of(name) else { return changes };
        let mut gate = LaneGate::<S>::default();
        gate.follow(false, &self.found_by(number, lane, sweep), self.group.table.ranges());
        let list = gate.list();
        let answers = match &self.group.parts.mixer {
            Some(mixer) => mixer.shadow_answers(&list),
            None => {
                list.toggles.iter().map(|toggle| toggle.sample as f64 - 1.0 + toggle.share.to_f64()).collect()
            }
        };
        answers.into_iter().for_each(|at| changes.push(at, 1.0));
        changes
    }

    /// Changes of the gate of a sweep that one line generator finds, ascending.
    fn found_by(&self, number: usize, lane: usize, sweep: u32) -> Vec<GateEdge> {
        let Self { group, .. } = self;
        let drawn = group.sweeps(sweep - lane as u32)[lane];
        let Some(gate) = group.delivery.gates.get(drawn as usize) else { return Vec::new() };
        let ShadowParts::Digital { line_generators } = group.stage.settings.shadow_controller else {
            return Vec::new();
        };
        // Of any number the first ones take turns.
        let told = COMPARATORS.len();
        let mut edges: Vec<GateEdge> = match &group.parts.lines {
            Some(lines) => {
                lines.answers(gate).filter(|(of, _)| of % told == number).map(|(_, edge)| edge).collect()
            }
            None => {
                let in_turn = line_generators.map_or(told, |count| count.max(1) as usize);
                let turns = gate.edges().enumerate().filter(|(n, _)| n % in_turn == number);
                turns.map(|(_, edge)| edge).collect()
            }
        };
        edges.sort_by(|a, b| a.range.total_cmp(&b.range));
        edges
    }
}
