//! The whole machine over a ground: one frame, with every signal that a reading looks at.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use control_plane::{ControlPlane, MachineStage};
use features::{Crater, Features, Shape};
use generator::{PlaneKind, Planes};
use hardware_model::{HardwareModel, Settings};
use landscape::{Attitude, Bank, Landscape, Sun};
use machine::Prepare;
use quantities::radians;
use scenario::{
    Display, FieldOfView, LawWishes, Pose, RasterWishes, Scalar, Scenery, ShadowFineness, TrackPatch,
};
use serde::Deserialize;
use signal::{Probe, Waveform};
use sweep_program::Fan;
use timing::FrameTiming;

use super::ground::CartridgeGround;
use super::within;
use crate::engine::Engine;
use crate::hardware::Hardware;
use crate::reading::Reading;

/// A frame over a ground. Lengths in metres, angles in degrees, azimuths clockwise from north; x is north, y is east.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MachineScene {
    /// Side of a region.
    pub region_size_m: f64,
    /// Corners to the north and to the east; corner (0, 0) is the origin.
    pub corners: [usize; 2],
    /// Terrain that the sweeps run over.
    pub ground: CartridgeGround,
    /// Craters on the terrain; none if it is missing.
    #[serde(default)]
    pub craters: Vec<Bowl>,
    /// Share of the light that is returned, 0 to 1.
    pub albedo: f64,
    /// Elevation of the sun.
    pub sun_elevation_deg: f64,
    /// Azimuth of the sun.
    pub sun_azimuth_deg: f64,
    /// Rectangles of remote shadow, each from south to north and from west to east: `[south, west, north, east]`.
    #[serde(default)]
    pub shadow_patches_m: Vec<[f64; 4]>,
    /// Distance between the profiles on which remote shadow is worked out; there is none if it is missing.
    pub shadow_profiles_m: Option<f64>,
    /// Eye: north, east, height above the datum.
    pub eye_m: [f64; 3],
    /// The scene is run under each heading.
    pub headings_deg: Vec<f64>,
    /// Pitch of the vehicle, nose up.
    pub pitch_deg: f64,
    /// Lines of the picture; it has as many columns as sweeps.
    pub lines: u32,
    /// Field of view, across and upright.
    pub field_deg: [f64; 2],
    /// The machine. Raster, ground range and laws are keys of it too.
    pub hardware: Hardware,
}

/// A crater of type 1: a paraboloid that meets the ground at its rim.
#[derive(Debug, Clone, Copy, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Bowl {
    /// Middle of the crater: north and east.
    pub centre_m: [f64; 2],
    /// Radius of the rim.
    pub radius_m: f64,
    /// Depth of the middle below the ground around.
    pub depth_m: f64,
}

/// One model, one heading and one ground of a scene.
#[derive(Debug, Clone)]
pub struct MachineCase {
    pub scene: MachineScene,
    pub ground: CartridgeGround,
    /// Clockwise from north (rad), and in degrees as it is written.
    pub heading: f64,
    heading_deg: f64,
    pub model: HardwareModel,
    landscape: Arc<Landscape>,
    pub settings: Settings,
}

/// What an engine made of it.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// Linear intensity, line by line from the top left.
    pub picture: Vec<f32>,
    /// Ground range of each pixel (m).
    pub ranges: Vec<f32>,
    /// Folds of both ramps in all sweeps.
    pub folds: u64,
    /// The digital side, if a reading looks at it.
    pub timing: Option<FrameTiming>,
    waves: BTreeMap<(u32, &'static str), Waveform>,
}

