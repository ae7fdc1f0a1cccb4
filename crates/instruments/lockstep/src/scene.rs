//! Scenes built by hand, and their pictures.

use std::sync::Arc;

use control_plane::MachineStage;
use features::{Crater, Features};
use generator::{FrameCounts, FrameError, PlaneKind, Planes};
use hardware_model::{
    AnalogParts, Cpu, DataBanks, FeatureParts, Gate, HardwareModel, KindBanks, LatePolicy, LevelSwitch,
    LevelTurn, Loader, MixingParts, Raster, Settings, ShadowParts, SweepMemoryKind,
};
use landscape::{
    Attitude, Bank, CornerWords, CraterGrain, Landscape, Layer, Level, Photometry, Source, Sun, Texture,
};
use machine::Prepare;
use quantities::{Rate, Timebase, radians};
use scenario::{
    Curvature, Display, FieldOfView, LawWishes, Laws, Occlusion, PixelRule, Pose, Projection, RangeLaw,
    RangeProgramme, RasterWishes, Scalar, Scenery, ShadowFineness,
};
use signal::{Probe, Waveform};

use crate::{Engines, Report};

/// Frames in which the view of a scene turns.
const FRAMES: u64 = 8;

/// Frames a second of every test scene.
pub const UPDATE_HZ: u64 = 30;

/// Everything that decides one picture, as plain fields.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedScene {
    /// Stored ground of the fine level.
    pub level: Level,
    /// Ground beyond the switch, where there are two levels.
    pub coarse: Option<(Level, LevelSwitch)>,
    /// Craters on the ground, as the feature list has them.
    pub craters: Vec<Crater>,
    /// Grain sizes of the texture; none without layers.
    pub texture: Vec<Layer>,
    /// Gain of the texture in the middle of craters of types 1, 2 and 3.
    pub crater_gain: [f64; 3],
    /// Law of reflection of the ground.
    pub photometry: Photometry,
    /// Share of the light that is returned, 0..=1.
    pub albedo: f64,
    /// Direction of the sun's light.
    pub sun: Sun,
    /// Eye: north, east, height (m).
    pub eye: [f64; 3],
    /// Clockwise from north (rad).
    pub heading: f64,
    /// Pitch of the vehicle, nose up (rad).
    pub pitch: f64,
    /// Sweeps a frame, and columns of the picture.
    pub sweeps: u32,
    /// Number of samples per sweep.
    pub samples: u32,
    /// Lines of the picture.
    pub lines: u32,
    /// Rate of the master clock (Hz).
    pub master_hz: u64,
    /// Field of view of the picture.
    pub field: FieldOfView,
    /// Ground-range programme of the sweeps.
    pub range: RangeProgramme,
    /// Law switches of the scene.
    pub laws: Laws,
    /// Scalar type of the analog signals.
    pub scalar: Scalar,
    /// What the processor does about far ground while the view turns.
    pub level_turn: LevelTurn,
    /// Delivery of coefficient words.
    pub loader: Loader,
    /// Kind of sweep memory.
    pub sweep_memory: SweepMemoryKind,
    /// Times of the processor's tasks.
    pub cpu: Cpu,
    /// Drums and storage buffers.
    pub data_banks: DataBanks,
    /// Banks of the other kinds of data.
    pub kind_banks: KindBanks,
    /// Organisation and sub-generators of the feature generator.
    pub feature_generator: FeatureParts,
    /// Words of craters that come in a second; all at hand if none.
    pub feature_words: Option<f64>,
    /// Remote shadow, if there is any.
    pub shadows: Option<ShadowFineness>,
    /// Line generators of the shadow controller.
    pub shadow_controller: ShadowParts,
    /// Words of shadow boundaries that come in a second; all at hand if none.
    pub segment_words: Option<f64>,
    /// Turn of the view from frame to frame (rad).
    pub turn: f64,
    /// What opens the switch of the features.
    pub gate: Gate,
    /// Real parts, and the seed that draws their figures and their noise.
    pub parts: (AnalogParts, u64),
}

/// What a generator made of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// Linear reflectivity, row by row from the top left.
    pub picture: Vec<f32>,
    /// Ground range of each pixel (m); zero where the generator does not fill it.
    pub ranges: Vec<f32>,
    /// Counts of the work done.
    pub counts: FrameCounts,
    /// Waveforms of the probed signals.
    pub waveforms: Vec<Waveform>,
}

