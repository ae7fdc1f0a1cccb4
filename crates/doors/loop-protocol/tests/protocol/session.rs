//! Answers of a session.

use drive::{Codes, Loop};
use loop_protocol::{Message, Plane, REQUESTS};
use serde_json::{Value, json};

use crate::home::{Scene, ask, ask_with, done, ok, pose_json, problems, problems_of};

#[test]
fn hello_tells_what_is_known_and_opened() {
    let mut session = Scene::by("ideal").session();
    let hello = ok(&mut session, json!({ "do": "hello" }));
    assert_eq!(hello["protocol"], "lunoid.loop/1");
    let names: Vec<&str> =
        hello["do"].as_array().unwrap().iter().map(|row| row["name"].as_str().unwrap()).collect();
    assert_eq!(names, REQUESTS.map(|row| row.name));
    let opened = &hello["opened"];
    assert_eq!(
        [&opened["columns"], &opened["sweeps"], &opened["samples"], &opened["frames"]].map(Value::as_u64),
        [Some(40), Some(40), Some(80), Some(4)]
    );
    assert_eq!(
        (opened["drawn_by"].as_str(), opened["update_hz"].as_f64(), opened["driven"].as_u64()),
        (Some("ideal"), Some(10.0), Some(0))
    );
    // 40 sweeps of 80 samples, ten times a second, and nothing in between.
    assert_eq!(opened["sample_us"].as_f64(), Some(1e6 / (10.0 * 40.0 * 80.0)));
}

/// Requests of all kinds but those that open or draw a picture, and what is wrong with each.
#[test]
fn requests_that_are_wrong_name_all_their_faults() {
    let mut session = Scene::by("ideal").session();
    let cases = [
        (json!({ "do": "lok" }), &["no request `lok`", "hello, open", "`look`"][..], 1),
        (json!({ "do": 3 }), &["without a word"], 1),
        (json!({}), &["without a word"], 1),
        (json!({ "do": "look", "poze": 1 }), &["no key `poze`", "id, do, pose, frame, planes", "`pose`"], 2),
        (
            json!({ "do": "look", "pose": { "x_m": 1, "y_m": "two", "zz": 3, "heading_deg": 0, "pitch_deg": 0, "roll_deg": null } }),
            &["pose.zz", "pose.y_m", "pose.z_m", "pose.roll_deg"],
            4,
        ),
        (json!({ "do": "frame" }), &["`frame`"], 1),
        (json!({ "do": "frame", "frame": 4 }), &["no frame 4"], 1),
        (json!({ "do": "frame", "frame": -1 }), &["whole number"], 1),
        (
            json!({ "do": "frame", "frame": 0, "planes": ["picture", "deep"] }),
            &["no plane `deep`", "picture, light, sweep, range"],
            1,
        ),
        (json!({ "do": "step", "planes": ["deep", "wide"] }), &["`pose`", "`deep`", "`wide`"], 3),
        (json!({ "do": "events", "frame": 0, "limit": 0 }), &["`limit`", "a whole number from 1"], 1),
        (
            json!({ "do": "trigger", "frame": 0, "on": "rising tg.height 0", "limit": 0 }),
            &["a whole number from 1"],
            1,
        ),
        (json!({ "do": "probe", "signals": ["zz.*"], "sweeps": 0, "frame": 0 }), &["zz.*"], 1),
        (json!({ "do": "probe", "signals": ["tg.*"], "frame": 0 }), &["`sweeps`"], 1),
        (json!({ "do": "probe", "signals": ["tg.*"], "sweeps": [3, 3], "frame": 0 }), &["3..3"], 1),
        (
            json!({ "do": "probe", "signals": ["tg.*"], "sweeps": [0, 4_000_000_000_u32], "frame": 0 }),
            &["0..4000000000", "a range inside 0..40"],
            1,
        ),
        (json!({ "do": "explain", "frame": 0, "column": 40, "line": 0 }), &["40,0"], 1),
        (json!({ "do": "explain", "column": 1, "line": 0 }), &["driven nothing"], 1),
        (json!({ "do": "events", "frame": 0, "event": ["later"] }), &["no event `later`"], 1),
        (json!({ "do": "ahead", "metres": 1e9 }), &["the drive"], 1),
        (json!({ "do": "set", "set": { "loader.axes_ns": 3 } }), &["loader.axes_ns"], 1),
        (json!({ "do": "set", "set": { "loader.access_ns": { "a": null } } }), &["`set`"], 1),
        (json!({ "do": "restore" }), &["no state"], 1),
        (json!({ "do": "record" }), &["driven nothing"], 1),
        (json!({ "do": "record", "name": "../up" }), &["letters, digits"], 1),
    ];
    for (request, words, count) in cases {
        let found = problems(&mut session, request.clone());
        let text = Value::from(found.clone()).to_string();
        assert!(words.iter().all(|word| text.contains(word)), "{request}: {text}");
        assert_eq!(found.len(), count, "{request}: {text}");
        assert!(found.iter().all(|problem| problem["title"].is_string() && problem["file"].is_string()));
    }
    let nameless = session.answer(&Message::new(json!({ "do": "hello", "id": "one" })));
    assert!(nameless.header["id"].is_null() && problems_of(&nameless).len() == 1);
    let files = ask_with(&mut session, json!({ "do": "open" }), vec![Plane::of_file("a.toml", vec![1])]);
    assert!(problems_of(&files)[0]["title"].as_str().unwrap().contains("not taken here"));
    // Nothing was changed by any of them.
    assert_eq!(ok(&mut session, json!({ "do": "hello" }))["opened"]["driven"], 0);
}

