//! Terrain of a group: programs, profiles of both levels, light.

use control_plane::Coarse;
use landscape::{GroupLight, SweepLight};
use parts::LagStep;
use signal::{LANES, Lanes, Real};
use sweep_program::SweepProgram;
use terrain_generator::{
    ArrayState, LitGroup, ModifiedTerrainGenerator, PartsArray, PartsLight, PartsTerrain,
};

use super::Group;
use crate::output_amplifiers::Ends;
use crate::real_parts::Terrain;
use crate::workspace::Workspace;

impl<S: Real> Group<'_, S> {
    pub(super) fn draw_terrain(
        &self,
        first: u32,
        sweeps: &[u32; LANES],
        light: &[SweepLight; LANES],
        work: &mut Workspace<S>,
    ) {
        self.trace_terrain(first, sweeps, work);
        if let Some(amplifiers) = &self.parts.amplifiers {
            amplifiers.drive_terrain(&self.directions(sweeps), &self.ends(work), &mut work.profile);
        }
        match self.parts.light() {
            None => {
                let fine = self.terrain(self.stage.landscape.level());
                fine.reflect(&GroupLight::new(light), 0..self.table.ranges().len(), &mut work.profile);
            }
            Some(stage) => self.light_by(stage, sweeps, light, work),
        }
        if let Some(Terrain { reflectivity: Some(lag), .. }) = &self.parts.terrain {
            delay(lag, &mut work.profile.reflectivity);
        }
        if let Some(amplifiers) = &self.parts.amplifiers {
            amplifiers.drive_terrain_light(&mut work.profile);
        }
    }

    /// Light of the slopes in `work`, by a stage of parts.
    pub fn light_by(
        &self,
        stage: &PartsLight,
        sweeps: &[u32; LANES],
        light: &[SweepLight; LANES],
        work: &mut Workspace<S>,
    ) {
        let (directions, ends) = (self.directions(sweeps), self.ends(work));
        stage.run(&self.lit_group(light, &directions, &ends), &mut work.profile);
    }

    /// What a stage of parts is set to for a group.
    pub fn lit_group<'l>(
        &'l self,
        light: &'l [SweepLight; LANES],
        directions: &'l [[f64; 2]; LANES],
        ends: &'l Ends,
    ) -> LitGroup<'l> {
        LitGroup { sun: self.plan.sun.direction(), light, directions, ends, ranges: self.table.ranges() }
    }

    /// Height and slopes of the terrain.
    pub fn trace_terrain(&self, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        for (lane, program) in work.programs.iter_mut().enumerate() {
            self.crossings().write_fine([sweeps[lane], first + lane as u32], program, &mut ());
            self.see(program);
        }
        let fine = self.terrain(self.stage.landscape.level());
        match (&self.blocks.coarse, &self.parts.terrain) {
            (None, None) => fine.trace_by(&mut work.polynomials[0], &work.programs, &mut work.profile),
            (None, Some(parts)) => {
                let mut method = self.parts_terrain(&parts.fine, first, &mut work.arrays[0]);
                fine.trace_by(&mut method, &work.programs, &mut work.profile);
            }
            (Some(coarse), _) => self.draw_both_levels(coarse, first, sweeps, work),
        }
    }

    /// Folds and arrivals of a program at the samples of the group.
    fn see(&self, program: &mut SweepProgram) {
        if self.instants > 1 {
            program.see_at(self.instants);
        }
    }

    /// The array of parts for the group that begins at sweep `first`.
    pub fn parts_terrain<'w>(
        &self,
        array: &'w PartsArray<S>,
        first: u32,
        state: &'w mut ArrayState<S>,
    ) -> PartsTerrain<'w, S> {
        PartsTerrain { array, state, address: self.address(first) }
    }

    fn draw_both_levels(&self, coarse: &Coarse, first: u32, sweeps: &[u32; LANES], work: &mut Workspace<S>) {
        let landscape = &self.stage.landscape;
        for (lane, program) in work.coarse.iter_mut().enumerate() {
            self.crossings().write_coarse(coarse, [sweeps[lane], first + lane as u32], program, &mut ());
            self.see(program);
        }
        let generator = ModifiedTerrainGenerator {
            fine: self.terrain(landscape.level()),
            coarse: self.terrain(&landscape.bank().levels()[1]),
            blend: self.plan.switch.blend,
            weight: self.stage.settings.analog.level_blend.weight,
            slope_term: self.stage.settings.analog.level_blend.slope_term,
        };
        let ranges = work.programs.each_ref().map(|program| program.end_range);
        let (profile, overlap) = (&mut work.profile, &mut work.overlap);
        work.step = match &self.parts.terrain {
            Some(Terrain { fine, coarse: Some(far), .. }) => {
                let [near_state, far_state] = &mut work.arrays;
                let methods = [
                    &mut self.parts_terrain(fine, first, near_state),
                    &mut self.parts_terrain(far, first, far_state),
                ];
                generator.trace_by(methods, &work.programs, &work.coarse, &ranges, profile, overlap)
            }
            _ => {
                let methods = work.polynomials.each_mut();
                generator.trace_by(methods, &work.programs, &work.coarse, &ranges, profile, overlap)
            }
        };
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
