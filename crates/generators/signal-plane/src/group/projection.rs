//! Projection and silhouettes of a group.

use std::array;

use display_projection_processor::{BrokenProfile, Deflection};
use mixing_unit::Composite;
use signal::{LANES, Real};
use sweep_memory::FarStroke;

use super::Group;
use crate::real_parts::BeamParts;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    /// From tangents to lines.
    pub fn deflection(&self, sweep: u32) -> Deflection {
        let tangent = self.plan.fan.tangent(sweep);
        Deflection::new(self.stage.settings.laws.projection, self.plan.pitch, tangent)
            .in_lines(self.raster.lines as f64, self.raster.field.tan_half_height)
    }

    pub(super) fn project(&self, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        let deflection = sweeps.map(|sweep| self.deflection(sweep));
        for ((far, &sweep), deflection) in work.far.iter_mut().zip(sweeps).zip(&deflection) {
            self.find_silhouettes(sweep, deflection, far);
        }
        if let Some(beam) = &self.parts.beam {
            return self.drive(beam, first, &deflection, work);
        }
        let height = if self.blocks.mixing { &work.mixed.height } else { &work.profile.height };
        if self.walks_breaks(work) {
            let broken = BrokenProfile { breaks: &work.mixed.breaks, bends: &work.mixed.bends };
            self.processor.run_broken(height, broken, &deflection, &mut work.projected);
        } else {
            self.processor.run(height, &deflection, &mut work.projected);
        }
    }

    pub(super) fn walks_breaks(&self, work: &Workspace<S>) -> bool {
        self.blocks.mixing && (self.blocks.breaks || work.mixed.has_breaks())
    }

    /// The processor of parts; what it drives stands where the ideal one's signals do.
    fn drive(
        &self,
        beam: &BeamParts<S>,
        first: u32,
        deflection: &[Deflection; LANES],
        work: &mut Workspace<S>,
    ) {
        let address = self.address(first);
        let sweeps = array::from_fn(|lane| address + lane as u64);
        let (mut driven, mut chain) = (std::mem::take(&mut work.driven), std::mem::take(&mut work.chain));
        let Composite { height, reflectivity } = self.composite(work);
        let video = (reflectivity, &work.mixed.breaks);
        beam.processor.run(height, video, deflection, &sweeps, &mut chain, &mut driven);
        let projected = &mut work.projected;
        projected.elevation.clone_from(&driven.elevation);
        projected.hold.clone_from(&driven.hold);
        projected.position.clone_from(&driven.position);
        projected.line.clone_from(&driven.line);
        (work.driven, work.chain) = (driven, chain);
    }

    /// Mountains of which only the outline is stored, where the sweep meets them (section 8).
    pub fn find_silhouettes(&self, sweep: u32, deflection: &Deflection, far: &mut Vec<FarStroke>) {
        far.clear();
        let silhouettes = self.stage.landscape.silhouettes();
        if silhouettes.is_empty() {
            return;
        }
        let [north, east] = self.plan.direction(sweep);
        let azimuth = libm::atan2(east, north);
        far.extend(silhouettes.iter().filter_map(|silhouette| {
            let line = deflection.at(silhouette.tangent(azimuth)?) as f32;
            Some(FarStroke { line, intensity: silhouette.reflectivity() as f32 })
        }));
    }
}
