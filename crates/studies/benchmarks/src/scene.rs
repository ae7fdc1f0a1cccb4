//! Shipped scenarios, made ready.

use std::path::Path;
use std::sync::Arc;

use control_plane::MachineStage;
use generator::{PlaneKind, Planes};
use hardware_model::{Economy, HardwareModel, ModelSource, Settings};
use remote_shadow::{Resolution, ShadowBank};
use scenario::{Pose, PoseTable, Scalar, Scenario};

/// A shipped scenario under its own machine, made ready for its first frame.
#[derive(Debug)]
pub struct TimedScene {
    /// Ground, scenery and settings of the scenario.
    pub stage: MachineStage,
    /// Pose of the eye in frame 0.
    pub pose: Pose,
    scenario: Scenario,
}

/// What is measured of a scenario instead of what it says itself; `None` leaves it as it is.
#[derive(Debug, Clone, Copy, Default)]
pub struct Choice {
    /// Hardware model by name.
    pub model: Option<&'static str>,
    /// Scalar type of the signals.
    pub scalar: Option<Scalar>,
    /// Sweeps a frame and samples a sweep.
    pub raster: Option<[u32; 2]>,
    /// What may be left out.
    pub economy: Economy,
}

impl TimedScene {
    /// The scenario called `name`, with `choice` made.
    ///
    /// # Panics
    /// If the shipped scenario cannot be read: then the tests fail as well.
    pub fn shipped(name: &str, choice: &Choice) -> Self {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios"));
        Self::read(&folder.join(name).with_extension("toml"), choice)
    }

    /// The scenario of a file that is known to be good, with `choice` made.
    ///
    /// # Panics
    /// If it is not.
    pub fn read(path: &Path, choice: &Choice) -> Self {
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut scenario = Scenario::read(path).expect("the scenario is good");
        scenario.scalar = choice.scalar.unwrap_or(scenario.scalar);
        if let Some([sweeps, samples]) = choice.raster {
            (scenario.raster.sweeps, scenario.raster.samples) = (Some(sweeps), Some(samples));
        }
        let model = choice.model.unwrap_or(&scenario.machine);
        let source = ModelSource::find(model, folder).expect("it names a shipped model");
        let model = HardwareModel::load(&source, &[], &[]).expect("which is read by the tests").model;
        let settings = front_door::settings(&scenario, &model).expect("settings are resolved by the tests");
        let settings = Settings { economy: choice.economy, ..settings };
        let stage = front_door::build(&scenario, settings).expect("the ground is made by the tests");
        let pose = poses(&scenario, &stage, 1)[0];
        Self { stage, pose, scenario }
    }

    /// Of every frame of the mission.
    pub fn poses(&self) -> Vec<Pose> {
        poses(&self.scenario, &self.stage, self.scenario.frames(self.stage.settings.timebase.update))
    }

    /// Its shadow boundaries, none of which is found yet.
    ///
    /// # Panics
    /// If it has no `[shadows]`.
    pub fn shadow_bank(&self) -> ShadowBank {
        let fineness = self.stage.settings.shadows.expect("the scenario has shadows");
        let resolution = Resolution { finest: fineness.finest, angle: fineness.angle };
        ShadowBank::new(Arc::clone(&self.stage.landscape), resolution)
    }

    /// Planes of its raster for a picture.
    pub fn planes(&self) -> Planes {
        let raster = self.stage.settings.raster;
        Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity])
    }

    /// Samples of a frame, retrace not counted.
    pub fn samples(&self) -> u64 {
        let raster = self.stage.settings.raster;
        u64::from(raster.sweeps) * u64::from(raster.samples)
    }
}

/// Of the first `frames` frames.
fn poses(scenario: &Scenario, stage: &MachineStage, frames: u64) -> Vec<Pose> {
    let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
    let poses = PoseTable::resolve(scenario, &stage.landscape, update, yoke, 0..frames);
    poses.expect("the path is driven by the tests").rows().iter().map(|row| row.pose).collect()
}
