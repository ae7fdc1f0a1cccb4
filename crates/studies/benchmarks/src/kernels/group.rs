//! A group of eight sweeps in the middle of a shipped frame, with what its blocks are fed.

use control_plane::ControlPlane;
use display_projection_processor::{Deflection, Processor, Projected};
use landscape::SweepLight;
use signal::{LANES, Real};
use sweep_generator::RangeTable;
use sweep_program::{Fan, SweepProgram};
use terrain_generator::{Profile, TerrainGenerator};

use crate::{Choice, STANDARD, TimedScene};

/// Samples of a group.
pub(super) const SAMPLES: u64 = LANES as u64 * STANDARD[1] as u64;

pub(super) struct Group {
    pub scene: TimedScene,
    pub table: RangeTable,
    pub fan: Fan,
    pub programs: [SweepProgram; LANES],
    pub directions: [[f64; 2]; LANES],
    pub light: [SweepLight; LANES],
}

impl Group {
    /// Of frame 0 of a scenario under ideal parts, on the standard raster.
    pub fn of(scenario: &str) -> Self {
        let choice = Choice { model: Some("ideal"), raster: Some(STANDARD), ..Choice::default() };
        let scene = TimedScene::shipped(scenario, &choice);
        let control = ControlPlane::new(scene.stage.clone());
        let settings = &scene.stage.settings;
        let sweeps = control.sweeps(0, &scene.pose).expect("drawn by the tests");
        let first = settings.raster.sweeps / 2;
        let number = |lane: usize| first + lane as u32;
        let directions = std::array::from_fn(|lane| sweeps.direction(number(lane)));
        let programs = std::array::from_fn(|lane| sweeps.programs(number(lane)).swap_remove(0));
        let (sun, landscape) = (scene.stage.scenery.sun(0.0), &scene.stage.landscape);
        let lit = |direction| SweepLight::new(&sun, landscape.albedo(), *landscape.photometry(), direction);
        let pitch = scene.pose.attitude.pitch;
        let fan = Fan::covering(settings.laws.projection, pitch, &settings.raster.field, STANDARD[0]);
        Self {
            table: RangeTable::new(&settings.range, settings.raster.samples as usize),
            fan: fan.expect("the pitch is moderate"),
            light: directions.map(lit),
            programs,
            directions,
            scene,
        }
    }

    /// Foot of the eye: north, east (m).
    pub fn foot(&self) -> [f64; 2] {
        [self.scene.pose.eye[0], self.scene.pose.eye[1]]
    }

    pub fn terrain(&self) -> TerrainGenerator<'_> {
        let level = self.scene.stage.landscape.level();
        TerrainGenerator {
            buffer: level.words(),
            region_size: level.region_size(),
            ranges: self.table.ranges(),
            datum: self.scene.pose.eye[2],
        }
    }

    pub fn profile<S: Real>(&self) -> Profile<S> {
        let mut profile = Profile::default();
        self.terrain().run(&self.programs, &self.light, &mut profile);
        profile
    }

    pub fn processor<S: Real>(&self) -> Processor<S> {
        let laws = &self.scene.stage.settings.laws;
        Processor::new(laws.occlusion, laws.curvature, self.table.ranges())
    }

    pub fn deflection(&self) -> [Deflection; LANES] {
        let (settings, pitch) = (&self.scene.stage.settings, self.scene.pose.attitude.pitch);
        let raster = settings.raster;
        std::array::from_fn(|lane| {
            let tangent = self.fan.tangent(STANDARD[0] / 2 + lane as u32);
            Deflection::new(settings.laws.projection, pitch, tangent)
                .in_lines(f64::from(raster.lines), raster.field.tan_half_height)
        })
    }

    pub fn projected<S: Real>(&self, profile: &Profile<S>) -> Projected<S> {
        let mut projected = Projected::default();
        self.processor().run(&profile.height, &self.deflection(), &mut projected);
        projected
    }
}
