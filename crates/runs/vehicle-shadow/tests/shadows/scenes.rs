//! Shots, vehicles and grounds for the tests.

use std::sync::Arc;

use generator::Stage;
use glam::DVec3;
use hardware_model::{HardwareModel, Raster, Settings};
use landscape::{Attitude, Bank, Landscape, Level, Sun};
use quantities::{Rate, Timebase, radians, unit_interval};
use scenario::{
    Curvature, Display, FieldOfView, LawWishes, Laws, PixelRule, RangeLaw, RangeProgramme, RasterWishes,
    Scalar, Scenery, ShadowFineness,
};
use solids::{Body, Solid};
use vehicle_shadow::Shot;

/// The report's screen, 50 x 30 degrees.
pub fn field() -> FieldOfView {
    FieldOfView { tan_half_width: libm::tan(radians(25.0)), tan_half_height: libm::tan(radians(15.0)) }
}

/// Direction to the sun, degrees.
pub fn to_sun(azimuth: f64, elevation: f64) -> DVec3 {
    DVec3::from_array(sun(azimuth, elevation).direction())
}

/// Returns a sun at this azimuth and elevation (degrees).
pub fn sun(azimuth: f64, elevation: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
}

/// A shot `height` (m) above the ground, its camera fixed to the vehicle; roll, pitch, heading in degrees.
pub fn shot(eye: [f64; 3], height: f64, [roll, pitch, heading]: [f64; 3]) -> Shot {
    let vehicle = Attitude { roll: radians(roll), pitch: radians(pitch), heading: radians(heading) };
    Shot { time: 0.0, eye, height, vehicle, camera: vehicle, field: field() }
}

/// The convex hull of `count` random points in a box of these half sizes (m) around `middle`.
pub fn stone(seed: u64, count: u64, middle: DVec3, half: DVec3) -> Option<Solid> {
    let part = |index: u64, axis: u64| 2.0 * unit_interval(seed, &[index, axis]) - 1.0;
    let point = |index| middle + half * DVec3::new(part(index, 0), part(index, 1), part(index, 2));
    Solid::hull(&(0..count).map(point).collect::<Vec<_>>(), 1.0).ok()
}

/// Whether the line from a place to the sun meets the body, or begins in it: face by face.
pub fn lies_behind(body: &Body, place: DVec3, to_sun: DVec3) -> bool {
    let (mut enters, mut leaves) = (0.0f64, f64::INFINITY);
    for (face, normal) in body.normals().enumerate() {
        let (outside, rate) = (normal.dot(place - body.on_face(face)), normal.dot(to_sun));
        if rate > 0.0 {
            leaves = leaves.min(-outside / rate);
        } else if rate < 0.0 {
            enters = enters.max(outside / -rate);
        } else if outside > 0.0 {
            return false;
        }
    }
    enters <= leaves
}

/// The place of flat ground that is seen through (x, y).
pub fn on_flat_ground(shot: &Shot, x: f64, y: f64) -> Option<DVec3> {
    let ray = shot.ray(x, y);
    (ray.z < 0.0).then(|| DVec3::from_array(shot.eye) + ray * (shot.height / -ray.z))
}

/// Level ground, 480 m x 480 m.
pub fn flat() -> Arc<Landscape> {
    landscape(|_, _, _| 0.0)
}

/// Random ground, its words up to `relief` (m): slopes of `relief` / 8 and more.
pub fn bumps(seed: u64, relief: f64) -> Arc<Landscape> {
    landscape(|m, n, k| relief * (2.0 * unit_interval(seed, &[m, n, k]) - 1.0))
}

fn landscape(word: impl Fn(u64, u64, u64) -> f64) -> Arc<Landscape> {
    let words = |index: u64| std::array::from_fn(|k| word(index / 61, index % 61, k as u64));
    let level = Level::new(8.0, [0.0; 2], [61, 61], (0..61 * 61).map(words).collect()).unwrap();
    Arc::new(Landscape::new(Bank::new("test", vec![level], None).unwrap(), 1.0))
}

/// A stage of `columns` x `lines` with shadows, over a flat lunoid.
pub fn stage(landscape: &Arc<Landscape>, scenery: Scenery, [columns, lines]: [u32; 2]) -> Stage {
    let update = Rate::new(30, 1).unwrap();
    let ideal = Settings::resolve(
        &HardwareModel::ideal(),
        field(),
        RasterWishes::default(),
        None,
        LawWishes::default(),
        Scalar::F64,
        Display { white: 1.0, gamma: 1.0 },
    );
    let settings = Settings {
        raster: Raster { sweeps: columns, samples: 1000, columns, lines, field: field(), refresh: update },
        timebase: Timebase::new(Rate::new(10_000_000, 1).unwrap(), update, columns, 1000, 250).unwrap(),
        range: RangeProgramme { law: RangeLaw::Geometric, start: 0.5, end: 400.0 },
        laws: Laws { curvature: Curvature::None, pixel_rule: PixelRule::Centre, ..Laws::default() },
        shadows: Some(ShadowFineness::default()),
        ..ideal.unwrap()
    };
    Stage { landscape: Arc::clone(landscape), scenery: Arc::new(scenery), view: settings.view() }
}
