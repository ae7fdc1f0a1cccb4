//! The analog side of a group of sweeps: the generators, MU, DPP, SM in the order of section 24.

use control_plane::{
    Blocks, Coarse, Crossings, Delivery, DigitalFrame, FeatureLoads, FramePlan, MachineStage, WrittenRaster,
};
use std::array;
use std::ops::Range;
use std::slice;

use display_projection_processor::{BrokenProfile, Deflection, Driven, Processor};
use feature_generator::{FeatureGenerator, PartsGenerator};
use hardware_model::{Gate, MixingParts};
use landscape::{GroupLight, Level, SweepLight};
use mixing_unit::{Composite, FeatureInput, Inputs, MixingUnit, ToggleList, terrain_alone};
use parts::LagStep;
use polyhedron_generator::{BodyFade, Hold, NearTable, Overlay};
use signal::{LANES, Lanes, Real};
use sweep_generator::RangeTable;
use sweep_memory::{Beam, BeamBreaks, Drive, FarStroke, Steps, write_group};
use terrain_generator::{ArrayState, ModifiedTerrainGenerator, PartsArray, TerrainGenerator, Wired};
use texture_generator::TextureGenerator;

use crate::feature_light::Lamp;
use crate::lane_gate::LaneGate;
use crate::real_parts::{BeamParts, RealParts, Terrain};
use crate::wires::Ends;
use crate::workspace::Workspace;

/// Everything that the groups of a frame share.
#[derive(Debug, Clone, Copy)]
pub struct Group<'a, S> {
    /// Ground, scenery and settings.
    pub stage: &'a MachineStage,
    /// Blocks that are there.
    pub blocks: &'a Blocks,
    /// The ground-range programme.
    pub table: &'a RangeTable,
    /// Inverse range of each sample (1/m).
    pub near: &'a NearTable,
    /// The ideal projection processor.
    pub processor: &'a Processor<S>,
    /// Raster that the sweeps write.
    pub raster: WrittenRaster,
    /// Fan, eye and sun of the frame.
    pub plan: &'a FramePlan,
    /// What the I/O processors have brought.
    pub delivery: &'a Delivery,
    /// Set-ups and corners that are ready.
    pub digital: &'a DigitalFrame,
    /// Blocks made of parts.
    pub parts: &'a RealParts<S>,
}