impl ComparedScene {
    /// A scene over `level`: eye 10 m above its middle, looking north with the report's field of view; a small
    /// raster; ideal laws; f64; wired transfers.
    pub fn over(level: Level) -> Self {
        let [south, west, north, east] = level.extent();
        let middle = [0.5 * (south + north), 0.5 * (west + east)];
        let ground = direct(&level, middle);
        Self {
            eye: [middle[0], middle[1], ground + 10.0],
            range: RangeProgramme { law: RangeLaw::Geometric, start: 2.0, end: 4.0 * level.region_size() },
            level,
            coarse: None,
            craters: Vec::new(),
            texture: Vec::new(),
            crater_gain: [1.0; 3],
            photometry: Photometry::Lambert,
            albedo: 1.0,
            sun: Sun { azimuth: radians(70.0), elevation: radians(25.0) },
            heading: 0.0,
            pitch: 0.0,
            sweeps: 9,
            samples: 300,
            lines: 64,
            master_hz: 20_000_000,
            field: FieldOfView {
                tan_half_width: libm::tan(radians(25.0)),
                tan_half_height: libm::tan(radians(15.0)),
            },
            laws: Laws {
                projection: Projection::Exact,
                curvature: Curvature::Parabolic,
                occlusion: Occlusion::Derivative,
                pixel_rule: PixelRule::LineMean,
                ..Laws::default()
            },
            scalar: Scalar::F64,
            loader: Loader { late_policy: LatePolicy::StrobeThrough, ..HardwareModel::ideal().loader },
            sweep_memory: SweepMemoryKind::ScanConverter,
            cpu: Cpu::default(),
            level_turn: LevelTurn::NEVER,
            data_banks: HardwareModel::ideal().data_banks,
            kind_banks: HardwareModel::ideal().kind_banks,
            feature_generator: FeatureParts::default(),
            feature_words: None,
            shadows: None,
            shadow_controller: ShadowParts::Digital { line_generators: None },
            segment_words: None,
            turn: 0.0,
            gate: Gate::Presence,
            parts: (AnalogParts::ideal(), 0),
        }
    }

    /// Puts the eye `above` the ground at (x, y) (m).
    pub fn stand(&mut self, x: f64, y: f64, above: f64) {
        self.eye = [x, y, direct(&self.level, [x, y]) + above];
    }

    /// Blanked accumulator steps a sweep.
    pub fn retrace(&self) -> u32 {
        self.samples / 4
    }

    /// Length of a sample (s).
    pub fn step(&self) -> f64 {
        1.0 / (UPDATE_HZ as f64 * f64::from(self.sweeps) * f64::from(self.samples + self.retrace()))
    }

    /// The stage of the scene.
    ///
    /// # Panics
    /// If its levels do not make a bank, or its layers no texture.
    pub fn stage(&self) -> MachineStage {
        let coarse = self.coarse.iter().map(|(level, _)| level.clone());
        let levels = [self.level.clone()].into_iter().chain(coarse).collect();
        let bank = Bank::new("test", levels, None).expect("levels from fine to coarse are a bank");
        let landscape = Landscape::new(bank, self.albedo)
            .with_features(Features::new(self.craters.clone()))
            .with_texture(self.grain())
            .with_crater_grain(CraterGrain::new(self.crater_gain))
            .with_photometry(self.photometry);
        let scenery = Arc::new(Scenery::still(self.sun).with_course(self.course()));
        MachineStage { landscape: Arc::new(landscape), scenery, settings: self.settings() }
    }

    fn grain(&self) -> Option<Texture> {
        let level = &self.level;
        let made = |layers| Texture::new(layers, Source::Random, 1970, level.region_size(), level.origin());
        (!self.texture.is_empty()).then(|| made(&self.texture).expect("layers in their ranges"))
    }

