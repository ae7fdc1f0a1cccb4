//! A small whole frame as plain fields, to be pushed to its extremes.

use std::sync::Arc;

use control_plane::MachineStage;
use features::{Crater, Features};
use hardware_model::{HardwareModel, Settings};
use landscape::{Attitude, Bank, CornerWords, Landscape, Level, Sun};
use quantities::radians;
use scenario::{Display, FieldOfView, LawWishes, Pose, RangeProgramme, RasterWishes, Scalar, Scenery};

use crate::Subject;

/// Raster of a scene.
const SWEEPS: u32 = 48;
const LINES: u32 = 32;
const SAMPLES: u32 = 400;

/// Everything that decides one frame.
#[derive(Debug, Clone)]
pub struct StabilityScene {
    /// Side of a region (m).
    pub region_size: f64,
    /// South-west corner: north, east (m).
    pub origin: [f64; 2],
    /// Corners to the north and east.
    pub corners: [usize; 2],
    /// Words of the corners, east fastest.
    pub words: Vec<CornerWords>,
    /// Craters on the ground.
    pub craters: Vec<Crater>,
    /// Direction of the sun's light.
    pub sun: Sun,
    /// Foot of the eye: north, east (m).
    pub foot: [f64; 2],
    /// Eye above the ground (m).
    pub above: f64,
    /// Roll, pitch, heading (rad).
    pub attitude: Attitude,
    /// Angle of the yoke (rad).
    pub yoke: f64,
    /// Sweeps a frame, and columns.
    pub sweeps: u32,
    /// Number of samples per sweep.
    pub samples: u32,
    /// Field of view of the picture.
    pub field: FieldOfView,
    /// Ground-range programme of the sweeps.
    pub range: RangeProgramme,
}

impl StabilityScene {
    /// The first frame of `subject`, on a small raster and over its finest level.
    pub fn of(subject: &Subject) -> Self {
        let (stage, (_, pose)) = (&subject.stage, &subject.frames[0]);
        let (level, [x, y, height]) = (stage.landscape.level(), pose.eye);
        Self {
            region_size: level.region_size(),
            origin: level.origin(),
            corners: level.corners(),
            words: level.words().to_vec(),
            craters: stage.landscape.features().craters().iter().collect(),
            sun: stage.scenery.sun(pose.time),
            foot: [x, y],
            above: height - stage.landscape.height(x, y).unwrap_or(height),
            attitude: pose.attitude,
            yoke: 0.0,
            sweeps: SWEEPS,
            samples: SAMPLES,
            field: stage.settings.raster.field,
            range: stage.settings.range,
        }
    }

    /// Multiplies every word: heights and slopes together.
    pub fn scale_words(&mut self, factor: f64) {
        self.words.iter_mut().flatten().for_each(|word| *word *= factor);
    }

    /// Gives every corner its words, by its number to the north and to the east.
    pub fn set_words(&mut self, words: impl Fn(usize, usize) -> CornerWords) {
        let row = self.corners[1];
        self.words.iter_mut().enumerate().for_each(|(index, set)| *set = words(index / row, index % row));
    }

    /// The corner south-west of the foot: north, east (m).
    pub fn corner(&self) -> [f64; 2] {
        [0, 1].map(|axis| {
            let regions = ((self.foot[axis] - self.origin[axis]) / self.region_size).floor();
            self.origin[axis] + regions * self.region_size
        })
    }

    /// Largest height of a corner (m).
    pub fn highest(&self) -> f64 {
        self.words.iter().map(|words| words[0].abs()).fold(0.0, f64::max)
    }

    /// Largest slope of a corner, or of the way up from a corner of height 0 to the highest.
    pub fn steepest(&self) -> f64 {
        // Steepest in the middle, 15/8 of the mean.
        let along = |words: &CornerWords| words[1].abs().max(words[3].abs()) / self.region_size;
        let between = 1.875 * self.highest() / self.region_size;
        self.words.iter().map(along).fold(between, f64::max)
    }

    /// Farthest that any of the ground lies (m).
    pub fn reach(&self) -> f64 {
        let [north, east] = self.corners.map(|corners| corners as f64 * self.region_size);
        (north * north + east * east).sqrt()
    }

    /// Whether the nadir or the zenith comes within ten degrees of the picture: there is no way to lay sweeps about it, and
    /// a machine must say so.
    pub fn nears_the_zenith(&self) -> bool {
        let half_height = libm::atan(self.field.tan_half_height);
        self.attitude.pitch.abs() + half_height >= radians(80.0)
    }

    /// MachineStage and pose on `model`.
    ///
    /// # Errors
    /// If it cannot be: the message of the crate that refuses.
    pub fn build(&self, model: &HardwareModel, scalar: Scalar) -> Result<(MachineStage, Pose), String> {
        let said = |error: &dyn std::fmt::Display| error.to_string();
        let level = Level::new(self.region_size, self.origin, self.corners, self.words.clone());
        let bank = Bank::new("stability", vec![level.map_err(|e| said(&e))?], None).map_err(|e| said(&e))?;
        let landscape = Landscape::new(bank, 1.0).with_features(Features::new(self.craters.clone()));
        let [x, y] = self.foot;
        // Beyond the area there is no ground to stand on; the machine says so.
        let ground = landscape.height(x, y).unwrap_or(0.0);
        let pose =
            Pose { time: 0.0, eye: [x, y, ground + self.above], attitude: self.attitude, yoke: self.yoke };
        let wishes = RasterWishes {
            sweeps: Some(self.sweeps),
            samples: Some(self.samples),
            columns: Some(self.sweeps),
            lines: Some(LINES),
            ..RasterWishes::default()
        };
        let display = Display { white: 1.0, gamma: 1.0 };
        let laws = LawWishes::default();
        let settings = Settings::resolve(model, self.field, wishes, Some(self.range), laws, scalar, display);
        let settings = settings.map_err(|error| said(&error))?;
        let scenery = Scenery::still(self.sun).with_course(vec![pose]);
        Ok((MachineStage { landscape: Arc::new(landscape), scenery: Arc::new(scenery), settings }, pose))
    }
}
