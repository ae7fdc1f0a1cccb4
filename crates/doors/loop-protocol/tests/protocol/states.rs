//! Settings under way, states that are taken up again, and records that are drawn again.

use std::fs;

use drive::{Drive, EyePose, Wishes};
use loop_protocol::{Message, Plane, Session};
use quantities::unit_interval;
use run_record::sealed;
use serde_json::{Value, json};

use crate::home::{Scene, ask, ask_with, done, ok, pose_json, problems_of};

/// Poses that turn, nod and roll.
fn poses(scene: &Scene, count: u64) -> Vec<EyePose> {
    let first = scene.drive().pose(0).unwrap();
    let random = |step: u64, key: u64| unit_interval(7, &[step, key]) - 0.5;
    let pose = |step: u64| EyePose {
        eye_m: [
            first.eye_m[0] + 3.0 * random(step, 1),
            first.eye_m[1] + 3.0 * random(step, 2),
            first.eye_m[2] + 1.0,
        ],
        heading_deg: 300.0 * random(step, 3),
        pitch_deg: 8.0 * random(step, 4),
        roll_deg: 20.0 * random(step, 5),
        ..first
    };
    (0..count).map(pose).collect()
}

fn step(session: &mut Session<Scene>, pose: &EyePose) -> Message {
    ask(session, json!({ "do": "step", "pose": pose_json(pose) }))
}

#[test]
fn the_same_requests_have_the_same_bytes() {
    let run = || {
        let scene = Scene::by("pra-overloaded");
        let poses = poses(&scene, 4);
        let mut session = scene.session();
        let mut bytes = Vec::new();
        for pose in &poses {
            bytes.extend(step(&mut session, pose).encode());
        }
        bytes.extend(ask(&mut session, json!({ "do": "state" })).encode());
        bytes
    };
    assert_eq!(run(), run());
}

/// A state that another session takes up goes on with the same bytes, settings and memory among it.
#[test]
fn a_state_is_gone_on_from() {
    for machine in ["ideal", "pra-overloaded"] {
        let scene = Scene::by(machine);
        let poses = poses(&scene, 6);
        let mut first = scene.session();
        poses[..2].iter().for_each(|pose| drop(done(&step(&mut first, pose))));
        ok(&mut first, json!({ "do": "set", "set": { "scenario.sun.elevation_deg": 40 } }));
        done(&step(&mut first, &poses[2]));
        let state = ask(&mut first, json!({ "do": "state" }));
        assert_eq!(done(&state)["frames"], 3);
        let mut second = Scene::by(machine).session();
        done(&step(&mut second, &poses[5]));
        let restored = ask_with(&mut second, json!({ "do": "restore" }), state.planes.clone());
        assert_eq!(done(&restored)["driven"], 3);
        for pose in &poses[3..] {
            assert_eq!(step(&mut first, pose), step(&mut second, pose), "{machine}");
        }
        let [a, b] = [&mut first, &mut second].map(|session| ask(session, json!({ "do": "state" })));
        assert_eq!(a, b);
    }
}

fn restored(session: &mut Session<Scene>, state: &str) -> Message {
    ask_with(session, json!({ "do": "restore" }), vec![Plane::of_file("state", state.as_bytes().to_vec())])
}

/// A session of `scene` that has driven two poses, with its state.
fn driven(scene: Scene) -> (Session<Scene>, String) {
    let poses = poses(&scene, 2);
    let mut session = scene.session();
    poses.iter().for_each(|pose| drop(done(&step(&mut session, pose))));
    let state = ask(&mut session, json!({ "do": "state" }));
    let text = String::from_utf8(state.planes[0].bytes().to_vec()).unwrap();
    (session, text)
}

