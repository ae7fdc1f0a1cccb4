//! `lunoid replay --check`: random sweeps of a run against `exact`.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

const COARSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../hardware-models/faults/coarse.toml");

fn check(scene: &Scene, folder: &str) -> Value {
    let record = fs::read(scene.join(folder).join("run.json")).unwrap();
    serde_json::from_slice::<Value>(&record).unwrap()["check"].take()
}

/// RMS and lower end of the interval.
fn error(check: &Value, name: &str) -> [f64; 2] {
    let errors = check["errors"].as_array().unwrap();
    let found = errors.iter().find(|found| found["error"] == name).unwrap();
    [found["rms"].as_f64().unwrap(), found["interval"][0].as_f64().unwrap()]
}

#[test]
fn a_fault_shows_beyond_its_interval() {
    let scene = Scene::new();
    let replay = |out: &str, more: &[&str]| {
        scene.expect(0, &[&["replay", "tiny.toml", "--check", "12", "--out", out], more].concat());
    };
    replay("clean", &[]);
    replay("again", &["--jobs", "1"]);
    replay("faulty", &["--overlay", COARSE]);
    let [clean, again, faulty] = ["clean", "again", "faulty"].map(|folder| check(&scene, folder));
    assert_eq!(clean, again);
    assert!(error(&clean, "picture")[0] < 0.01 && error(&clean, "height")[0] < 1e-6, "{clean:#}");
    // Steps of six bits are decimetres. Which sweeps are drawn depends on the program: of a picture of few sweeps they do not
    // tell as much.
    assert!(error(&faulty, "height")[1] > 1000.0 * error(&clean, "height")[0], "{clean:#} {faulty:#}");
    let page = fs::read_to_string(scene.join("clean/index.html")).unwrap();
    assert!(page.contains("12 sweeps, drawn at random") && page.contains("95 % confidence"));
}

/// Made now or there already, in words and in the document.
#[test]
fn the_command_tells_of_the_check() {
    let scene = Scene::new();
    let replay = |more: &[&str]| {
        scene.expect(0, &[&["replay", "tiny.toml", "--no-progress", "--out", "r"], more].concat()).0
    };
    assert!(!replay(&[]).contains("against exact"));
    let made = replay(&["--check", "12"]);
    assert!(made.contains("12 sweeps against exact, rms: picture "), "{made}");
    assert!(made.contains("height ") && made.contains(" m (at most "), "{made}");
    assert_eq!(replay(&["--check", "12"]), made);
    let document: Value = serde_json::from_str(&replay(&["--check", "12", "--json"])).unwrap();
    assert_eq!(document["check"], check(&scene, "r"));
}

#[test]
fn what_cannot_be_checked_is_told_before_anything_is_drawn() {
    let scene = Scene::new();
    let (_, err) =
        scene.expect(2, &["replay", "tiny.toml", "--machine", "exact", "--check", "3", "--out", "e"]);
    assert!(
        err.contains("--check 3: exact has no sweeps") && err.contains("expected a hardware model"),
        "{err}"
    );
    assert!(!scene.join("e").exists());
}
