//! A group of sweeps drawn as a preview: signals at the samples alone, straight between them (economy `Instants`).
//!
//! ```text
//! TG ─▶ height, slopes ─▶ + FG ─▶ light ─▶ × lit part of the step, + texture, clip ─▶ DPP ─▶ SM, straight strokes ─▶ VS3
//! ```
//!
//! Words, registers, ramps and segments are those of the whole machine, so that a late word shows as it does there, and at every
//! sample height and slopes are the same to rounding, but for craters that cannot be told. What is not here: kinks of craters and
//! edges of shadow between two samples, curves between samples, a light of features apart from that of the terrain. One
//! surface is lit once. Where main signals have output amplifiers, terrain and features stay apart up to VS1 (`amplified.rs`).

mod amplified;

use control_plane::FeatureLoads;
use std::array;
use std::ops::Range;

use feature_generator::{FeatureGenerator, Surface};
use landscape::GroupLight;
use signal::{LANES, Real, Stretches};
use sweep_memory::{Beam, Steps};

use crate::group::Group;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    /// Runs a group as [`run`](Self::run) does, but with signals at the samples alone.
    pub fn run_preview(&self, first: u32, work: &mut Workspace<S>, rows: &mut [f32]) {
        let sweeps = self.sweeps(first);
        let deflection = sweeps.map(|sweep| self.deflection(sweep));
        for ((far, &sweep), deflection) in work.far.iter_mut().zip(&sweeps).zip(&deflection) {
            self.find_silhouettes(sweep, deflection, far);
        }
        self.trace_terrain(first, &sweeps, work);
        match &self.parts.amplifiers {
            None => {
                self.lay_features(first, &sweeps, work);
                self.processor.look(&work.profile.height, &deflection, self.raster.lines, &mut work.sight);
                self.light_what_is_seen(&sweeps, work);
            }
            Some(amplifiers) => {
                self.join_by_amplifiers(amplifiers, first, &sweeps, work);
                self.processor.look(&work.profile.height, &deflection, self.raster.lines, &mut work.sight);
            }
        }
        self.write_preview(work, rows);
        let Workspace { sight, third, far, .. } = work;
        self.overlay(first, (&sight.line, far), third, rows);
        self.keep_words(rows);
    }

    fn write_preview(&self, work: &mut Workspace<S>, rows: &mut [f32]) {
        let mut lines = std::mem::take(&mut work.lines);
        let Workspace { sight, profile, .. } = &*work;
        let beam = Beam {
            // In sight the profile is where it is held, and straight strokes ask for no more.
            position: &sight.line,
            line: &sight.line,
            entry: &sight.entry,
            intensity: &profile.reflectivity,
            breaks: None,
            far: self.behind(&work.far),
        };
        self.write_beam(&beam, Steps::Straight(&sight.runs), &mut lines, rows);
        work.lines = lines;
    }

    /// From the profile of the terrain to that of the composite landscape, in the same place.
    fn lay_features(&self, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        if self.blocks.features {
            self.find_passings(first, sweeps, work);
            let Workspace { profile, passings, .. } = work;
            let generator = FeatureGenerator { ranges: self.table.ranges() };
            let surface = Surface {
                height: &mut profile.height,
                along: &mut profile.along,
                across: &mut profile.across,
            };
            let place = |range| self.table.place(range);
            generator.lay(self.stage.landscape.features(), passings, place, surface);
        }
    }

    /// Light, texture and shadow of the samples that anybody sees.
    fn light_what_is_seen(&self, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        let runs = std::mem::take(&mut work.sight.runs);
        self.light_surface(sweeps, &runs, work);
        self.mix_preview(sweeps, &runs, work);
        work.sight.runs = runs;
    }

    /// Which craters each sweep draws.
    fn find_passings(&self, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        self.delivery.craters.of(sweeps, &mut work.craters);
        let ends = array::from_fn(|lane| self.end_range(lane, work));
        if FeatureLoads::is_limited(self.stage) {
            let loads = self.loads_among(&work.craters);
            for (lane, &drawn) in sweeps.iter().enumerate() {
                loads.write([drawn, first + lane as u32], ends[lane], &mut work.features[lane]);
            }
            return work.passings.follow(&work.features);
        }
        let (features, span) = (self.stage.landscape.features(), (self.table.ranges()[0], ends));
        let eye = [self.plan.eye[0], self.plan.eye[1]];
        work.passings.find(features, &work.craters, eye, &self.directions(sweeps), span);
    }

    /// Light of the samples in `runs`; a stage of parts lights all, because its parts remember what nobody sees.
    fn light_surface(&self, sweeps: &[u32; LANES], runs: &[Range<usize>], work: &mut Workspace<S>) {
        let light = self.light(sweeps);
        if let Some(stage) = self.parts.light() {
            return self.light_by(stage, sweeps, &light, work);
        }
        let (terrain, light) = (self.terrain(self.stage.landscape.level()), GroupLight::new(&light));
        for run in runs {
            terrain.reflect(&light, run.clone(), &mut work.profile);
        }
    }

    /// Of the samples in `runs`; nothing is known of what the others then hold.
    fn mix_preview(&self, sweeps: &[u32; LANES], runs: &[Range<usize>], work: &mut Workspace<S>) {
        if !self.blocks.mixing {
            return;
        }
        if self.blocks.texture {
            self.find_passing_grain(work);
            self.draw_texture(sweeps, runs, work);
        }
        let texture = if self.blocks.texture { work.texture.as_slice() } else { &[] };
        let dark = self.blocks.shadows.is_some().then(|| {
            self.find_dark(sweeps, &mut work.dark);
            &work.dark
        });
        self.mixing_unit().run_preview(dark, texture, runs, &mut work.profile.reflectivity);
    }

    /// Stretches of remote shadow on the sweep clock.
    fn find_dark(&self, sweeps: &[u32; LANES], dark: &mut Stretches) {
        let (before, beyond) = (-0.5, self.table.ranges().len() as f64 - 0.5);
        for (stretches, &sweep) in dark.iter_mut().zip(sweeps) {
            stretches.clear();
            let Some(gate) = self.delivery.gates.get(sweep as usize) else { continue };
            let mut begin = gate.dark_at_start.then_some(before);
            for at in gate.toggles.iter().map(|&range| self.table.place(range)) {
                match begin.take() {
                    None => begin = Some(at),
                    Some(begin) => stretches.push([begin, at]),
                }
                if at == beyond {
                    break;
                }
            }
            stretches.extend(begin.map(|begin| [begin, beyond]));
            stretches.retain(|[begin, end]| begin < end);
        }
    }
}