/// Who changes a hash, a pose or a setting breaks the seal; who seals the state anew says so with other keys. Nothing is taken up.
#[test]
fn a_state_that_was_changed_is_refused() {
    let (mut session, text) = driven(Scene::by("ideal"));
    let state: Value = serde_json::from_str(&text).unwrap();
    let hash = state["pixels_blake3"][1].as_str().unwrap();
    let before = ask(&mut session, json!({ "do": "state" }));
    let changed = "the state was changed since it was handed out";
    for (tampered, title) in [
        (text[1..].to_owned(), changed),
        (text.replace(hash, &"0".repeat(64)), changed),
        (text.replacen("\"from\":0", "\"from\":1", 1), changed),
        (text.replace("ideal", "exact"), changed),
        (r#"{"schema":"lunoid.loop.state/1"}"#.to_owned(), "the state has another schema"),
        (sealed(r#"{"poses":[]}"#), "the state does not hold together"),
        (sealed(r#"{"schema":"lunoid.loop.state/2"}"#), "the state does not hold together"),
    ] {
        assert_eq!(problems_of(&restored(&mut session, &tampered))[0]["title"], title);
    }
    let none = ask(&mut session, json!({ "do": "restore" }));
    assert_eq!(problems_of(&none)[0]["found"], "no plane");
    assert_eq!(ask(&mut session, json!({ "do": "state" })), before);
}

/// A state goes on where the same program draws the same scenario with the same settings, and nowhere else; the refusal names what differs.
#[test]
fn a_state_of_another_scenario_model_or_program_is_refused() {
    let (mut session, text) = driven(Scene::by("pra-nominal"));
    assert_eq!(done(&restored(&mut Scene::by("pra-nominal").session(), &text))["driven"], 2);
    let steeper = Scene::by("pra-nominal").reworded("elevation_deg = 15", "elevation_deg = 16");
    let younger = Scene::by("pra-nominal").of_version("0.0.0");
    for (scene, differs) in [
        (steeper, "files.scene.toml.0 ("),
        (younger, "program.version ("),
        (Scene::by("pra-frugal"), "drawn_by (\"pra-nominal\" there, \"pra-frugal\" now)"),
        (
            Scene::by("pra-nominal").setting("loader.access_ns", "90"),
            "set.loader.access_ns (nothing there, \"90\" now)",
        ),
    ] {
        let mut other = scene.session();
        let before = ask(&mut other, json!({ "do": "hello" }));
        let problem = problems_of(&restored(&mut other, &text)).remove(0);
        assert_eq!(problem["title"], "the state is of another scenario, model or program");
        assert!(problem["found"].as_str().unwrap().contains(differs), "{problem}");
        assert!(problem["expected"].as_str().unwrap().contains("A bump ahead"), "{problem}");
        assert_eq!(ask(&mut other, json!({ "do": "hello" })), before);
    }
    // The settings of the state are its own: they come with it.
    ok(&mut session, json!({ "do": "set", "set": { "loader.access_ns": 90 } }));
    assert_eq!(done(&restored(&mut session, &text))["set"], json!({}));
}

#[test]
fn settings_keep_the_loop_and_are_taken_back() {
    let scene = Scene::by("ideal");
    let poses = poses(&scene, 1);
    let mut session = scene.session();
    let hash = |session: &mut Session<Scene>| {
        ok(session, json!({ "do": "look", "pose": pose_json(&poses[0]) }))["hash"].clone()
    };
    done(&step(&mut session, &poses[0]));
    let before = hash(&mut session);
    let told = ok(&mut session, json!({ "do": "set", "set": { "scenario.sun.azimuth_deg": 250 } }));
    assert_eq!(
        (told["driven"].as_u64(), &told["set"]),
        (Some(1), &json!({ "scenario.sun.azimuth_deg": "250" }))
    );
    assert_ne!(hash(&mut session), before);
    let told = ok(&mut session, json!({ "do": "set", "set": { "scenario.sun.azimuth_deg": null } }));
    assert_eq!(told["set"], json!({}));
    assert_eq!(hash(&mut session), before);
    let machine = ok(&mut session, json!({ "do": "set", "machine": "exact" }));
    assert_eq!(machine["drawn_by"], "exact");
    assert_eq!(ok(&mut session, json!({ "do": "set", "machine": null }))["drawn_by"], "ideal");
    let rate = ask(&mut session, json!({ "do": "set", "set": { "scenario.raster.update_hz": 5 } }));
    assert!(problems_of(&rate)[0]["title"].as_str().unwrap().contains("update rate"));
}

/// What was driven, with a fault switched under way, is drawn again from the record: every frame by the settings of its stretch.
#[test]
fn a_record_is_drawn_again() {
    let scene = Scene::by("pra-overloaded");
    let poses = poses(&scene, 6);
    let mut session = scene.session();
    let mut hashes = Vec::new();
    for (number, pose) in poses.iter().enumerate() {
        if number == 3 {
            ok(&mut session, json!({ "do": "set", "set": { "loader.access_ns": 3000 } }));
        }
        hashes.push(done(&step(&mut session, pose))["hash"].clone());
    }
    let record = ask(&mut session, json!({ "do": "record" }));
    assert_eq!(done(&record)["files"], json!(["scenario.toml", "driven.csv", "record.json"]));
    let folder = tempfile::tempdir().unwrap();
    for file in &record.planes {
        fs::write(folder.path().join(file.name()), file.bytes()).unwrap();
    }
    let told: Value = serde_json::from_slice(record.plane("record.json").unwrap().bytes()).unwrap();
    assert_eq!(told["pixels_blake3"], Value::from(hashes.clone()));
    let words = json!([
        "lunoid",
        "replay",
        "scenario.toml",
        "--machine",
        "pra-overloaded",
        "--set",
        "loader.access_ns=3000",
        "--frames",
        "3..6"
    ]);
    assert_eq!(told["stretches"][1], json!({ "frames": [3, 6], "replay": words }));
    for (set, frames) in [(vec![], 0..3), (vec![("loader.access_ns".to_owned(), "3000".to_owned())], 3..6)] {
        let wishes = Wishes { machine: Some("pra-overloaded".into()), set, ..Wishes::default() };
        let drive = Drive::open(&folder.path().join("scenario.toml"), &wishes, 1).unwrap();
        for frame in frames {
            assert_eq!(drive.frame(frame).unwrap().hash(), hashes[frame as usize], "frame {frame}");
        }
    }
}
