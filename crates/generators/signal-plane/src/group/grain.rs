//! What the craters of a group add to the gain of texture.

use feature_generator::FeatureGenerator;
use landscape::Texture;
use signal::{LANES, Real};

use super::Group;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    /// By the programs of the feature generator.
    pub(super) fn find_grain(&self, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        let Some(parts) = &self.parts.features else {
            if self.textured().is_some() {
                work.passings.follow(&work.features);
            }
            return self.find_passing_grain(work);
        };
        work.grain.clear();
        let Some((ranges, added)) = self.textured() else { return };
        let (features, directions) = (self.stage.landscape.features(), self.directions(sweeps));
        parts.grain(features, ranges, &work.features, &directions, added, &mut work.grain);
    }

    /// By the craters that the sweeps pass.
    pub(crate) fn find_passing_grain(&self, work: &mut Workspace<S>) {
        work.grain.clear();
        let Some((ranges, added)) = self.textured() else { return };
        let features = self.stage.landscape.features();
        FeatureGenerator { ranges }.grain(features, &work.passings, added, &mut work.grain);
    }

    /// Ranges of the samples that texture reaches, and what a crater of a type adds to its gain, if craters add anything.
    fn textured(&self) -> Option<(&[f64], impl Fn(u32) -> f64)> {
        let landscape = &self.stage.landscape;
        let grain = landscape.crater_grain().filter(|_| self.blocks.features)?;
        let (ranges, reach) = (self.table.ranges(), landscape.texture().map_or(0.0, Texture::reach));
        let samples = ranges.partition_point(|&range| range < reach);
        Some((&ranges[..samples], |kind| grain.added(kind)))
    }
}
