//! Draws the pictures of `docs/artefacts.md` whose faults need a scene of their own: the clean frame on the left, the
//! faulty one on the right.
//!
//! `cargo run --release -p lunoid-tests --example fault_pictures FOLDER`

use machine::Prepare;
use std::env;
use std::path::{Path, PathBuf};

use generator::{PlaneKind, Planes};
use hardware_model::{HardwareModel, ModelSource};
use lunoid_tests::shipped::folder;
use picture::{Depth, Encoder, GreyPicture, Transfer, beside, write_png};
use quantities::{Rate, radians};
use scenario::{Pose, PoseTable, RollDisplay, Scenario, Waypoint};
use signal::Probe;

/// A scenario, changed, and the frames that are looked at, clean and faulty, which are laid over one another as an eye does
/// that stands still.
struct Show {
    overlay: &'static str,
    scenario: &'static str,
    frames: [&'static [u64]; 2],
    change: fn(&mut Scenario),
}

const SHOWS: [Show; 6] = [
    Show { overlay: "starve", scenario: "first-light", frames: [&[24]; 2], change: turn },
    Show { overlay: "slew", scenario: "lunar-horizon", frames: [&[0]; 2], change: hurry },
    Show { overlay: "blur", scenario: "range-programmes", frames: [&[0]; 2], change: |_| {} },
    Show { overlay: "roll", scenario: "rough-ride", frames: [&[21]; 2], change: lean },
    Show { overlay: "jerk", scenario: "craters", frames: [&[36, 37, 38, 39], &[12, 13]], change: look_round },
    Show { overlay: "band", scenario: "two-levels-blended", frames: [&[0]; 2], change: |_| {} },
];

/// A turn on the spot of 50 degrees a second.
fn turn(scenario: &mut Scenario) {
    turn_by(scenario, 50.0);
}

/// A turn of 10 degrees a second, at the rates of the machine.
fn look_round(scenario: &mut Scenario) {
    turn_by(scenario, 10.0);
    (scenario.raster.update, scenario.raster.refresh) = (None, None);
}

fn turn_by(scenario: &mut Scenario, rate: f64) {
    let first = scenario.path.waypoints()[0];
    let start = first.heading.unwrap_or(0.0);
    let point = |k: u32| {
        let time = 0.25 * f64::from(k);
        Waypoint { time, heading: Some(start + radians(rate * time)), ..first }
    };
    scenario.path = scenario::Path::new((0..25).map(point).collect()).expect("a turn");
    scenario.path_file = None;
    scenario.raster.update = Rate::new(30, 1);
}

/// Sweeps of 33 µs.
fn hurry(scenario: &mut Scenario) {
    (scenario.raster.update, scenario.raster.refresh) = (Rate::new(75, 1), Rate::new(75, 1));
}

fn lean(scenario: &mut Scenario) {
    scenario.roll = RollDisplay::Yoke;
    (scenario.raster.update, scenario.raster.refresh) = (Rate::new(30, 1), Rate::new(30, 1));
}

fn main() {
    let to = PathBuf::from(env::args().nth(1).unwrap_or_else(|| "docs/pictures/faults".into()));
    for show in SHOWS {
        let [clean, faulty] = [None, Some(show.overlay)].map(|overlay| show.draw(overlay));
        let both = beside(&[&clean, &faulty]).expect("pictures of one size");
        let file = to.join(format!("{}.png", show.overlay));
        write_png(&file, &both, &[]).unwrap_or_else(|e| panic!("{e}"));
        println!("{}", file.display());
    }
}

impl Show {
    fn draw(&self, overlay: Option<&str>) -> GreyPicture {
        let mut scenario = Scenario::read(folder().join(format!("{}.toml", self.scenario)))
            .unwrap_or_else(|e| panic!("{e}"));
        (scenario.raster.sweeps, scenario.raster.columns, scenario.raster.lines) = (Some(400), None, None);
        (self.change)(&mut scenario);
        let file = |name: &str| Path::new("hardware-models/faults").join(format!("{name}.toml"));
        let overlays: Vec<PathBuf> = overlay.into_iter().map(file).collect();
        let ideal = ModelSource::BuiltIn("ideal".into());
        let model = HardwareModel::load(&ideal, &overlays, &[]).unwrap_or_else(|e| panic!("{e}")).model;
        let settings = front_door::settings(&scenario, &model).unwrap_or_else(|e| panic!("{e}"));
        let stage = front_door::build(&scenario, settings.clone()).unwrap_or_else(|e| panic!("{e}"));
        let (update, yoke) = (settings.timebase.update, settings.yoke);
        let pose = |frame: u64| -> Pose {
            let table = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, frame..frame + 1);
            table.unwrap_or_else(|e| panic!("{e}")).rows()[0].pose
        };
        let (columns, lines) = (settings.raster.columns as usize, settings.raster.lines as usize);
        let frames = self.frames[usize::from(overlay.is_some())];
        let poses: Vec<Pose> = frames.iter().map(|&frame| pose(frame)).collect();
        let session = stage.prepare();
        let mut sum = vec![0.0; columns * lines];
        for (&frame, pose) in frames.iter().zip(&poses) {
            let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
            session.frame(frame, pose, &mut planes, &mut Probe::off()).expect("a shipped frame");
            let plane = planes.get(PlaneKind::Intensity).expect("asked for");
            sum.iter_mut().zip(plane).for_each(|(sum, value)| *sum += value / frames.len() as f32);
        }
        let display = settings.display;
        let transfer = Transfer::new(display.white as f32, display.gamma as f32).expect("a display");
        Encoder::new(transfer, Depth::Eight).encode(&sum, columns, lines).expect("no NaN reaches a frame")
    }
}
