//! Lines of a group: the write beam, and bodies over what it has written.

use display_projection_processor::Driven;
use hardware_model::{Gate, MixingParts};
use polyhedron_generator::{Hold, Overlay};
use signal::{LANES, Lanes, Real};
use sweep_memory::{Beam, BeamBreaks, Drive, FarStroke, Steps, write_group};

use super::Group;
use super::lights::LitSweep;
use crate::workspace::{ThirdSwitch, Workspace};

impl<S: Real> Group<'_, S> {
    pub(super) fn write(&self, work: &mut Workspace<S>, rows: &mut [f32]) {
        if let Some(beam) = &self.parts.beam {
            let far = self.behind(&work.far);
            let Driven { position, intensity, breaks, on, .. } = &work.driven;
            let breaks = breaks.iter().any(|breaks| !breaks.is_empty()).then_some(breaks);
            let drive = Drive { position, intensity, breaks, on, far };
            return beam.gun.write_stretches(&drive, &mut work.gun, rows);
        }
        let mut lines = std::mem::take(&mut work.lines);
        let breaks = self.walks_breaks(work).then_some(BeamBreaks {
            breaks: &work.mixed.breaks,
            bends: &work.mixed.bends,
            position: &work.projected.breaks.position,
            line: &work.projected.breaks.line,
        });
        let beam = Beam {
            position: &work.projected.position,
            line: &work.projected.line,
            entry: &work.projected.entry,
            intensity: self.composite(work).reflectivity,
            breaks,
            far: self.behind(&work.far),
        };
        self.write_beam(&beam, Steps::Curved, &mut lines, rows);
        work.lines = lines;
    }

    /// The ideal write beam.
    pub fn write_beam(
        &self,
        beam: &Beam<'_, S>,
        steps: Steps<'_>,
        lines: &mut Vec<Lanes<f32>>,
        rows: &mut [f32],
    ) {
        let rule = self.stage.settings.laws.pixel_rule;
        write_group(beam, steps, rule, self.raster.lines, lines, rows);
    }

    /// Mountains behind the last sample, if the landscape has any.
    pub fn behind<'w>(&self, far: &'w [Vec<FarStroke>; LANES]) -> Option<&'w [Vec<FarStroke>; LANES]> {
        (!self.stage.landscape.silhouettes().is_empty()).then_some(far)
    }

    /// What a memory of rounded words keeps of the lines.
    pub fn keep_words(&self, rows: &mut [f32]) {
        if let Some(words) = &self.parts.words {
            words.store(rows);
        }
    }

    /// VS3: polyhedra and light points over what the sweeps have written; `held` are lines of the held elevation, `far` mountains
    /// behind the last sample.
    pub fn overlay(
        &self,
        first: u32,
        (held, far): (&[Lanes<S>], &[Vec<FarStroke>; LANES]),
        third: &mut ThirdSwitch,
        rows: &mut [f32],
    ) {
        for (lane, row) in rows.chunks_exact_mut(self.raster.lines).enumerate() {
            let drawn = self.digital.drawn(first + lane as u32);
            let ThirdSwitch { overlay, body_fade, .. } = third;
            let has_bodies = self.compose_bodies(drawn, lane, held, overlay);
            if has_bodies {
                match &self.parts.bodies {
                    None => overlay.write(self.stage.settings.laws.pixel_rule, row),
                    Some(switch) => switch.write(overlay.runs(), body_fade, row),
                }
            }
            if let Some(table) = self.lights {
                let on = LitSweep { sweep: first + lane as u32, drawn, lane, has_bodies };
                self.lay_lights(table, on, (held, &far[lane]), third, row);
            }
        }
    }

    /// Finds what is seen of the bodies on a sweep; false if it meets none.
    pub fn compose_bodies(&self, sweep: u32, lane: usize, held: &[Lanes<S>], overlay: &mut Overlay) -> bool {
        let standing = self.delivery.polyhedra.table().sweep(sweep as usize);
        let held = |sample: usize| held[sample][lane].to_f64() as f32;
        let hold = Hold { near: self.near, lines: held };
        if !standing.is_empty() {
            overlay.compose(standing, self.stage.settings.laws.body_visibility, Some(&hold));
            let MixingParts { gate, threshold } = self.stage.settings.mixing_unit;
            if gate == Gate::SelfKeyed {
                overlay.key(threshold as f32);
            }
        }
        !standing.is_empty()
    }
}