#[test]
fn nothing_is_drawn_before_it_is_opened() {
    let mut session = loop_protocol::Session::new(Scene::by("ideal"));
    for word in ["state", "omissions", "record", "set"] {
        assert!(
            problems(&mut session, json!({ "do": word }))[0]["title"]
                .as_str()
                .unwrap()
                .contains("nothing is opened")
        );
    }
}

/// Frames and looks have the bits of the drive; planes their shapes.
#[test]
fn pictures_are_those_of_the_drive() {
    let scene = Scene::by("ideal");
    let drive = scene.drive();
    let mut session = scene.session();
    let own = drive.frame(2).unwrap();
    let frame = ask(
        &mut session,
        json!({ "do": "frame", "frame": 2, "planes": ["picture", "light", "range", "label", "normal"] }),
    );
    let told = done(&frame);
    assert_eq!((told["hash"].as_str(), told["frame"].as_u64()), (Some(&*own.hash()), Some(2)));
    let codes: Vec<u16> = own.picture.grey().unwrap().codes().to_vec();
    let picture = frame.plane("picture").unwrap();
    assert_eq!(picture.shape(), [own.picture.lines(), own.picture.columns()]);
    assert_eq!(picture.values::<u8>().unwrap().into_iter().map(u16::from).collect::<Vec<_>>(), codes);
    assert_eq!(
        frame.plane("light").unwrap().values::<f32>().unwrap(),
        own.light.get(drive::PlaneKind::Intensity).unwrap()
    );
    let truth = drive.truth(2, "range,label,normal").unwrap();
    for plane in &truth.planes {
        let sent = frame.plane(plane.name).unwrap();
        assert_eq!(sent.shape(), plane.shape);
        match &plane.values {
            Codes::Codes(codes) => assert_eq!(&sent.values::<u8>().unwrap(), codes),
            Codes::Numbers(numbers) => assert_eq!(&sent.values::<f32>().unwrap(), numbers),
        }
    }
    assert_eq!(
        (told["truth"][0]["name"].as_str(), told["truth"][0]["bound"].as_f64()),
        (Some("range"), Some(6e-8))
    );
    let pose = drive.pose(1).unwrap();
    let look = ok(&mut session, json!({ "do": "look", "frame": 1, "pose": pose_json(&pose), "planes": [] }));
    assert_eq!(look["hash"], drive.look(1, &pose).unwrap().hash());
    assert_eq!(look["pose"]["heading_deg"], drive.look(1, &pose).unwrap().pose.heading_deg);
}

#[test]
fn a_picture_has_lines_before_columns() {
    let mut session = Scene::by("ideal").session();
    ok(&mut session, json!({ "do": "set", "set": { "scenario.raster.columns": 30 } }));
    let frame =
        ask(&mut session, json!({ "do": "frame", "frame": 0, "planes": ["picture", "light", "range"] }));
    done(&frame);
    for plane in &frame.planes {
        assert_eq!(plane.shape(), [17, 30], "{}", plane.name());
    }
}