    /// The settings of the run.
    ///
    /// # Panics
    /// If raster and clocks do not fit together.
    pub fn settings(&self) -> Settings {
        let hertz = |count| Rate::new(count, 1).expect("a rate above zero");
        let update = hertz(UPDATE_HZ);
        let timebase =
            Timebase::new(hertz(self.master_hz), update, self.sweeps, self.samples, self.retrace());
        let ideal = Settings::resolve(
            &HardwareModel::ideal(),
            self.field,
            RasterWishes::default(),
            None,
            LawWishes::default(),
            self.scalar,
            Display { white: 1.0, gamma: 1.0 },
        );
        let ideal = ideal.expect("the ideal model is consistent");
        Settings {
            raster: Raster {
                sweeps: self.sweeps,
                samples: self.samples,
                columns: self.sweeps,
                lines: self.lines,
                field: self.field,
                refresh: update,
            },
            timebase: timebase.expect("clocks of a small raster"),
            range: self.range,
            laws: self.laws,
            levels: self.coarse.as_ref().map(|(_, switch)| *switch),
            loader: self.loader.clone(),
            sweep_memory: self.sweep_memory,
            cpu: self.cpu,
            level_turn: self.level_turn,
            data_banks: self.data_banks,
            kind_banks: self.kind_banks,
            feature_generator: self.feature_generator,
            feature_words: self.feature_words,
            shadows: self.shadows,
            shadow_controller: self.shadow_controller,
            segment_words: self.segment_words,
            mixing_unit: MixingParts { gate: self.gate, ..ideal.mixing_unit },
            analog: self.parts.0.clone(),
            seed: self.parts.1,
            ..ideal
        }
    }

    /// Where the eye is.
    pub fn pose(&self) -> Pose {
        let attitude = Attitude { roll: 0.0, pitch: self.pitch, heading: self.heading };
        Pose { time: 0.0, eye: self.eye, attitude, yoke: 0.0 }
    }

    /// Poses of the first frames: the view turns, and the eye stays where it is.
    fn course(&self) -> Vec<Pose> {
        (0..FRAMES).map(|frame| self.pose_in(frame)).collect()
    }

    fn pose_in(&self, frame: u64) -> Pose {
        let mut pose = self.pose();
        pose.attitude.heading += self.turn * frame as f64;
        pose
    }

    /// Frame `frame` of the scene on both engines, all sweeps.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    ///
    /// # Panics
    /// If the machine refuses the stage.
    pub fn lockstep(&self, frame: u64) -> Result<Report, FrameError> {
        let engines = Engines::new(self.stage());
        engines.compare(frame, &self.pose_in(frame), 0..self.sweeps)
    }

    /// Draws frame `frame` on the machine and records `signals` (patterns) of every sweep.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn draw(&self, frame: u64, signals: &[&str]) -> Result<Drawn, FrameError> {
        let session = self.stage().prepare();
        let kinds = [PlaneKind::Intensity, PlaneKind::Range];
        let mut planes = Planes::new(self.sweeps as usize, self.lines as usize, &kinds);
        let patterns = signals.iter().map(|&pattern| pattern.to_owned()).collect();
        let mut probe = Probe::new(patterns, 0..self.sweeps);
        let counts = session.frame(frame, &self.pose(), &mut planes, &mut probe)?;
        let plane = |kind| planes.get(kind).map(<[f32]>::to_vec).unwrap_or_default();
        Ok(Drawn {
            picture: plane(PlaneKind::Intensity),
            ranges: plane(PlaneKind::Range),
            counts,
            waveforms: probe.waveforms,
        })
    }
}

/// Height of the terrain by direct evaluation (m).
fn direct(level: &Level, [x, y]: [f64; 2]) -> f64 {
    let (region, local) = level.locate(x, y).expect("a point of the problem area");
    level.height_and_slopes(region, local)[0]
}

/// A level from the words of each corner (m, n).
///
/// # Panics
/// If the words do not make a level.
pub fn level_of(
    region_size: f64,
    origin: [f64; 2],
    corners: [usize; 2],
    words: impl Fn(usize, usize) -> CornerWords,
) -> Level {
    let words = (0..corners[0] * corners[1]).map(|k| words(k / corners[1], k % corners[1])).collect();
    Level::new(region_size, origin, corners, words).expect("a sound level")
}

/// Words of corner (m, n) of the plane `h = height + slopes[0] x + slopes[1] y`, from corner (0, 0) on.
pub fn plane(region_size: f64, height: f64, slopes: [f64; 2]) -> impl Fn(usize, usize) -> CornerWords {
    let [along_u, along_v] = slopes.map(|slope| slope * region_size);
    move |m, n| {
        let mut words = [0.0; 9];
        words[0] = height + along_u * m as f64 + along_v * n as f64;
        words[3] = along_u;
        words[1] = along_v;
        words
    }
}
