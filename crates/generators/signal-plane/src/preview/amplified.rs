//! The same where main signals have output amplifiers: what leaves a generator stays apart until the mixing unit joins it.

use feature_generator::FeatureGenerator;
use landscape::SweepLight;
use signal::{LANES, Real};

use crate::feature_light::Lamp;
use crate::group::Group;
use crate::output_amplifiers::OutputAmplifiers;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    /// From the profiles of the generators to the composite landscape, in `work.profile`.
    pub(super) fn join_by_amplifiers(
        &self,
        amplifiers: &OutputAmplifiers<S>,
        first: u32,
        sweeps: &[u32; LANES],
        work: &mut Workspace<S>,
    ) {
        let (light, directions, ends) = (self.light(sweeps), self.directions(sweeps), self.ends(work));
        amplifiers.drive_terrain(&directions, &ends, &mut work.profile);
        // An amplifier remembers what nobody sees.
        let all = 0..self.table.ranges().len();
        let all = std::slice::from_ref(&all);
        self.light_surface(sweeps, all, work);
        amplifiers.drive_terrain_light(&mut work.profile);
        if self.blocks.features {
            self.find_passings(first, sweeps, work);
            let generator = FeatureGenerator { ranges: self.table.ranges() };
            let (features, place) = (self.stage.landscape.features(), |range| self.table.place(range));
            generator.lay_apart(features, &work.passings, place, &mut work.feature_profile);
            amplifiers.drive_preview_features(&directions, &mut work.feature_profile);
            self.light_features(amplifiers, &light, work);
            self.lay_on_terrain(work);
        }
        self.mix_preview(sweeps, all, work);
        amplifiers.drive_preview(&ends, &mut work.profile);
    }

    fn light_features(
        &self,
        amplifiers: &OutputAmplifiers<S>,
        light: &[SweepLight; LANES],
        work: &mut Workspace<S>,
    ) {
        let Workspace { profile, feature_profile, lit, .. } = work;
        let lamp = Lamp { law: self.stage.settings.laws.feature_light, light, ranges: self.table.ranges() };
        lamp.run(profile, feature_profile, &feature_profile.present, lit);
        let present = &feature_profile.present;
        amplifiers.drive_feature_light(&profile.reflectivity, present, lit, &mut work.amplifiers);
    }

    /// VS1 and the height summer.
    fn lay_on_terrain(&self, work: &mut Workspace<S>) {
        let Workspace { profile, feature_profile, lit, .. } = work;
        for (height, &feature) in profile.height.iter_mut().zip(&feature_profile.height) {
            *height = *height + feature;
        }
        let vs1 = self.mixing_unit().vs1;
        vs1.run(&lit.reflectivity, &feature_profile.present, &mut profile.reflectivity);
    }
}
