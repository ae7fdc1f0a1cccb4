//! Scenes for the tests.

use std::sync::Arc;

use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Session, Stage};
use hardware_model::{
    Economy, FeatureParts, LatePolicy, Loader, MixingParts, Raster, Settings, ShadowParts, SweepMemoryKind,
};
use landscape::{Attitude, Bank, CornerWords, Landscape, Level, Sun};
use quantities::{Rate, Timebase, radians, unit_interval};
use scenario::{
    Curvature, Display, FieldOfView, Laws, Occlusion, PixelRule, Pose, Projection, RangeLaw, RangeProgramme,
    Scalar, Scenery,
};
use signal::Probe;

/// Law switches with the two that a test varies.
pub fn laws(projection: Projection, curvature: Curvature, pixel_rule: PixelRule) -> Laws {
    Laws { projection, curvature, occlusion: Occlusion::PeakHold, pixel_rule, ..Laws::default() }
}

/// Settings for a raster, laws and near and far range (m).
pub fn settings(columns: u32, lines: u32, laws: Laws, [start, end]: [f64; 2]) -> Settings {
    let update = Rate::new(30, 1).unwrap();
    let field =
        FieldOfView { tan_half_width: libm::tan(radians(25.0)), tan_half_height: libm::tan(radians(15.0)) };
    Settings {
        raster: Raster { sweeps: columns, samples: 1000, columns, lines, field, refresh: update },
        timebase: Timebase::new(Rate::new(10_000_000, 1).unwrap(), update, columns, 1000, 250).unwrap(),
        range: RangeProgramme { law: RangeLaw::Geometric, start, end },
        laws,
        scalar: Scalar::F64,
        display: Display { white: 1.0, gamma: 1.0 },
        loader: Loader { access_ticks: 0, late_policy: LatePolicy::Latched, delays: Vec::new() },
        sweep_memory: SweepMemoryKind::ScanConverter,
        feature_generator: FeatureParts::default(),
        shadow_controller: ShadowParts::default(),
        mixing_unit: MixingParts::default(),
        yoke: None,
        levels: None,
        shadows: false,
        economy: Economy::default(),
    }
}

/// A level whose corner (m, n) has the words `corner(m, n)`.
pub fn level(d: f64, regions: [usize; 2], corner: impl Fn(f64, f64) -> CornerWords) -> Level {
    let corners = regions.map(|count| count + 1);
    let words = |index: usize| corner((index / corners[1]) as f64, (index % corners[1]) as f64);
    Level::new(d, [0.0; 2], corners, (0..corners[0] * corners[1]).map(words).collect()).unwrap()
}

/// The ground `height + north x + east y` (m).
pub fn plane(d: f64, regions: [usize; 2], height: f64, [north, east]: [f64; 2]) -> Level {
    level(d, regions, |m, n| {
        let value = height + d * (north * m + east * n);
        [value, d * east, 0.0, d * north, 0.0, 0.0, 0.0, 0.0, 0.0]
    })
}

/// Random ground of 6 x 6 regions of 8 m, words up to `relief` (m).
pub fn bumps(seed: u64, relief: f64) -> Level {
    let word = |m: f64, n: f64, k: usize| unit_interval(seed, &[m as u64, n as u64, k as u64]);
    level(8.0, [6, 6], |m, n| std::array::from_fn(|k| relief * (2.0 * word(m, n, k) - 1.0)))
}

/// A landscape of one level.
pub fn landscape(level: Level, albedo: f64) -> Arc<Landscape> {
    Arc::new(Landscape::new(Bank::new("test", vec![level], None).unwrap(), albedo))
}

/// Sun, azimuth and elevation in degrees.
pub fn sun(azimuth: f64, elevation: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
}

/// A pose; pitch and heading in degrees.
pub fn pose(eye: [f64; 3], pitch: f64, heading: f64) -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(pitch), heading: radians(heading) };
    Pose { time: 0.0, eye, attitude, yoke: 0.0 }
}

/// `exact` made ready.
pub fn prepare(landscape: Arc<Landscape>, sun: Sun, settings: &Settings) -> Box<dyn Session> {
    Exact
        .prepare(Stage { landscape, scenery: Arc::new(Scenery::still(sun)), settings: settings.clone() })
        .unwrap()
}

/// Both planes of one frame: intensity, range.
pub fn draw(landscape: &Arc<Landscape>, sun: Sun, settings: &Settings, pose: &Pose) -> (Vec<f32>, Vec<f32>) {
    let Raster { columns, lines, .. } = settings.raster;
    let mut planes = Planes::new(columns as usize, lines as usize, &[PlaneKind::Intensity, PlaneKind::Range]);
    let session = prepare(Arc::clone(landscape), sun, settings);
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    let plane = |kind| planes.get(kind).unwrap().to_vec();
    (plane(PlaneKind::Intensity), plane(PlaneKind::Range))
}