impl MachineScene {
    pub(super) fn cases(&self) -> Result<Vec<MachineCase>, String> {
        within("albedo", self.albedo, 0.0, 1.0)?;
        within("sun_elevation_deg", self.sun_elevation_deg, 0.0, 90.0)?;
        within("lines", f64::from(self.lines), 1.0, 4096.0)?;
        self.field_deg.iter().try_for_each(|&field| within("field_deg", field, 0.01, 160.0))?;
        self.ground.check(self.corners)?;
        let models = self.hardware.load()?;
        let mut cases = Vec::new();
        for ground in self.ground.variants() {
            let landscape = Arc::new(self.landscape(&ground)?);
            for model in &models {
                for &heading_deg in &self.headings_deg {
                    cases.push(MachineCase {
                        scene: self.clone(),
                        ground: ground.clone(),
                        heading: radians(heading_deg.rem_euclid(360.0)),
                        heading_deg,
                        model: model.clone(),
                        landscape: landscape.clone(),
                        settings: self.settings(model)?,
                    });
                }
            }
        }
        Ok(cases)
    }

    fn landscape(&self, ground: &CartridgeGround) -> Result<Landscape, String> {
        let level =
            ground.level(self.region_size_m, self.corners).map_err(|error| format!("ground: {error}"))?;
        let bank = Bank::new("cartridge", vec![level], None).map_err(|error| format!("ground: {error}"))?;
        let crater =
            |bowl: &Bowl| Crater::new(bowl.centre_m, Shape::Bowl { r1: bowl.radius_m }, bowl.depth_m, 0.0);
        let craters: Result<Vec<Crater>, _> = self.craters.iter().map(crater).collect();
        let craters = craters.map_err(|error| format!("craters: {error}"))?;
        Ok(Landscape::new(bank, self.albedo).with_features(Features::new(craters)))
    }

    fn settings(&self, model: &HardwareModel) -> Result<Settings, String> {
        let [tan_half_width, tan_half_height] = self.field_deg.map(|field| libm::tan(0.5 * radians(field)));
        let field = FieldOfView { tan_half_width, tan_half_height };
        let wishes = RasterWishes { lines: Some(self.lines), ..RasterWishes::default() };
        let display = Display { white: 1.0, gamma: 1.0 };
        let laws = LawWishes::default();
        let settings = Settings::resolve(model, field, wishes, None, laws, Scalar::F64, display);
        let shadows =
            self.shadow_profiles_m.map(|finest| ShadowFineness { finest, angle: 1e-4, reach: None });
        Ok(Settings { shadows, ..settings.map_err(|error| error.to_string())? })
    }
}

impl MachineCase {
    pub(super) fn what(&self) -> String {
        let ground = match &self.ground {
            CartridgeGround::OneWord { corners, words, .. } => {
                format!(", word {} of corner {:?}", words[0], corners[0])
            }
            _ => String::new(),
        };
        format!("{}, heading {} deg{ground}", self.model.name, self.heading_deg)
    }

    fn pose(&self) -> Pose {
        let attitude = Attitude { roll: 0.0, pitch: radians(self.scene.pitch_deg), heading: self.heading };
        Pose { time: 0.0, eye: self.scene.eye_m, attitude, yoke: 0.0 }
    }

    fn stage(&self, scalar: Scalar) -> MachineStage {
        let scene = &self.scene;
        let sun =
            Sun { azimuth: radians(scene.sun_azimuth_deg), elevation: radians(scene.sun_elevation_deg) };
        let patch = |&[south, west, north, east]: &[f64; 4]| TrackPatch {
            laid: 0.0,
            corners: [[north, west], [north, east], [south, east], [south, west]],
        };
        let patches = scene.shadow_patches_m.iter().map(patch).collect();
        let scenery = Scenery::still(sun).with_patches(patches).with_course(vec![self.pose()]);
        let settings = Settings { scalar, ..self.settings.clone() };
        MachineStage { landscape: self.landscape.clone(), scenery: Arc::new(scenery), settings }
    }

