//! A few sweeps of every shipped scenario, under every shipped hardware model, on both engines.
//!
//! Under a model as it is, all blocks of real parts are compared, from the accumulators to the video. With its parts replaced by ideal
//! ones, everything else of the model is: raster, range programme, loader, processor, laws.

use control_plane::MachineStage;
use hardware_model::{HardwareModel, ModelSource, Settings};
use lockstep::{Engines, Report};
use lunoid_tests::shipped::{FULL_LANDSCAPE, TERRAIN, folder};
use scenario::{PoseTable, Scalar, Scenario};

/// Names of all shipped models.
pub const MODELS: [&str; 7] =
    ["ideal", "modern-analog", "pra-frugal", "pra-nominal", "pra-overloaded", "pra-parts", "pra-wires"];
const SWEEPS: u32 = 3;
/// An early frame: what drums hold in a late one takes all frames before it.
const EARLY: u64 = 2;

fn model(name: &str) -> HardwareModel {
    let source = ModelSource::find(name, &folder()).unwrap_or_else(|e| panic!("{e}"));
    HardwareModel::load(&source, &[], &[]).unwrap_or_else(|e| panic!("{e}")).model
}

/// A frame of the scenario `stage` was made for under `settings`: sweeps from the left, the middle and the right.
fn report(stage: &MachineStage, scenario: &Scenario, settings: Settings) -> Report {
    let stage = front_door::under(&stage.stage(), scenario, settings).unwrap_or_else(|e| panic!("{e}"));
    let MachineStage { landscape, settings, .. } = &stage;
    let (update, yoke, sweeps) = (settings.timebase.update, settings.yoke, settings.raster.sweeps);
    let frame = (scenario.frames(update) - 1).min(EARLY);
    let table = PoseTable::resolve(scenario, landscape, update, yoke, frame..frame + 1);
    let pose = table.unwrap_or_else(|e| panic!("{e}")).rows()[0].pose;
    let chosen = (0..SWEEPS).map(|k| (2 * k + 1) * sweeps / (2 * SWEEPS));
    let engines = Engines::new(stage.clone());
    engines.compare(frame, &pose, chosen).expect("a shipped pose")
}

/// The models given, each as it is and with ideal parts. Remote shadow is left out: it takes minutes before the first sweep, and
/// the interpreter is given its gate in any case.
pub fn check(name: &str, models: &[&str]) -> Vec<String> {
    let scenario = Scenario::read(folder().join(format!("{name}.toml"))).unwrap_or_else(|e| panic!("{e}"));
    let ideal_parts = HardwareModel::ideal().analog;
    let settings = |model: &HardwareModel| {
        let settings = front_door::settings(&scenario, model).unwrap_or_else(|e| panic!("{name}: {e}"));
        Settings { shadows: None, scalar: Scalar::F64, ..settings }
    };
    let stage =
        front_door::build(&scenario, settings(&HardwareModel::ideal())).unwrap_or_else(|e| panic!("{e}"));
    let mut differences = Vec::new();
    for &model_name in models {
        let as_it_is = settings(&model(model_name));
        let replaced = Settings { analog: ideal_parts.clone(), ..as_it_is.clone() };
        for (parts, settings) in [("its parts", as_it_is), ("ideal parts", replaced)] {
            let report = report(&stage, &scenario, settings);
            let what = format!("{name}, {model_name}, {parts}");
            assert!(report.events.get("stop").copied().unwrap_or(0) > 0, "{what}: no event was compared");
            for signal in
                ["sweep.x", "tg.product.00", "tg.red.dac0", "tg.sum.u", "tg.height", "tg.reflectivity"]
            {
                assert!(report.signals[signal].samples > 0, "{what}: {signal} was not compared");
            }
            if (model_name, parts) == ("ideal", "ideal parts") {
                for signal in ["mu.reflectivity", "dpp.y", "sm.video"] {
                    assert!(report.signals[signal].samples > 0, "{what}: {signal} was not compared");
                }
            }
            let difference = report.first_difference();
            differences.extend(difference.map(|difference| format!("{what}: {difference}")));
        }
    }
    differences
}

/// A test a scenario, all of them named here: the ideal model and another, in turns.
macro_rules! scenarios {
    ($($test:ident = $name:literal,)*) => {
        /// Names of all shipped scenarios.
        pub const NAMED: &[&str] = &[$($name),*];

        $(#[test]
        fn $test() {
            let place = NAMED.iter().position(|name| *name == $name).expect("it is named");
            let found = check($name, &["ideal", MODELS[1 + place % 6]]);
            assert!(found.is_empty(), "{} differ:\n{}", found.len(), found.join("\n"));
        })*
    };
}

/// As the command compares them where nobody asks for a scalar.
#[test]
fn real_parts_agree_in_f32() {
    let scenario = Scenario::read(folder().join("full-drive.toml")).unwrap_or_else(|e| panic!("{e}"));
    let settings = |model: &str| {
        let settings = front_door::settings(&scenario, &self::model(model)).unwrap_or_else(|e| panic!("{e}"));
        Settings { shadows: None, scalar: Scalar::F32, ..settings }
    };
    let stage = front_door::build(&scenario, settings("ideal")).unwrap_or_else(|e| panic!("{e}"));
    for model in ["pra-parts", "pra-nominal", "pra-frugal", "modern-analog"] {
        let report = report(&stage, &scenario, settings(model));
        for signal in ["tg.height", "tg.reflectivity", "mu.reflectivity", "dpp.hold", "sm.video"] {
            assert!(report.signals[signal].samples > 0, "{model}: {signal} was not compared");
        }
        if let Some(difference) = report.first_difference() {
            panic!("{model}: {difference}");
        }
    }
}

#[test]
fn no_scenario_is_left_out() {
    let all: Vec<&str> = TERRAIN.into_iter().chain(FULL_LANDSCAPE).collect();
    assert_eq!(NAMED, all);
}

scenarios! {
    first_light = "first-light",
    ridge_crossing = "ridge-crossing",
    lunar_horizon = "lunar-horizon",
    low_sun = "low-sun",
    descent = "descent",
    range_programmes = "range-programmes",
    rough_ride = "rough-ride",
    craters = "craters",
    long_shadows = "long-shadows",
    landing_site = "landing-site",
    regolith = "regolith",
    far_mountains = "far-mountains",
    tracks = "tracks",
    moving_sun = "moving-sun",
    lunar_light = "lunar-light",
    showpiece = "showpiece",
    full_drive = "full-drive",
    two_levels_blended = "two-levels-blended",
}
