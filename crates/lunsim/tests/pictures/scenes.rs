//! Scenes for the tests.

use std::sync::Arc;

use features::{Crater, Features, Shape};
use generator::{Generator, PlaneKind, Planes, PrepareError, Session, Stage};
use hardware_model::{HardwareModel, Raster, Settings};
use landscape::relief::Relief;
use landscape::{Attitude, Bank, Landscape, Sun};
use lunsim::Lunsim;
use quantities::radians;
use scenario::{
    Curvature, Display, FieldOfView, LawWishes, Laws, LunsimRun, PixelRule, Pose, RangeLaw, RangeProgramme,
    RasterWishes, Scalar, Scenery, ShadowFineness,
};
use signal::Probe;

/// Settings of a square picture of `side` pixels and a field of `field_deg`, codes fine enough not to be felt, with
/// remote shadow, on a flat Moon.
pub fn settings(side: u32, field_deg: f64, grid: u32) -> Settings {
    let half = libm::tan(radians(0.5 * field_deg));
    let field = FieldOfView { tan_half_width: half, tan_half_height: half };
    let ideal = Settings::resolve(
        &HardwareModel::ideal(),
        field,
        RasterWishes::default(),
        None,
        LawWishes::default(),
        Scalar::F64,
        Display { white: 1.0, gamma: 1.0 },
    )
    .unwrap();
    Settings {
        raster: Raster { columns: side, lines: side, ..ideal.raster },
        range: RangeProgramme { law: RangeLaw::Geometric, start: 1.0, end: 60_000.0 },
        laws: Laws { curvature: Curvature::None, pixel_rule: PixelRule::Centre, ..Laws::default() },
        shadows: Some(ShadowFineness::default()),
        lunsim: LunsimRun { grid, intensity_codes: 256, restrictions: true },
        ..ideal
    }
}

/// The same with what the program could not do.
pub fn unrestricted(settings: Settings) -> Settings {
    Settings { lunsim: LunsimRun { restrictions: false, ..settings.lunsim }, ..settings }
}

/// Level ground of `side` (m) with craters.
pub fn plain(side: f64, craters: Vec<Crater>) -> Arc<Landscape> {
    relief(&Relief::flat(1, [side, side], side / 40.0), craters)
}

/// Ground of a relief with craters.
pub fn relief(relief: &Relief, craters: Vec<Crater>) -> Arc<Landscape> {
    let bank = Bank::new("test", vec![relief.build().unwrap()], None).unwrap();
    Arc::new(Landscape::new(bank, 1.0).with_features(Features::new(craters)))
}

/// A bowl (type 1).
pub fn bowl(centre: [f64; 2], r1: f64, depth: f64) -> Crater {
    Crater::new(centre, Shape::Bowl { r1 }, depth, 0.0).unwrap()
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

/// A stage under one sun.
pub fn stage(landscape: &Arc<Landscape>, sun: Sun, settings: &Settings) -> Stage {
    Stage {
        landscape: Arc::clone(landscape),
        scenery: Arc::new(Scenery::still(sun)),
        settings: settings.clone(),
    }
}

/// The program made ready.
pub fn prepare(stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
    Lunsim.prepare(stage)
}

/// All planes of one frame.
pub fn draw(landscape: &Arc<Landscape>, sun: Sun, settings: &Settings, pose: &Pose) -> Planes {
    let Raster { columns, lines, .. } = settings.raster;
    let mut planes = Planes::new(columns as usize, lines as usize, &PlaneKind::ALL);
    let session = prepare(stage(landscape, sun, settings)).unwrap();
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

/// One value of a plane, as f64.
pub fn value(planes: &Planes, kind: PlaneKind, [column, line]: [usize; 2]) -> f64 {
    f64::from(planes.get(kind).unwrap()[line * planes.columns() + column])
}
