//! Settings under way, states that are taken up again, and records that are drawn again.

use std::fs;

use drive::{Drive, EyePose, Wishes};
use loop_protocol::{Message, Session};
use quantities::unit_interval;
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
        // Damaged states change nothing.
        let bytes = a.planes[0].bytes().to_vec();
        let text = String::from_utf8(bytes).unwrap();
        for damaged in [
            &text[1..],
            &text.replace("lunoid.loop.state/1", "lunoid.loop.state/2"),
            &text.replacen("\"from\":0", "\"from\":1", 1),
        ] {
            let planes = vec![loop_protocol::Plane::of_file("state", damaged.as_bytes().to_vec())];
            problems_of(&ask_with(&mut second, json!({ "do": "restore" }), planes));
        }
        assert_eq!(ask(&mut second, json!({ "do": "state" })), b);
    }
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
