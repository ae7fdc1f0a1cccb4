//! Texture, gates and the mixing unit of a group.

use std::ops::Range;

use feature_generator::PartsFeatures;
use mixing_unit::{Composite, FeatureInput, Inputs, MixingUnit, ToggleList, terrain_alone};
use signal::{LANES, Real};
use texture_generator::{TextureGenerator, scale};

use super::Group;
use crate::lane_gate::LaneGate;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    /// Texture of the foreground, of the samples in `runs`; what craters add to its gain is found.
    pub fn draw_texture(&self, sweeps: &[u32; LANES], runs: &[Range<usize>], work: &mut Workspace<S>) {
        let Some(texture) = self.stage.landscape.texture() else { return };
        let directions = sweeps.map(|sweep| self.plan.direction(sweep));
        let eye = [self.plan.eye[0], self.plan.eye[1]];
        let generator = TextureGenerator { texture, ranges: self.table.ranges() };
        generator.run(eye, &directions, runs, &mut work.texture);
        match &self.parts.texture {
            Some(parts) => parts.run(&work.grain, &mut work.texture),
            None => scale(&work.grain, &mut work.texture),
        }
    }

    /// Gates of remote shadow, as places between samples.
    pub(super) fn set_gates(&self, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        for (lane_gate, &sweep) in work.shadow.iter_mut().zip(sweeps) {
            let Some(gate) = self.delivery.gates.get(sweep as usize) else {
                lane_gate.close();
                continue;
            };
            work.edges.clear();
            match &self.parts.lines {
                None => work.edges.extend(gate.edges()),
                Some(lines) => lines.displace(gate, &mut work.edges),
            }
            lane_gate.follow(gate.dark_at_start, &work.edges, self.table.ranges());
        }
    }

    /// Gates of the group as the mixing unit takes them: of remote shadow, and of the presence of features.
    pub fn toggle_lists<'w>(&self, work: &'w Workspace<S>) -> [[ToggleList<'w, S>; LANES]; 2] {
        [LaneGate::lists(&work.shadow), LaneGate::lists(&work.presence)]
    }

    /// What the generators send to the mixing unit.
    pub fn inputs<'w>(
        &self,
        work: &'w Workspace<S>,
        [shadow, presence]: &'w [[ToggleList<'w, S>; LANES]; 2],
    ) -> Inputs<'w, S> {
        let has_comparators = self.parts.features.as_ref().is_some_and(PartsFeatures::has_comparators);
        Inputs {
            height: &work.profile.height,
            reflectivity: &work.profile.reflectivity,
            features: self.blocks.features.then_some(FeatureInput {
                height: &work.feature_profile.height,
                present: &work.feature_profile.present,
                reflectivity: &work.lit.reflectivity,
                lit: match &self.parts.features {
                    None => &work.feature_profile.present,
                    Some(_) => &work.chains.lit,
                },
                kinks: &work.lit.kinks,
                gates: has_comparators.then_some(presence),
            }),
            shadow: (self.blocks.shadows.is_some() || self.blocks.all_switches).then_some(shadow),
            texture: (self.blocks.texture || self.blocks.all_switches).then_some(&work.texture),
        }
    }

    /// The mixing unit of the run.
    pub fn mixing_unit(&self) -> MixingUnit {
        let settings = &self.stage.settings;
        MixingUnit::new(&settings.mixing_unit, settings.laws.texture_in_shadow)
    }

    pub(super) fn mix(&self, work: &mut Workspace<S>) {
        if self.blocks.mixing {
            let (mut mixed, mut fades) = (std::mem::take(&mut work.mixed), std::mem::take(&mut work.fades));
            let lists = self.toggle_lists(work);
            let inputs = self.inputs(work, &lists);
            match &self.parts.mixer {
                Some(mixer) => mixer.run(&inputs, &mut fades, &mut mixed),
                None => self.mixing_unit().run(&inputs, &mut mixed),
            }
            (work.mixed, work.fades) = (mixed, fades);
            if let Some(amplifiers) = &self.parts.amplifiers {
                amplifiers.drive_mixed(&self.ends(work), &mut work.mixed, &mut work.amplifiers);
            }
        }
    }

    /// The composite landscape of a group that has been mixed.
    pub fn composite<'w>(&self, work: &'w Workspace<S>) -> Composite<'w, S> {
        if self.blocks.mixing {
            work.mixed.composite()
        } else {
            terrain_alone(&work.profile.height, &work.profile.reflectivity)
        }
    }
}
