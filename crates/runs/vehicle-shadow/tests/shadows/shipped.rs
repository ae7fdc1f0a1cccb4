//! The shipped scenario: the figures of its row in `scenarios/README.md` and of the data sheet.

use std::path::{Path, PathBuf};

use hardware_model::HardwareModel;
use quantities::degrees;
use scenario::{PoseTable, Scenario};
use solids::culture;
use vehicle_shadow::{
    Augmentation, GroundLaw, Method, OutlineRule, Shape, Shot, TrueGround, USUAL_TRACKS, Work,
};

const SIZE: [usize; 2] = [1000, 575];

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../scenarios/vehicle-shadow.toml")
}

/// The scenario, its ground, and what its camera, which does not roll, has in each of `frames`.
fn read(frames: &[u64]) -> (Scenario, TrueGround, Vec<Shot>) {
    let scenario = Scenario::read(path()).unwrap();
    let settings = front_door::settings(&scenario, &HardwareModel::ideal()).unwrap();
    let stage = front_door::build(&scenario, settings).unwrap();
    let update = stage.settings.timebase.update;
    let shot = |&frame: &u64| {
        let table = PoseTable::resolve(&scenario, &stage.landscape, update, None, frame..frame + 1).unwrap();
        let pose = table.rows()[0].pose;
        Shot {
            time: pose.time,
            eye: pose.eye,
            height: scenario.vehicle.eye_height,
            vehicle: pose.attitude,
            camera: landscape::Attitude { roll: 0.0, ..pose.attitude },
            field: stage.settings.raster.field,
        }
    };
    let shots = frames.iter().map(shot).collect();
    (scenario, TrueGround::new(stage.stage()).unwrap(), shots)
}

fn augmentation(scenario: &Scenario, ground: GroundLaw) -> Augmentation {
    Augmentation {
        inputs: String::new(),
        shape: Shape::new(culture::model("rover").unwrap(), scenario.vehicle.eye_height),
        eye_height: scenario.vehicle.eye_height,
        sun: scenario.sun.first(),
        penumbra: false,
        ground,
        method: Method::Synchronised { dac_bits: 10 },
    }
}

fn assert_figure(found: f64, table: f64, digit: f64) {
    assert!((found - table).abs() <= 0.5 * digit, "found {found}, the table says {table}");
}

#[test]
fn the_figures_of_the_scenario() {
    let (scenario, ground, shots) = read(&[33, 119]);
    assert_eq!(degrees(scenario.sun.first().unwrap().elevation), 9.0);
    let tracks = USUAL_TRACKS.lay(&scenario.path, &scenario.vehicle, &ground.stage().landscape).unwrap();
    let of =
        |law: GroundLaw, frame: usize| augmentation(&scenario, law).shade(0, &shots[frame], SIZE).unwrap();
    let [parts, walk] = [OutlineRule::Parts, OutlineRule::Walk].map(|rule| of(GroundLaw::Flat(rule), 0));
    let on_ground = |tracks, frame| of(GroundLaw::True { ground: Box::new(ground.clone()), tracks }, frame);
    let found = on_ground(Vec::new(), 0);
    let percent = |work: &Work| 100.0 * work.dark;
    assert_figure(percent(&parts.work), 3.33, 0.01);
    assert_figure(percent(&walk.work), 3.38, 0.01);
    assert_figure(percent(&found.work), 3.30, 0.01);
    let differ = found.shade.shares().iter().zip(parts.shade.shares()).filter(|(a, b)| (*a - *b).abs() > 0.5);
    assert_figure(100.0 * differ.count() as f64 / (SIZE[0] * SIZE[1]) as f64, 0.73, 0.01);
    assert_eq!(parts.work.points, 812);
    assert_eq!((parts.work.intersections, parts.work.line_generators), (2396, 38));
    assert_eq!((walk.work.intersections, walk.work.line_generators), (614, 6));
    let [with, without] = [tracks, Vec::new()].map(|tracks| percent(&on_ground(tracks, 1).work));
    assert_figure(with, 0.27, 0.01);
    assert_eq!(without, 0.0);
}
