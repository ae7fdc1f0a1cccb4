//! `cartridge.toml`, as `README.md` describes it.

use hardware_model::{HardwareModel, LatePolicy, Loader};
use landscape::Sun;
use lunoid_tests::Scene;
use quantities::radians;
use scenario::{Curvature, Occlusion, PixelRule, Projection, RangeLaw, RangeProgramme};
use serde::Deserialize;
use toml::{Table, Value};

use crate::ground::Ground;
use crate::reading::Reading;

const FORMAT: u32 = 1;

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: u32,
    /// For people.
    #[serde(rename = "title")]
    _title: String,
    scene: Table,
    expect: Vec<Expect>,
    #[serde(default)]
    must_fail: Vec<Overlay>,
}

/// A cartridge.
#[derive(Debug, Clone)]
pub struct Cartridge {
    pub scene: SceneFile,
    pub expect: Vec<Expect>,
    pub must_fail: Vec<Overlay>,
    /// The scene as written: what overlays are laid over.
    table: Table,
}

/// What is drawn on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    MachineF64,
    MachineF32,
    Exact,
}

impl Model {
    pub const ALL: [Self; 3] = [Self::MachineF64, Self::MachineF32, Self::Exact];
}

/// One answer.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expect {
    pub read: Reading,
    pub tolerance: f64,
    #[serde(rename = "because")]
    _because: String,
    #[serde(rename = "derivation")]
    _derivation: String,
    pub models: Vec<Model>,
}

/// A change of the scene under which the answers must not come out.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Overlay {
    scene: Table,
    pub because: String,
    pub models: Vec<Model>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    pub region_size_m: f64,
    pub corners: [usize; 2],
    pub ground: Ground,
    pub albedo: f64,
    pub sun_elevation_deg: f64,
    pub sun_azimuth_deg: f64,
    /// North, east, height above the datum.
    pub eye_m: [f64; 3],
    pub headings_deg: Vec<f64>,
    pub pitch_deg: f64,
    pub sweeps: u32,
    pub samples: u32,
    pub lines: u32,
    pub range: RangeKeys,
    pub laws: LawKeys,
    pub loader: LoaderKeys,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RangeKeys {
    law: RangeWord,
    start_m: f64,
    end_m: f64,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum RangeWord {
    ConstantRate,
    ConstantElevation,
    Geometric,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawKeys {
    projection: ProjectionWord,
    curvature: CurvatureWord,
    occlusion: OcclusionWord,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ProjectionWord {
    AsReported,
    Corrected,
    Exact,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum CurvatureWord {
    None,
    Parabolic,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum OcclusionWord {
    Derivative,
    PeakHold,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LoaderKeys {
    access_ticks: u64,
    late_policy: PolicyWord,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum PolicyWord {
    StrobeThrough,
    Latched,
}

impl Cartridge {
    /// Reads a file; unknown keys, missing keys and other formats are refused.
    pub fn parse(text: &str) -> Result<Self, String> {
        let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
        if file.format != FORMAT {
            return Err(format!("format = {}: expected {FORMAT}", file.format));
        }
        let scene = file.scene.clone().try_into().map_err(|error| format!("scene: {error}"))?;
        Ok(Self { scene, expect: file.expect, must_fail: file.must_fail, table: file.scene })
    }
}

impl Overlay {
    /// The cartridge's scene with this laid over it.
    pub fn over(&self, cartridge: &Cartridge) -> Result<SceneFile, String> {
        let mut table = cartridge.table.clone();
        lay(&self.scene, &mut table);
        table.try_into().map_err(|error| error.to_string())
    }
}

fn lay(overlay: &Table, table: &mut Table) {
    for (key, value) in overlay {
        match (value, table.get_mut(key)) {
            (Value::Table(overlay), Some(Value::Table(below))) => lay(overlay, below),
            _ => {
                table.insert(key.clone(), value.clone());
            }
        }
    }
}

/// One heading and one ground of a scene file.
#[derive(Debug, Clone)]
pub struct Variant {
    pub file: SceneFile,
    pub ground: Ground,
    pub heading_deg: f64,
}

impl SceneFile {
    /// Every ground under every heading.
    pub fn variants(&self) -> Vec<Variant> {
        let grounds = self.ground.variants();
        let under = |ground: &Ground| {
            let one =
                |&heading_deg: &f64| Variant { file: self.clone(), ground: ground.clone(), heading_deg };
            self.headings_deg.iter().map(one).collect::<Vec<_>>()
        };
        grounds.iter().flat_map(under).collect()
    }
}

impl Variant {
    /// For messages.
    pub fn what(&self) -> String {
        format!("heading {} deg, {:?}", self.heading_deg, self.ground)
    }

    /// The scene to draw; its pixel rule is the line's mean.
    pub fn scene(&self) -> Scene {
        let file = &self.file;
        let mut scene = Scene::over(self.ground.level(file.region_size_m, file.corners));
        scene.albedo = file.albedo;
        scene.sun =
            Sun { elevation: radians(file.sun_elevation_deg), azimuth: radians(file.sun_azimuth_deg) };
        scene.eye = file.eye_m;
        scene.heading = radians(self.heading_deg);
        scene.pitch = radians(file.pitch_deg);
        (scene.sweeps, scene.samples, scene.lines) = (file.sweeps, file.samples, file.lines);
        scene.range = file.range.programme();
        scene.laws.projection = match file.laws.projection {
            ProjectionWord::AsReported => Projection::AsReported,
            ProjectionWord::Corrected => Projection::Corrected,
            ProjectionWord::Exact => Projection::Exact,
        };
        scene.laws.curvature = match file.laws.curvature {
            CurvatureWord::None => Curvature::None,
            CurvatureWord::Parabolic => Curvature::Parabolic,
        };
        scene.laws.occlusion = match file.laws.occlusion {
            OcclusionWord::Derivative => Occlusion::Derivative,
            OcclusionWord::PeakHold => Occlusion::PeakHold,
        };
        scene.laws.pixel_rule = PixelRule::LineMean;
        scene.loader = file.loader.loader();
        scene
    }
}

impl RangeKeys {
    fn programme(self) -> RangeProgramme {
        let law = match self.law {
            RangeWord::ConstantRate => RangeLaw::ConstantRate,
            RangeWord::ConstantElevation => RangeLaw::ConstantElevation,
            RangeWord::Geometric => RangeLaw::Geometric,
        };
        RangeProgramme { law, start: self.start_m, end: self.end_m }
    }
}

impl LoaderKeys {
    fn loader(self) -> Loader {
        let late_policy = match self.late_policy {
            PolicyWord::StrobeThrough => LatePolicy::StrobeThrough,
            PolicyWord::Latched => LatePolicy::Latched,
        };
        Loader { access: self.access_ticks, late_policy, ..HardwareModel::ideal().loader }
    }
}
