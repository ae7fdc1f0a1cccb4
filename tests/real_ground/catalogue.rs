//! LUNSIM over the craters of a catalogue: 160 km x 160 km of 4 to 9 degrees north and east, where a few hundred are
//! listed with their depths.

use std::path::Path;
use std::sync::Arc;

use control_plane::MachineStage;
use features::{Crater, Features, Shape};
use generator::{Generator, PlaneKind, Planes, Shade};
use hardware_model::{HardwareModel, Settings};
use landscape::relief::Relief;
use landscape::{Attitude, Bank, LUNOID_RADIUS, Landscape, Sun};
use lunsim::{Hardware, Lunsim, Parameters};
use quantities::radians;
use scenario::{
    Display, FieldOfView, LawWishes, Pose, RangeLaw, RangeProgramme, RasterWishes, Scalar, Scenery,
    ShadowFineness,
};
use signal::Probe;

use crate::shared;

/// Side of the map (m), and the degrees of its south-west corner.
const SIDE: f64 = 160_000.0;
const CORNER_DEG: f64 = 4.0;

/// Craters of up to 40 km that lie wholly on the map, north and east of its corner. The rim stands 0.036 diameters above
/// the ground, but no more than half of the depth (Pike 1977 for the fresh; our choice for the shallow), and the bowl
/// meets the ground at 0.83 of the radius of the crest.
fn craters(file: &Path) -> Vec<Crater> {
    let text = std::fs::read_to_string(file).expect("a catalogue");
    let metres = |degrees: f64| radians(degrees - CORNER_DEG) * LUNOID_RADIUS;
    let crater = |row: &str| {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |cell: usize| cells[cell].parse::<f64>().expect("a number");
        let (east, north, diameter, depth) = (number(1), number(2), number(3), number(4));
        let (crest, rim) = (0.5 * diameter, (0.036 * diameter).min(0.5 * depth));
        let shape = Shape::RimmedBowl { r1: 0.83 * crest, r2: 1.17 * crest };
        let crater = Crater::new([metres(north), metres(east)], shape, depth - rim, rim).ok()?;
        let inside = |centre: f64| centre >= crater.outer() && centre <= SIDE - crater.outer();
        (diameter < 40_000.0 && crater.centre().into_iter().all(inside)).then_some(crater)
    };
    text.lines().skip(1).filter_map(crater).collect()
}

#[test]
fn lunsim_over_a_real_crater_catalogue() {
    let Some(data) = shared::data() else { return };
    let craters = craters(&data.join("craters/wu2022_craters_0-30E_0-30N.csv"));
    println!("{} craters of the catalogue", craters.len());
    assert!(craters.len() > 300, "{}", craters.len());
    let bank =
        Bank::new("catalogue", vec![Relief::flat(1, [SIDE, SIDE], 4000.0).build().unwrap()], None).unwrap();
    let half = libm::tan(radians(15.0));
    let field = FieldOfView { tan_half_width: half, tan_half_height: half };
    let display = Display { white: 0.7, gamma: 1.0 };
    let raster = RasterWishes { columns: Some(512), ..RasterWishes::default() };
    let (model, laws) = (HardwareModel::ideal(), LawWishes::default());
    let settings = Settings::resolve(&model, field, raster, None, laws, Scalar::F64, display).unwrap();
    let settings = Settings {
        range: RangeProgramme { law: RangeLaw::Geometric, start: 100.0, end: 200_000.0 },
        shadows: Some(ShadowFineness::default()),
        ..settings
    };
    let stage = MachineStage {
        landscape: Arc::new(Landscape::new(bank, 1.0).with_features(Features::new(craters))),
        scenery: Arc::new(Scenery::still(Sun { azimuth: radians(270.0), elevation: radians(12.0) })),
        settings,
    };
    let attitude = Attitude { roll: 0.0, pitch: radians(-60.0), heading: 0.0 };
    let pose = Pose { time: 0.0, eye: [2000.0, 0.5 * SIDE, 140_000.0], attitude, yoke: 0.0 };
    let kinds = [PlaneKind::Intensity, PlaneKind::Shadow, PlaneKind::Range];
    let mut planes = Planes::new(512, 512, &kinds);
    let program = Lunsim { parameters: Parameters::default(), hardware: Hardware::shipped().unwrap() };
    let session = program.prepare(stage.stage()).unwrap();
    let counts = session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
    println!("{} in the viewed area", counts["features"]);
    assert!(counts["features"] > 100, "{counts:?}");
    let plane = |kind| planes.get(kind).unwrap();
    let share = |hits: usize| hits as f64 / (512.0 * 512.0);
    let dark =
        share(plane(PlaneKind::Shadow).iter().filter(|code| **code != f32::from(Shade::Lit.code())).count());
    let sky = share(plane(PlaneKind::Range).iter().filter(|range| range.is_infinite()).count());
    println!("{dark:.4} of the picture in shadow, {sky:.4} sky");
    assert!((0.005..0.2).contains(&dark) && sky < 0.05, "{dark}, {sky}");
    // Level ground, far the most of the picture, has the code nearest to sin 12 degrees.
    let level = 4.0 / 15.0 * 0.7;
    let flat =
        plane(PlaneKind::Intensity).iter().filter(|value| (f64::from(**value) - level).abs() < 1e-6).count();
    assert!(share(flat) > 0.3, "{}", share(flat));
}