    pub(super) fn draw(&self, engine: Engine, readings: &[&Reading]) -> Result<Drawn, String> {
        let stage = self.stage(if engine == Engine::MachineF32 { Scalar::F32 } else { Scalar::F64 });
        let timing = match readings.iter().any(|reading| reading.looks_at_timing()) {
            true => Some(ControlPlane::new(stage.clone()).frame(0, &self.pose()).map_err(|e| e.to_string())?),
            false => None,
        };
        let session = match engine {
            Engine::Generator(_) => registry::judge_on(stage.stage()).map_err(|error| error.to_string())?,
            Engine::MachineF32 | Engine::MachineF64 | Engine::Part => stage.prepare(),
        };
        let raster = self.settings.raster;
        let kinds = [PlaneKind::Intensity, PlaneKind::Range];
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &kinds);
        let signals: BTreeSet<&str> = readings.iter().flat_map(|reading| reading.signals()).collect();
        let mut probe = Probe::new(signals.into_iter().map(str::to_owned).collect(), 0..raster.sweeps);
        let counts = session.frame(0, &self.pose(), &mut planes, &mut probe).map_err(|e| e.to_string())?;
        let plane = |kind| planes.get(kind).map(<[f32]>::to_vec).unwrap_or_default();
        let waves = probe.waveforms.into_iter().map(|wave| ((wave.sweep, wave.signal.name), wave));
        Ok(Drawn {
            picture: plane(PlaneKind::Intensity),
            ranges: plane(PlaneKind::Range),
            folds: counts.get("folds").unwrap_or(0),
            timing,
            waves: waves.collect(),
        })
    }

    /// Sweeps of the frame.
    pub fn sweeps(&self) -> std::ops::Range<u32> {
        0..self.settings.raster.sweeps
    }

    /// Direction of a sweep: north, east. Nothing if no fan covers the pitch.
    pub fn direction(&self, sweep: u32) -> Option<[f64; 2]> {
        let (settings, pitch) = (&self.settings, radians(self.scene.pitch_deg));
        let raster = settings.raster;
        let fan = Fan::covering(settings.laws.projection, pitch, &raster.field, raster.sweeps)?;
        let (sin, cos) = quantities::sin_cos(self.heading);
        Some(fan.direction(sweep, [cos, sin]))
    }

    /// Place (m) that a direction leads to at a ground range (m).
    pub fn place(&self, direction: [f64; 2], range: f64) -> [f64; 2] {
        std::array::from_fn(|axis| self.scene.eye_m[axis] + range * direction[axis])
    }

    /// Height (m) and slopes of the terrain at a place (m).
    pub fn surface(&self, place: [f64; 2]) -> [f64; 3] {
        self.ground.surface(place, self.scene.region_size_m, self.scene.corners)
    }

    /// A sample of the sweep clock (s).
    pub fn sample_time(&self) -> f64 {
        1.0 / self.settings.timebase.sample_rate().hertz()
    }
}

impl Drawn {
    /// Values of a signal of a sweep.
    pub fn wave(&self, signal: &str, sweep: u32) -> Result<&[f64], String> {
        Ok(&self.recorded(signal, sweep)?.values)
    }

    /// Instants of a signal of a sweep that is told when it changes (samples); none of others.
    pub fn instants(&self, signal: &str, sweep: u32) -> Result<&[f64], String> {
        Ok(&self.recorded(signal, sweep)?.times)
    }

    fn recorded(&self, signal: &str, sweep: u32) -> Result<&Waveform, String> {
        let mut waves = self.waves.range((sweep, "")..);
        let found = waves.find(|((of, name), _)| *of == sweep && *name == signal);
        found.map(|(_, wave)| wave).ok_or(format!("{signal} of sweep {sweep} was not recorded"))
    }

    /// Whether the engine has signals.
    pub fn has_signals(&self) -> bool {
        !self.waves.is_empty()
    }

    /// Ground ranges of the samples (m).
    pub fn ranges_of(&self, sweep: u32) -> Result<&[f64], String> {
        self.wave(crate::reading::RANGE, sweep)
    }

    /// The record of the digital side.
    pub fn timing(&self) -> Result<&FrameTiming, String> {
        self.timing.as_ref().ok_or("the digital side was not recorded".into())
    }
}