/// A loop through the session is the loop of the drive, step by step.
#[test]
fn steps_are_those_of_a_loop() {
    for machine in ["ideal", "pra-overloaded"] {
        let scene = Scene::by(machine);
        let drive = scene.drive();
        let mut own = Loop::new(drive.clone());
        let mut session = scene.session();
        let mut pose = drive.pose(0).unwrap();
        for step in 0..4 {
            pose.roll_deg = f64::from(step);
            let answer = ok(&mut session, json!({ "do": "step", "pose": pose_json(&pose) }));
            assert_eq!(answer["hash"], own.look(&pose).unwrap().hash(), "{machine}, step {step}");
            assert_eq!(answer["frame"], step);
            let there =
                ok(&mut session, json!({ "do": "ahead", "turn_deg": 20, "metres": 0.5 }))["pose"].clone();
            pose = own.turned(&pose, 20.0, 0.5).unwrap();
            assert_eq!(
                (there["x_m"].as_f64(), there["pitch_deg"].as_f64()),
                (Some(pose.eye_m[0]), Some(pose.pitch_deg))
            );
        }
        assert_eq!(ok(&mut session, json!({ "do": "hello" }))["opened"]["driven"], 4);
    }
}

/// A machine with memory explains and probes the last frame as it was driven.
#[test]
fn the_last_frame_is_looked_at() {
    let scene = Scene::by("pra-nominal");
    let drive = scene.drive();
    let mut session = scene.session();
    let pose = drive.pose(0).unwrap();
    for _ in 0..2 {
        ok(&mut session, json!({ "do": "step", "pose": pose_json(&pose), "planes": ["range"] }));
    }
    let explained = ok(&mut session, json!({ "do": "explain", "column": 20, "line": 20 }));
    assert_eq!(
        (explained["document"]["frame"].as_u64(), explained["document"]["pixel"].clone()),
        (Some(1), json!([20, 20]))
    );
    assert!(explained["text"].as_str().unwrap().contains("frame 1"), "{}", explained["text"]);
    let probe = ask(&mut session, json!({ "do": "probe", "signals": ["mu.height"], "sweeps": [3, 5] }));
    assert_eq!(done(&probe)["frame"], 1);
    assert_eq!(probe.plane("mu.height").unwrap().values::<f64>().unwrap().len(), 160);
}

#[test]
fn signals_events_and_explanations_are_those_of_the_drive() {
    let scene = Scene::by("pra-nominal");
    let drive = scene.drive();
    let mut session = scene.session();
    let probe = ask(
        &mut session,
        json!({ "do": "probe", "signals": ["mu.height", "tg.red.hold"], "frame": 1, "sweeps": [17, 19] }),
    );
    let told = done(&probe);
    let own = drive.probe(&["mu.height".into(), "tg.red.hold".into()], 1, 17..19).unwrap();
    for (trace, row) in own.signals.iter().zip(told["signals"].as_array().unwrap()) {
        assert_eq!(probe.plane(trace.signal.name).unwrap().values::<f64>().unwrap(), trace.values);
        assert_eq!(
            (row["full_scale"].as_f64(), row["unit"].as_str()),
            (Some(trace.full_scale), Some(trace.signal.unit.symbol()))
        );
    }
    let times = probe.plane("times:tg.red.hold").unwrap().values::<f64>().unwrap();
    assert_eq!(times, own.signals.iter().find(|trace| trace.signal.name == "tg.red.hold").unwrap().times);
    assert_eq!(probe.plane("places").unwrap().values::<f64>().unwrap(), own.places);
    let explained = ok(&mut session, json!({ "do": "explain", "frame": 2, "column": 3, "line": 22 }));
    let own = drive.explain(2, [3, 22]).unwrap();
    assert_eq!((explained["cause"].as_str(), &explained["document"]), (Some(&*own.cause), &own.document));
    let events =
        ok(&mut session, json!({ "do": "events", "frame": 1, "sweeps": 3, "unit": ["loader"], "limit": 5 }));
    let rows = events["events"].as_array().unwrap();
    assert!(
        rows.len() >= 5 && rows.iter().all(|row| row["unit"].as_str().unwrap().starts_with("loader")),
        "{events}"
    );
    assert!(rows.iter().all(|row| row["sweep"] == 3 && row["time_us"].is_number()));
    assert!(events["next"].as_u64() > rows[4]["tick"].as_u64() && events["tick_us"].as_f64() > Some(0.0));
}
