//! `lunoid lockstep`: a scenario or random scenes on both engines.

use serde_json::Value;

use crate::scene::Scene;

#[test]
fn a_scenario_alone_runs_on_both_engines() {
    let scene = Scene::new();
    let (text, _) = scene.expect(0, &["lockstep", "tiny.toml"]);
    assert!(text.starts_with("Tiny, ideal, frames 0, 2, 3: 24 sweeps on both engines"), "{text}");
    assert!(text.contains("\ntg.height ") && text.contains("\nno difference in "), "{text}");
}

#[test]
fn sweeps_and_parts_are_chosen_on_the_command_line() {
    let scene = Scene::new();
    let chosen = ["lockstep", "tiny.toml", "--frame", "1", "--sweep", "3..7", "-m", "pra-nominal", "--json"];
    let (text, _) = scene.expect(0, &[&chosen[..], &["--ideal-parts", "--scalar", "f64"]].concat());
    let told: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&told["schema"], &told["what"]), (&"lunoid.lockstep/1".into(), &"Tiny, pra-nominal".into()));
    assert_eq!((&told["frames"], &told["sweeps"]), (&Value::from(vec![1]), &Value::from(4)));
    let signals = told["signals"].as_array().unwrap();
    let samples = |row: &Value| row["samples"].as_u64().unwrap();
    let height = signals.iter().find(|row| row["signal"] == "tg.height").unwrap();
    assert!(samples(height) > 0, "{told}");
    assert_eq!(samples(&told), signals.iter().map(samples).sum::<u64>());
    assert!(told["first_difference"].is_null(), "{told}");
}

#[test]
fn random_scenes_need_no_file() {
    let (text, _) = Scene::new().expect(0, &["lockstep", "--random", "2", "--seed", "5"]);
    assert!(text.contains("random scenes of seeds 5..7 in F64") && text.contains("no difference"), "{text}");
}

#[test]
fn what_cannot_be_run() {
    let scene = Scene::new();
    for (wrong, words) in [
        (&["lockstep"][..], "<SCENARIO>"),
        (&["lockstep", "tiny.toml", "--random", "2"], "cannot be used with"),
        (&["lockstep", "--random", "2", "--set", "loader.access_ns=3000"], "cannot be used with"),
        (&["lockstep", "--random", "0"], "a whole number of 1 or more"),
        (&["lockstep", "--random", "2", "--seed", "18446744073709551614"], "expected a last seed"),
        (
            &["lockstep", "tiny.toml", "--seed", "3"],
            "--seed 3: a scenario is not drawn at random; leave it out",
        ),
        (&["lockstep", "tiny.toml", "--every", "41"], "a frame has 40 sweeps"),
        (&["lockstep", "tiny.toml", "--frame", "4"], "the scenario has frames 0..4"),
        (&["lockstep", "tiny.toml", "--sweep", "38..41"], "a frame has sweeps 0..40"),
    ] {
        let (out, err) = scene.expect(2, wrong);
        assert!(out.is_empty() && err.contains(words), "{wrong:?}: {err}");
    }
}