impl<S: Real> Group<'_, S> {
    /// Runs the group that begins at sweep `first` and leaves its lines in `rows`, one stretch a sweep.
    pub fn run(&self, first: u32, work: &mut Workspace<S>, rows: &mut [f32]) {
        let sweeps = self.sweeps(first);
        let light = self.light(&sweeps);
        self.draw_terrain(first, &sweeps, &light, work);
        if self.blocks.features {
            self.draw_features(first, &sweeps, &light, work);
        }
        if self.blocks.texture {
            let all = 0..self.table.ranges().len();
            self.draw_texture(&sweeps, slice::from_ref(&all), work);
        }
        self.set_gates(&sweeps, work);
        self.mix(work);
        self.project(first, &sweeps, work);
        self.write(work, rows);
        let Workspace { projected, overlay, body_fade, .. } = work;
        self.overlay(first, &projected.line, (overlay, body_fade), rows);
    }

    /// Set-ups of the sweeps of a group. Lanes beyond the last sweep repeat it; nothing of them is kept.
    pub fn sweeps(&self, first: u32) -> [u32; LANES] {
        let last = self.plan.fan.sweeps - 1;
        array::from_fn(|lane| self.digital.drawn((first + lane as u32).min(last)))
    }

    /// Light on each.
    pub fn light(&self, sweeps: &[u32; LANES]) -> [SweepLight; LANES] {
        let (landscape, sun) = (&self.stage.landscape, &self.plan.sun);
        sweeps.map(|sweep| {
            let direction = self.plan.direction(sweep);
            SweepLight::new(sun, landscape.albedo(), *landscape.photometry(), direction)
        })
    }

    /// The terrain generator of a level, set for the frame.
    pub fn terrain<'l>(&'l self, level: &'l Level) -> TerrainGenerator<'l> {
        TerrainGenerator {
            buffer: level.words(),
            region_size: level.region_size(),
            ranges: self.table.ranges(),
            datum: self.plan.eye[2],
        }
    }

    fn draw_terrain(
        &self,
        first: u32,
        sweeps: &[u32; LANES],
        light: &[SweepLight; LANES],
        work: &mut Workspace<S>,
    ) {
        self.trace_terrain(first, sweeps, work);
        let fine = self.terrain(self.stage.landscape.level());
        if let Some(wires) = &self.parts.wires {
            wires.drive_terrain(&self.directions(sweeps), &self.ends(work), &mut work.profile);
        }
        fine.reflect(&GroupLight::new(light), 0..self.table.ranges().len(), &mut work.profile);
        if let Some(Terrain { reflectivity: Some(lag), .. }) = &self.parts.terrain {
            delay(lag, &mut work.profile.reflectivity);
        }
        if let Some(wires) = &self.parts.wires {
            wires.drive_terrain_light(&mut work.profile);
        }
    }

    /// Height and slopes of the terrain.
    pub fn trace_terrain(&self, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        for (lane, program) in work.programs.iter_mut().enumerate() {
            self.crossings().write_fine([sweeps[lane], first + lane as u32], program, &mut ());
        }
        let fine = self.terrain(self.stage.landscape.level());
        match (&self.blocks.coarse, &self.parts.terrain) {
            (None, None) => fine.trace_by(&mut work.polynomials[0], &work.programs, &mut work.profile),
            (None, Some(parts)) => {
                let mut wired = self.wired(&parts.fine, first, &mut work.arrays[0]);
                fine.trace_by(&mut wired, &work.programs, &mut work.profile);
            }
            (Some(coarse), _) => self.draw_both_levels(coarse, first, sweeps, work),
        }
    }

    /// Directions of the sweeps over the ground: north, east.
    pub fn directions(&self, sweeps: &[u32; LANES]) -> [[f64; 2]; LANES] {
        sweeps.map(|sweep| self.plan.direction(sweep))
    }

    /// First samples beyond the profiles of the group.
    pub fn ends(&self, work: &Workspace<S>) -> Ends {
        array::from_fn(|lane| {
            let end = self.end_range(lane, work);
            self.table.ranges().partition_point(|&range| range <= end)
        })
    }

    /// The array of parts for the group that begins at sweep `first`.
    pub fn wired<'w>(
        &self,
        array: &'w PartsArray<S>,
        first: u32,
        state: &'w mut ArrayState<S>,
    ) -> Wired<'w, S> {
        Wired { array, state, address: self.address(first) }
    }

    fn crossings(&self) -> Crossings<'_> {
        Crossings {
            stage: self.stage,
            coarse: self.blocks.coarse.as_ref(),
            table: self.table,
            plan: self.plan,
            missing: self.digital.missing(),
            held: &self.digital.held,
        }
    }

    fn draw_both_levels(&self, coarse: &Coarse, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        let landscape = &self.stage.landscape;
        for (lane, program) in work.coarse.iter_mut().enumerate() {
            self.crossings().write_coarse(coarse, [sweeps[lane], first + lane as u32], program, &mut ());
        }
        let generator = ModifiedTerrainGenerator {
            fine: self.terrain(landscape.level()),
            coarse: self.terrain(&landscape.bank().levels()[1]),
            blend: coarse.switch.blend,
        };
        let ranges = work.programs.each_ref().map(|program| program.end_range);
        let (profile, overlap) = (&mut work.profile, &mut work.overlap);
        work.step = match &self.parts.terrain {
            Some(Terrain { fine, coarse: Some(far), .. }) => {
                let [near_state, far_state] = &mut work.arrays;
                let methods =
                    [&mut self.wired(fine, first, near_state), &mut self.wired(far, first, far_state)];
                generator.trace_by(methods, &work.programs, &work.coarse, &ranges, profile, overlap)
            }
            _ => {
                let methods = work.polynomials.each_mut();
                generator.trace_by(methods, &work.programs, &work.coarse, &ranges, profile, overlap)
            }
        };
    }

    /// Ground range at which the profile of a lane ends (m).
    pub fn end_range(&self, lane: usize, work: &Workspace<S>) -> f64 {
        let fine = work.programs[lane].end_range;
        if self.blocks.coarse.is_some() { work.coarse[lane].end_range.max(fine) } else { fine }
    }

    fn draw_features(
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
        if let Some(wires) = &self.parts.wires {
            wires.drive_features(&self.directions(sweeps), profile, &mut work.wires);
        }
        let lit = if self.parts.features.is_some() { &work.chains.lit } else { &profile.present };
        let lamp = Lamp { law: settings.laws.feature_light, light, ranges };
        lamp.run(&work.profile, profile, lit, &mut work.lit);
        if let Some(wires) = &self.parts.wires {
            wires.drive_feature_light(&work.profile.reflectivity, lit, &mut work.lit, &mut work.wires);
        }
    }

    /// Words of features, of which only `craters` are in question.
    pub fn loads_among<'c>(&'c self, craters: &'c [u32]) -> FeatureLoads<'c> {
        FeatureLoads { stage: self.stage, table: self.table, plan: self.plan, among: Some(craters) }
    }

    /// All craters that sweeps of the group can meet up to range `end` (m): the index is asked once a group.
    fn find_craters(&self, sweeps: &[u32; LANES], end: f64, found: &mut Vec<u32>) {
        let [left, right] = sweeps.iter().fold([u32::MAX, 0], |[l, r], &sweep| [l.min(sweep), r.max(sweep)]);
        let edges = [left, right].map(|sweep| self.plan.direction(sweep));
        let eye = [self.plan.eye[0], self.plan.eye[1]];
        self.stage.landscape.features().between(eye, edges, end, found);
    }

    /// Texture of the foreground, of the samples in `runs`.
    pub fn draw_texture(&self, sweeps: &[u32; LANES], runs: &[Range<usize>], work: &mut Workspace<S>) {
        let Some(texture) = self.stage.landscape.texture() else { return };
        let directions = sweeps.map(|sweep| self.plan.direction(sweep));
        let eye = [self.plan.eye[0], self.plan.eye[1]];
        let generator = TextureGenerator { texture, ranges: self.table.ranges() };
        generator.run(eye, &directions, runs, &mut work.texture);
        if let Some(parts) = &self.parts.texture {
            parts.run(&mut work.texture);
        }
    }

    /// Gates of remote shadow, as places between samples.
    fn set_gates(&self, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
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
        let has_comparators = self.parts.features.as_ref().is_some_and(PartsGenerator::has_comparators);
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

    fn mix(&self, work: &mut Workspace<S>) {
        if self.blocks.mixing {
            let (mut mixed, mut fades) = (std::mem::take(&mut work.mixed), std::mem::take(&mut work.fades));
            let lists = self.toggle_lists(work);
            let inputs = self.inputs(work, &lists);
            match &self.parts.mixer {
                Some(mixer) => mixer.run(&inputs, &mut fades, &mut mixed),
                None => self.mixing_unit().run(&inputs, &mut mixed),
            }
            (work.mixed, work.fades) = (mixed, fades);
            if let Some(wires) = &self.parts.wires {
                wires.drive_mixed(&self.ends(work), &mut work.mixed, &mut work.wires);
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

    /// From tangents to lines.
    pub fn deflection(&self, sweep: u32) -> Deflection {
        let tangent = self.plan.fan.tangent(sweep);
        Deflection::new(self.stage.settings.laws.projection, self.plan.pitch, tangent)
            .in_lines(self.raster.lines as f64, self.raster.field.tan_half_height)
    }

    fn project(&self, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
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

    fn walks_breaks(&self, work: &Workspace<S>) -> bool {
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

    /// Number of a sweep over all frames: noise goes by it.
    fn address(&self, sweep: u32) -> u64 {
        self.plan.frame * u64::from(self.stage.settings.raster.sweeps) + u64::from(sweep)
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

    fn write(&self, work: &mut Workspace<S>, rows: &mut [f32]) {
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

    /// VS3: polyhedra over what the sweeps have written; `held` are lines of the held elevation.
    pub fn overlay(
        &self,
        first: u32,
        held: &[Lanes<S>],
        (overlay, fade): (&mut Overlay, &mut BodyFade),
        rows: &mut [f32],
    ) {
        for (lane, row) in rows.chunks_exact_mut(self.raster.lines).enumerate() {
            let drawn = self.digital.drawn(first + lane as u32);
            if self.compose_bodies(drawn, lane, held, overlay) {
                match &self.parts.bodies {
                    None => overlay.write(self.stage.settings.laws.pixel_rule, row),
                    Some(switch) => switch.write(overlay.runs(), fade, row),
                }
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

/// Passes a signal through a lag that is at rest as the sweep begins.
fn delay<S: Real>(lag: &LagStep<S>, signal: &mut [Lanes<S>]) {
    let Some(&first) = signal.first() else { return };
    let (mut before, mut out) = (first, first);
    for value in signal {
        out = lag.step(out, before, *value);
        before = std::mem::replace(value, out);
    }
}
