//! The analog side of a group of sweeps: TG, MU, DPP, SM in the order of section 24.

use std::array;

use display_projection_processor::{Deflection, Processor, Projected};
use generator::Stage;
use mixing_unit::terrain_alone;
use signal::{LANES, Real};
use sweep_generator::RangeTable;
use sweep_memory::{Beam, write_group};
use sweep_program::{RegisterSet, SweepProgram, SweepStart};
use terrain_generator::{Profile, SweepLight, TerrainGenerator};

use crate::control_plane::FramePlan;

/// Buffers of one worker; they live as long as the session.
#[derive(Debug, Clone)]
pub(crate) struct Workspace<S> {
    /// Programs of the group.
    pub programs: [SweepProgram; LANES],
    /// Terrain profiles.
    pub profile: Profile<S>,
    /// Projected profiles.
    pub projected: Projected<S>,
}

impl<S: Default> Default for Workspace<S> {
    fn default() -> Self {
        let still = sweep_program::Ramp { start: 0.0, rate: 0.0, polarity: 1.0 };
        let start = SweepStart { direction: [1.0, 0.0], region: [0, 0], ramps: [still; 2] };
        let registers = [RegisterSet::default(); 4];
        let idle = SweepProgram { start, registers, steps: Vec::new(), end_range: 0.0, misses: Vec::new() };
        Self {
            programs: array::from_fn(|_| idle.clone()),
            profile: Profile::default(),
            projected: Projected::default(),
        }
    }
}

/// Everything that the groups of a frame share.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Group<'a, S> {
    pub stage: &'a Stage,
    pub table: &'a RangeTable,
    pub processor: &'a Processor<S>,
    pub plan: &'a FramePlan,
}

impl<S: Real> Group<'_, S> {
    /// Runs the group that begins at sweep `first` and leaves its lines in `rows`, one stretch a sweep.
    pub fn run(&self, first: u32, work: &mut Workspace<S>, rows: &mut [f32]) {
        let Stage { landscape, settings, .. } = self.stage;
        let (level, raster) = (landscape.level(), &settings.raster);
        // Lanes beyond the last sweep repeat it; nothing of them is kept.
        let sweeps: [u32; LANES] = array::from_fn(|lane| (first + lane as u32).min(raster.sweeps - 1));
        for (&sweep, program) in sweeps.iter().zip(&mut work.programs) {
            self.plan.write_program(sweep, level, settings, self.table, program);
        }
        let light = work
            .programs
            .each_ref()
            .map(|program| SweepLight::new(&self.plan.sun, landscape.albedo(), program.start.direction));
        let deflection = sweeps.map(|sweep| {
            let tangent = self.plan.fan.tangent(sweep);
            Deflection::new(settings.laws.projection, self.plan.pitch, tangent)
                .in_lines(f64::from(raster.lines), raster.field.tan_half_height)
        });
        let terrain = TerrainGenerator {
            buffer: level.words(),
            region_size: level.region_size(),
            ranges: self.table.ranges(),
            datum: self.plan.eye[2],
        };
        terrain.run(&work.programs, &light, &mut work.profile);
        let composite = terrain_alone(&work.profile.height, &work.profile.reflectivity);
        self.processor.run(composite.height, &deflection, &mut work.projected);
        let Projected { position, line, entry, .. } = &work.projected;
        let beam = Beam { position, line, entry, intensity: composite.reflectivity };
        write_group(&beam, settings.laws.pixel_rule, raster.lines as usize, rows);
    }
}
