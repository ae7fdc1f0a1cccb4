//! Scenes for the tests.

use std::sync::Arc;

use exact::{Exact, Ray, View};
use features::{Crater, Features, Shape};
use generator::{Generator, PlaneKind, Planes, Session, Stage};
use glam::{DMat3, DVec3};
use hardware_model::{HardwareModel, Raster, Settings};
use landscape::{Attitude, Bank, CornerWords, Landscape, Level, Sun};
use quantities::{Rate, Timebase, radians, unit_interval};
use scenario::{
    Curvature, Display, FieldOfView, LawWishes, Laws, Occlusion, PixelRule, Pose, Projection, RangeLaw,
    RangeProgramme, RasterWishes, Scalar, Scenery, Standing,
};
use signal::Probe;
use solids::{Body, Kind, Solid};

/// Law switches with the two that a test varies.
pub fn laws(projection: Projection, curvature: Curvature, pixel_rule: PixelRule) -> Laws {
    Laws { projection, curvature, occlusion: Occlusion::PeakHold, pixel_rule, ..Laws::default() }
}

/// Settings for a raster, laws and near and far range (m).
pub fn settings(columns: u32, lines: u32, laws: Laws, [start, end]: [f64; 2]) -> Settings {
    let update = Rate::new(30, 1).unwrap();
    let field =
        FieldOfView { tan_half_width: libm::tan(radians(25.0)), tan_half_height: libm::tan(radians(15.0)) };
    let ideal = Settings::resolve(
        &HardwareModel::ideal(),
        field,
        RasterWishes::default(),
        None,
        LawWishes::default(),
        Scalar::F64,
        Display { white: 1.0, gamma: 1.0 },
    );
    Settings {
        raster: Raster { sweeps: columns, samples: 1000, columns, lines, field, refresh: update },
        timebase: Timebase::new(Rate::new(10_000_000, 1).unwrap(), update, columns, 1000, 250).unwrap(),
        range: RangeProgramme { law: RangeLaw::Geometric, start, end },
        laws,
        ..ideal.expect("the ideal model is consistent")
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

/// Prepares `exact` for a stage under one still sun.
pub fn prepare(landscape: Arc<Landscape>, sun: Sun, settings: &Settings) -> Box<dyn Session> {
    Exact.prepare(Stage { landscape, scenery: Arc::new(Scenery::still(sun)), view: settings.view() }).unwrap()
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

/// All planes of one frame.
pub fn planes(landscape: &Arc<Landscape>, scenery: Scenery, settings: &Settings, pose: &Pose) -> Planes {
    let Raster { columns, lines, .. } = settings.raster;
    let stage = Stage { landscape: Arc::clone(landscape), scenery: Arc::new(scenery), view: settings.view() };
    let mut planes = Planes::new(columns as usize, lines as usize, &PlaneKind::ALL);
    Exact.prepare(stage).unwrap().frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

/// One value of a plane, as f64.
pub fn value(planes: &Planes, kind: PlaneKind, index: usize) -> f64 {
    f64::from(planes.get(kind).unwrap()[index])
}

/// The ray through the centre of a pixel, counted row by row, under the settings' projection.
pub fn ray(settings: &Settings, pose: &Pose, index: usize) -> Ray {
    let Raster { columns, lines, field, .. } = settings.raster;
    let (column, line) = (index as u32 % columns, index as u32 / columns);
    let x = field.tan_half_width * (f64::from(2 * column + 1) / f64::from(columns) - 1.0);
    let y = field.tan_half_height * (f64::from(2 * line + 1) / f64::from(lines) - 1.0);
    View::new(settings.laws.projection, &pose.attitude).with_yoke(pose.yoke).ray(x, y)
}

/// The place that a pixel shows (m), from its range.
pub fn place(settings: &Settings, pose: &Pose, index: usize, range: f64) -> [f64; 2] {
    let ray = ray(settings, pose, index);
    std::array::from_fn(|axis| pose.eye[axis] + range * ray.direction[axis])
}

/// `count` craters of all three types, radii up to `size` (m), anywhere within 48 m x 48 m: many inside others.
pub fn crater_field(seed: u64, count: u64, size: f64) -> Features {
    let crater = |index: u64| {
        let part = |k: u64| unit_interval(seed, &[index, k]);
        let centre = [48.0 * part(0), 48.0 * part(1)];
        let r1 = size * (0.05 + 0.5 * part(2) * part(2));
        let [r2, r3] = [r1 * (1.1 + part(3)), r1 * (2.2 + part(4))];
        let (depth, rim) = (0.4 * r1 * part(5), 0.1 * r1 * part(6));
        match index % 3 {
            0 => Crater::new(centre, Shape::Bowl { r1 }, depth, 0.0),
            1 => Crater::new(centre, Shape::RimmedBowl { r1, r2 }, depth, rim),
            _ => Crater::new(centre, Shape::FlatFloor { r1, r2, r3 }, depth, rim),
        }
    };
    Features::new((0..count).map(|index| crater(index).unwrap()).collect())
}

/// A box of albedo 1 with its foot point in the middle of its base, turned by no angle.
pub fn standing_box(object: u32, foot: [f64; 3], half_width: f64, height: f64) -> Standing {
    sunk_box(object, foot, half_width, [0.0, height])
}

/// The same from `low` to `high` above its foot point (m).
pub fn sunk_box(object: u32, foot: [f64; 3], half_width: f64, [low, high]: [f64; 2]) -> Standing {
    let (low, high) = (DVec3::new(-half_width, -half_width, low), DVec3::new(half_width, half_width, high));
    let solid = Arc::new(Solid::boxed(low, high, 1.0).unwrap());
    let foot = DVec3::from_array(foot);
    let body = Body::place(object, Kind::Culture, &solid, foot, &DMat3::IDENTITY, 1.0);
    Standing { from: 0.0, until: f64::INFINITY, body }
}
