//! The scene that both draw, and the machine made ready for it.

use std::path::Path;

use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Session};
use hardware_model::Economy;
use landscape::Attitude;
use machine::Prepare;
use quantities::radians;
use rayon::{ThreadPool, ThreadPoolBuilder};
use scenario::{Pose, Scalar, ShadowFineness};
use signal::Probe;

use super::{EyeMesh, Grading, Sight};
use crate::{Choice, TimedScene};

/// Scenario of the scene.
const GROUND: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/ground.toml");
/// Height of the eye (m) and pitch of the picture (degrees).
const EYE: (f64, f64) = (2.4, -3.0);
/// Sweeps and samples of the stage that `exact` and the ray tracer look at: neither has any.
const ANY_RASTER: [u32; 2] = [799, 1000];

/// How finely shadows are worked out: the least distance between profiles (m), and the same for each metre of distance (rad).
pub type Fineness = [f64; 2];

/// A setting of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// Sweeps a frame and samples a sweep.
    pub raster: [u32; 2],
    /// Instants a step; each edge at its own if none.
    pub instants: Option<u32>,
    /// How finely shadows are worked out.
    pub shadows: Fineness,
}

impl Setting {
    /// What the setting is called in a table.
    pub fn name(&self) -> String {
        let Self { raster: [sweeps, samples], instants, shadows: [finest, angle] } = self;
        let instants = instants.map_or("fine".to_owned(), |count| format!("{count} instants"));
        format!("{sweeps} x {samples}, {instants}, shadows {finest} m and {} mrad", 1e3 * angle)
    }
}

/// The scene, and two threads.
pub struct PeerScene {
    scene: TimedScene,
    pose: Pose,
    pool: ThreadPool,
}

impl PeerScene {
    /// The scene of the comparison.
    ///
    /// # Errors
    /// If the eye is not over the ground, or threads cannot be started.
    pub fn new() -> Result<Self, String> {
        let scene = read(ANY_RASTER, Economy::Bounded);
        let [x, y, _] = scene.pose.eye;
        let ground = scene.stage.landscape.height(x, y).ok_or("the eye is not over the ground")?;
        let (height, pitch) = EYE;
        let attitude = Attitude { pitch: radians(pitch), roll: 0.0, heading: scene.pose.attitude.heading };
        let pose = Pose { time: 0.0, eye: [x, y, ground + height], attitude, yoke: 0.0 };
        let pool = ThreadPoolBuilder::new().num_threads(2).build().map_err(|error| error.to_string())?;
        Ok(Self { scene, pose, pool })
    }

    /// Columns and lines of the picture.
    pub fn size(&self) -> [u32; 2] {
        let raster = self.scene.stage.settings.raster;
        [raster.columns, raster.lines]
    }

    /// Craters on the ground.
    pub fn craters(&self) -> usize {
        self.scene.stage.landscape.features().craters().iter().count()
    }

    /// Unit vector to the sun at `time` (s): north, east, up.
    pub fn sun(&self, time: f64) -> [f64; 3] {
        self.scene.stage.scenery.sun(time).direction()
    }

    /// The right picture at `time` (s).
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn exact(&self, time: f64) -> Result<Vec<f32>, String> {
        let session = Exact.prepare(self.scene.stage.stage()).map_err(|error| error.to_string())?;
        let mut planes = self.scene.planes();
        self.draw(&*session, time, &mut planes)?;
        picture(&planes)
    }

    /// The machine in a setting, with no shadow boundary found yet.
    pub fn machine(&self, setting: &Setting) -> Machine<'_> {
        let economy = setting.instants.map_or(Economy::Bounded, Economy::Instants);
        let mut scene = read(setting.raster, economy);
        let [finest, angle] = setting.shadows;
        scene.stage.settings.shadows = Some(ShadowFineness { finest, angle, reach: None });
        let planes = scene.planes();
        Machine { scene: self, session: scene.stage.prepare(), planes }
    }

    /// The ground as a mesh for the eye, and how it is seen.
    pub fn mesh(&self, meridians: usize, rings: usize) -> (EyeMesh, Sight) {
        let (stage, field) = (&self.scene.stage, self.scene.stage.settings.raster.field);
        let ranges = stage.settings.view().ranges;
        let mesh = EyeMesh::new(&stage.landscape, &self.pose, field, &Grading { meridians, rings, ranges });
        let turn = self.pose.attitude.to_terrain();
        let axes = [turn.x_axis, turn.y_axis, turn.z_axis].map(|axis| [axis.x, axis.y, -axis.z]);
        (mesh, Sight { size: self.size(), field, albedo: stage.landscape.albedo(), ranges, axes })
    }

    fn draw(&self, session: &dyn Session, time: f64, planes: &mut Planes) -> Result<(), String> {
        let pose = Pose { time, ..self.pose };
        let drawn = self.pool.install(|| session.frame(time as u64, &pose, planes, &mut Probe::off()));
        drawn.map(|_| ()).map_err(|error| error.to_string())
    }
}

/// The machine in a setting.
pub struct Machine<'a> {
    scene: &'a PeerScene,
    session: Box<dyn Session>,
    planes: Planes,
}

impl Machine<'_> {
    /// Draws a frame under the sun of `time` (s): how long that took (s).
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn draw(&mut self, time: f64) -> Result<f64, String> {
        let begin = std::time::Instant::now();
        self.scene.draw(&*self.session, time, &mut self.planes)?;
        Ok(begin.elapsed().as_secs_f64())
    }

    /// Reflectivity of the last frame, line by line from the top left.
    ///
    /// # Errors
    /// If none was drawn.
    pub fn picture(&self) -> Result<Vec<f32>, String> {
        picture(&self.planes)
    }
}

fn read(raster: [u32; 2], economy: Economy) -> TimedScene {
    let choice = Choice { model: Some("ideal"), scalar: Some(Scalar::F32), raster: Some(raster), economy };
    TimedScene::read(Path::new(GROUND), &choice)
}

fn picture(planes: &Planes) -> Result<Vec<f32>, String> {
    planes.get(PlaneKind::Intensity).map(<[f32]>::to_vec).ok_or_else(|| "no picture".to_owned())
}
