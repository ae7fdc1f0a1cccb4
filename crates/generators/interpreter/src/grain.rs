//! What craters do to the gain of texture (section 13, report II.A): each adds its type's parameter, less 1, times how near the sweep
//! is to its centre.

use crate::composite::Samples;
use crate::loads::DrawnCrater;
use crate::parts::kit::Kit;
use crate::parts::sub_generator::{Passage, SubGeneratorFigures};
use crate::sweep::Walker;

impl Walker<'_> {
    /// What craters add at the samples that texture reaches; nothing where no crater type changes it.
    pub(crate) fn added_by_craters(
        &self,
        samples: &Samples<'_>,
        craters: &[DrawnCrater],
    ) -> Option<Vec<f64>> {
        let landscape = &self.scene.landscape;
        let (grain, texture) = (landscape.crater_grain()?, landscape.texture()?);
        let foot = [self.scene.eye[0], self.scene.eye[1]];
        let kit = Kit::of(self.scene, self.given);
        let limit = self.scene.settings.feature_generator.sub_generators;
        let each = craters.iter().map(|drawn| {
            let crater = landscape.features().crater(drawn.crater);
            let figures = if self.scene.settings.analog.features_are_ideal() {
                SubGeneratorFigures::default()
            } else {
                SubGeneratorFigures::of(&kit, crater.type_number(), drawn.sub_generator, limit)
            };
            let passage = Passage::of(&figures, &crater, foot, self.direction);
            (passage, grain.added(crater.type_number()), drawn.from)
        });
        let each: Vec<(Passage, f64, f64)> = each.collect();
        let reach = texture.grains().iter().map(|grain| grain.layer().range).fold(0.0, f64::max);
        let added = |range: &f64| -> f64 {
            let drawn = each.iter().filter(|(.., from)| range > from);
            drawn.map(|(passage, added, _)| added * passage.nearness(*range)).sum()
        };
        let ranges = &samples.ranges[..samples.ground.len()];
        Some(ranges.iter().take_while(|range| **range < reach).map(added).collect())
    }
}
