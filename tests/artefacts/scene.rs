//! A scene: ground, light, course and what is recorded of a run.

use std::f64::consts::PI;
use std::sync::Arc;

use control_plane::MachineStage;
use hardware_model::{HardwareModel, Settings};
use landscape::{Attitude, Bank, Landscape, Level, Sun};
use lunoid_tests::{level_of, plane};
use quantities::{Rate, radians};
use scenario::{
    Curvature, Display, FieldOfView, LawWishes, LevelSwitch, Occlusion, Pose, RangeLaw, RangeProgramme,
    RasterWishes, Scalar, Scenery, ShadowFineness, Standing, TrackPatch,
};

/// How the pictures of a scene are turned by the yoke.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// There is no yoke.
    Never,
    /// By one degree at a time of 0.1 s.
    ByOneDegree,
}

/// Everything about a run but the machine.
#[derive(Clone)]
pub struct Scene {
    pub landscape: Landscape,
    pub sun: Sun,
    pub bodies: Vec<Standing>,
    pub patches: Vec<TrackPatch>,
    pub field: FieldOfView,
    pub raster: RasterWishes,
    pub range: Option<RangeProgramme>,
    pub laws: LawWishes,
    /// Where the vehicle is at a time (s), frame by frame.
    pub pose: fn(&Scene, u64, f64) -> Pose,
    /// North, east and height of the eye at the start (m).
    pub eye: [f64; 3],
    /// At the start (rad).
    pub heading: f64,
    pub turn: Turn,
    /// Where the sweeps go over to a second level of ground, if there is one.
    pub levels: Option<LevelSwitch>,
    /// How finely remote shadow is worked out, if it is.
    pub shadows: Option<ShadowFineness>,
    /// Frames of the mission.
    pub course: u64,
    /// Frames that are looked at.
    pub frames: Vec<u64>,
    /// Signals that are looked at.
    pub signals: &'static [&'static str],
    /// Whether the control plane is asked for its record.
    pub timed: bool,
    /// Whether frames are drawn at all.
    pub drawn: bool,
}

/// Length of a sweep of the scenes that have parts to be timed against it (s); no time is lost in retrace.
pub const SWEEP: f64 = 32e-6;

impl Scene {
    /// Over `level`, from 10 m above the datum at `foot`, to the north; `sweeps` of `samples`, 32 µs each, at a constant
    /// rate of ground range out to `end`.
    pub fn over(level: Level, foot: [f64; 2], [sweeps, samples]: [u32; 2], end: f64) -> Self {
        let bank = Bank::new("artefacts", vec![level], None).expect("one level is a bank");
        let start = end / f64::from(samples);
        Self {
            landscape: Landscape::new(bank, 1.0),
            sun: Sun { azimuth: 0.0, elevation: radians(25.0) },
            bodies: Vec::new(),
            patches: Vec::new(),
            field: field(20.0, 15.0),
            raster: RasterWishes {
                sweeps: Some(sweeps),
                samples: Some(samples),
                lines: Some(64),
                update: Rate::new(31_250, u64::from(sweeps)),
                refresh: Rate::new(31_250, u64::from(sweeps)),
                columns: None,
            },
            range: Some(RangeProgramme { law: RangeLaw::ConstantRate, start, end }),
            laws: LawWishes {
                occlusion: Some(Occlusion::PeakHold),
                curvature: Some(Curvature::None),
                ..LawWishes::default()
            },
            pose: still,
            eye: [foot[0], foot[1], 10.0],
            heading: 0.0,
            turn: Turn::Never,
            levels: None,
            shadows: None,
            course: 1,
            frames: vec![0],
            signals: &[],
            timed: false,
            drawn: true,
        }
    }

    /// The settings of a run on `model`.
    pub fn settings(&self, model: &HardwareModel) -> Settings {
        let display = Display { white: 1.0, gamma: 1.0 };
        let settings =
            Settings::resolve(model, self.field, self.raster, self.range, self.laws, Scalar::F64, display);
        let yoke = (self.turn == Turn::ByOneDegree).then_some(model.yoke);
        Settings {
            yoke,
            levels: self.levels,
            shadows: self.shadows,
            ..settings.unwrap_or_else(|e| panic!("{e}"))
        }
    }

    /// The stage of a run, and the pose of every frame of the mission.
    pub fn stage(&self, model: &HardwareModel) -> (MachineStage, Vec<Pose>) {
        let settings = self.settings(model);
        let update = settings.timebase.update.hertz();
        let poses: Vec<Pose> = match self.turn {
            Turn::Never => {
                (0..self.course).map(|frame| (self.pose)(self, frame, frame as f64 / update)).collect()
            }
            Turn::ByOneDegree => crate::artefacts::scenes::rolled(self, &settings),
        };
        let scenery = Scenery::still(self.sun)
            .with_bodies(self.bodies.clone())
            .with_patches(self.patches.clone())
            .with_course(poses.clone());
        let landscape = Arc::new(self.landscape.clone());
        (MachineStage { landscape, scenery: Arc::new(scenery), settings }, poses)
    }

    /// Side of a region (m).
    pub fn region(&self) -> f64 {
        self.landscape.level().region_size()
    }
}

/// A field of view by its half angles (degrees).
pub fn field(half_width: f64, half_height: f64) -> FieldOfView {
    FieldOfView {
        tan_half_width: libm::tan(radians(half_width)),
        tan_half_height: libm::tan(radians(half_height)),
    }
}

/// A pose of a vehicle that stands.
pub fn still(scene: &Scene, _: u64, time: f64) -> Pose {
    facing(scene, time, 0.0, 0.0)
}

/// A pose turned by `turn`, its nose up by `pitch` (rad).
pub fn facing(scene: &Scene, time: f64, turn: f64, pitch: f64) -> Pose {
    let heading = (scene.heading + turn + 2.0 * PI) % (2.0 * PI);
    Pose { time, eye: scene.eye, attitude: Attitude { roll: 0.0, pitch, heading }, yoke: 0.0 }
}

/// Ground at the datum, which no part of the array can get wrong.
pub fn level_ground(region: f64, corners: usize) -> Level {
    level_of(region, [0.0; 2], [corners; 2], plane(region, 0.0, [0.0; 2]))
}

/// Ground whose corners have heights alone, by row and column.
pub fn heights(region: f64, corners: [usize; 2], height: impl Fn(usize, usize) -> f64) -> Level {
    level_of(region, [0.0; 2], corners, |m, n| {
        let mut words = [0.0; 9];
        words[0] = height(m, n);
        words
    })
}
