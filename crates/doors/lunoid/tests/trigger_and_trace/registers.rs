//! Registers at an instant are those that the terrain generator itself keeps.

use std::path::Path;

use hardware_model::{HardwareModel, ModelSource};
use landscape::CornerWords;
use machine::ControlPlane;
use quantities::SweepTime;
use scenario::{PoseTable, Scenario};
use serde_json::Value;
use sweep_program::SweepProgram;
use terrain_generator::Registers;

use crate::scene::Scene;
use crate::{NOMINAL, json};

const FRAME: u64 = 2;

/// The digital side of `tiny.toml` as the command makes it.
fn control(scene: &Scene) -> (ControlPlane, scenario::Pose) {
    let scenario = Scenario::read(scene.join("tiny.toml")).unwrap();
    let source = ModelSource::find("pra-nominal", Path::new("")).unwrap();
    let set = [("buffer.words", "unlimited"), ("loader.access_ns", "100000")]
        .map(|(key, value)| (key.into(), value.into()));
    let model = HardwareModel::load(&source, &[], &set).unwrap().model;
    let stage = front_door::build(&scenario, front_door::settings(&scenario, &model).unwrap()).unwrap();
    let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
    let rows = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, FRAME..FRAME + 1).unwrap();
    (ControlPlane::new(stage), rows.rows()[0].pose)
}

/// The registers by the terrain generator, after all that happens up to `time`.
fn of_generator(program: &SweepProgram, buffer: &[CornerWords], time: f64) -> Registers {
    let mut registers = Registers::at_start(program);
    for step in program.steps.iter().take_while(|step| step.time <= SweepTime(time)) {
        registers.apply(step, buffer);
    }
    registers
}

fn at(scene: &Scene, place: &str) -> Value {
    let frame = FRAME.to_string();
    let command = ["trace", "tiny.toml", "--frame", &frame, "--json", "--at", place];
    json(&scene.expect(0, &[&command[..], &NOMINAL].concat()).0)
}

#[test]
fn they_hold_the_words_of_the_terrain_generator() {
    let scene = Scene::new();
    let (control, pose) = control(&scene);
    let sweeps = control.sweeps(FRAME, &pose).unwrap();
    let scenario = Scenario::read(scene.join("tiny.toml")).unwrap();
    let model =
        HardwareModel::load(&ModelSource::find("ideal", Path::new("")).unwrap(), &[], &[]).unwrap().model;
    let stage = front_door::build(&scenario, front_door::settings(&scenario, &model).unwrap()).unwrap();
    let level = stage.landscape.level();
    let buffer = level.words();
    let mut stale = 0;
    let anywhere = [(0, 0.0), (0, 79.0), (3, 31.25), (17, 62.5), (25, 55.125), (39, 70.0)];
    // Just after a stop that found words missing, the hold register is wrong.
    let first_miss = |sweep: u32| Some((sweep, sweeps.programs(sweep)[0].misses.first()?.time.0 + 0.01));
    let missed = (0..40).step_by(6).filter_map(first_miss).filter(|(_, sample)| *sample < 80.0);
    for (sweep, sample) in anywhere.into_iter().chain(missed) {
        let told = at(&scene, &format!("{sweep}:{sample}"));
        let level_told = &told["levels"][0];
        let program = &sweeps.programs(sweep)[0];
        let expected = of_generator(program, buffer, sample);
        let polarity = expected.polarity().map(Value::from);
        assert_eq!((&level_told["polarity"][0], &level_told["polarity"][1]), (&polarity[0], &polarity[1]));
        assert_eq!(level_told["folds"], serde_json::json!(expected.folds()), "{sweep}:{sample}");
        for (colour, words) in expected.hold(buffer).into_iter().enumerate() {
            let register = &level_told["registers"][3 * colour];
            assert_eq!(register["register"], "hold");
            stale += register["stale"].as_u64().unwrap().count_ones();
            for (number, word) in words.iter().enumerate() {
                let [m, n] = [0, 1].map(|axis| register["words"][number][axis].as_i64().unwrap());
                assert_eq!(
                    buffer[level.clamped_index(m, n)][number],
                    *word,
                    "{sweep}:{sample} colour {colour} word {number}"
                );
            }
        }
    }
    // The machine is slow enough that some words are not those that the region asks for.
    assert!(stale > 0);
}

/// A tick and the sample that falls on it are one instant; ticks on either side of a stop differ.
#[test]
fn a_tick_is_an_instant_of_its_sweep() {
    let scene = Scene::new();
    let frame = FRAME.to_string();
    let stops = ["trace", "tiny.toml", "--frame", &frame, "--sweep", "11", "--event", "stop", "--json"];
    let listing = json(&scene.expect(0, &[&stops[..], &NOMINAL].concat()).0);
    let stop = &listing["events"][2];
    let tick = stop["tick"].as_u64().unwrap();
    let [before, then] = [tick - 1, tick].map(|tick| at(&scene, &tick.to_string()));
    assert_eq!((&then["sweep"], &then["tick"]), (&Value::from(11), &Value::from(tick)));
    let axis = usize::from(stop["axis"] == "y");
    let folds = |state: &Value| state["levels"][0]["folds"][axis].as_u64().unwrap();
    let polarity = |state: &Value| state["levels"][0]["polarity"][axis].as_f64().unwrap();
    assert_eq!((folds(&before) + 1, polarity(&before)), (folds(&then), -polarity(&then)));
    let sample = then["sample"].as_f64().unwrap();
    assert_eq!(at(&scene, &format!("11:{sample}"))["levels"], then["levels"]);
    let text = ["trace", "tiny.toml", "--frame", &frame, "--at", &tick.to_string()];
    let (out, _) = scene.expect(0, &[&text[..], &NOMINAL].concat());
    assert!(
        out.contains("fine level at ") && out.contains("yellow hold") && out.contains("red y-first"),
        "{out}"
    );
}
