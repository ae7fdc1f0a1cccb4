//! Places where a condition is met, what late words changed, a state after some frames, and the sweeps that complete pixels.

use loop_protocol::{Message, Session};
use serde_json::{Value, json};

use crate::home::{Scene, ask, ask_with, done, ok, pose_json, problems};

fn places(session: &mut Session<Scene>, more: Value) -> Vec<Value> {
    let mut request = json!({ "do": "trigger", "on": "rising mu.height 0.5", "frame": 1 });
    request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    ok(session, request)["places"].as_array().unwrap().clone()
}

/// Crossings of a level, found in the waveforms themselves.
fn crossings(probe: &Message, level: f64) -> Vec<(u64, u64, f64)> {
    let values = probe.plane("mu.height").unwrap().values::<f64>().unwrap();
    let samples = values.len() / 40;
    let mut found = Vec::new();
    for (sweep, own) in values.chunks(samples).enumerate() {
        for (before, pair) in own.windows(2).enumerate() {
            if pair[0] < level && pair[1] >= level {
                let instant = before as f64 + (level - pair[0]) / (pair[1] - pair[0]);
                found.push((sweep as u64, before as u64 + 1, instant));
            }
        }
    }
    found
}

#[test]
fn a_trigger_finds_every_crossing_where_it_is() {
    let mut session = Scene::by("ideal").session();
    let probe =
        ask(&mut session, json!({ "do": "probe", "signals": ["mu.height"], "frame": 1, "sweeps": [0, 40] }));
    let own = crossings(&probe, 0.5);
    let found = places(&mut session, json!({ "limit": 10_000 }));
    assert!(own.len() > 5 && own.len() == found.len(), "{} {}", own.len(), found.len());
    for ((sweep, sample, instant), place) in own.iter().zip(&found) {
        assert_eq!((place["sweep"].as_u64(), place["sample"].as_u64()), (Some(*sweep), Some(*sample)));
        let told = place["instant"].as_f64().unwrap();
        assert!((told - instant).abs() < 1e-9, "{told} for {instant}");
        assert!(place["values"]["mu.height"].as_f64().unwrap() >= 0.5);
    }
    // Place by place, each behind the one before, is the same.
    let mut walked: Vec<Value> = Vec::new();
    let mut from = json!({});
    while let Some(place) = places(&mut session, from).pop() {
        from = json!({ "sweeps": [place["sweep"], 40], "after": place["instant"] });
        walked.push(place);
        if walked.len() > found.len() {
            break;
        }
    }
    assert_eq!(walked, found);
}

/// What a pixel is explained by is the sweep of the place that it shows.
#[test]
fn the_pixel_of_a_place_shows_its_sweep() {
    let mut session = Scene::by("ideal").session();
    let found = places(&mut session, json!({ "limit": 10_000 }));
    let seen = found.iter().find(|place| place["is_blanked"] == false && place["pixel"].is_array()).unwrap();
    let [column, line] = [&seen["pixel"][0], &seen["pixel"][1]];
    let told = ok(&mut session, json!({ "do": "explain", "frame": 1, "column": column, "line": line }));
    assert_eq!(told["document"]["place"]["sweep"], seen["sweep"]);
}

#[test]
fn what_cannot_be_searched_is_told() {
    let mut session = Scene::by("ideal").session();
    let cases = [
        (json!({ "do": "trigger", "frame": 0 }), "`on`"),
        (json!({ "do": "trigger", "frame": 0, "on": "rising mu.hight 3" }), "mu.height"),
        (json!({ "do": "trigger", "frame": 0, "on": "rising mu.height 3", "sweeps": [3, 99] }), "3..99"),
        (json!({ "do": "trigger", "frame": 0, "on": "rising mu.height 3", "samples": [9, 9] }), "9..9"),
        (json!({ "do": "effect", "frame": 0 }), "`late`"),
        (json!({ "do": "effect", "frame": 0, "late": "three" }), "sweep and crossing"),
        (json!({ "do": "effect", "frame": 0, "late": "3:0" }), "3"),
        (json!({ "do": "state", "frames": 1 }), "fewer frames"),
    ];
    for (request, word) in cases {
        let text = Value::from(problems(&mut session, request.clone())).to_string();
        assert!(text.contains(word), "{request}: {text}");
    }
    let mut guest = Scene::by("exact").session();
    for request in [
        json!({ "do": "trigger", "frame": 0, "on": "rising mu.height 3" }),
        json!({ "do": "effect", "frame": 0, "late": "3:0" }),
        json!({ "do": "timing", "frame": 0 }),
        json!({ "do": "frame", "frame": 0, "planes": ["sweep"] }),
    ] {
        let text = Value::from(problems(&mut guest, request.clone())).to_string();
        assert!(text.contains("a hardware model"), "{request}: {text}");
    }
}

/// The pixels that a late event changed are there, and the same by its place and by its line.
#[test]
fn late_words_have_pixels() {
    let mut session = Scene::by("ideal").session();
    let in_time = ok(&mut session, json!({ "do": "timing", "frame": 1 }));
    assert_eq!((&in_time["missed"], &in_time["late_words"]), (&json!(0), &json!(0)));
    ok(&mut session, json!({ "do": "set", "set": { "loader.access_ns": 30000 } }));
    let events = ok(&mut session, json!({ "do": "events", "frame": 1, "event": ["late"] }));
    let late = events["events"].as_array().unwrap();
    assert!(late.len() > 3, "{events}");
    let timing = ok(&mut session, json!({ "do": "timing", "frame": 1 }));
    assert!(
        timing["missed"].as_u64() >= Some(late.len() as u64) && timing["folds"].as_u64() > Some(0),
        "{timing}"
    );
    let mut changed = 0;
    for event in late {
        let of_line = ok(&mut session, json!({ "do": "effect", "frame": 1, "late": event.to_string() }));
        let place = format!("{}:{}", event["sweep"], event["crossing"]);
        let of_place = ok(&mut session, json!({ "do": "effect", "frame": 1, "late": place }));
        assert_eq!(of_line, of_place);
        let frame = &of_line["document"]["frames"][0];
        let pixels = frame["pixels"].as_array().unwrap();
        assert_eq!(frame["changed"].as_u64(), Some(pixels.len() as u64));
        changed += pixels.len();
    }
    assert!(changed > 0, "no late word changed a pixel");
}

/// A state after some frames is that of a loop that has driven no further.
#[test]
fn a_state_after_some_frames_forgets_the_others() {
    for machine in ["ideal", "pra-overloaded"] {
        let scene = Scene::by(machine);
        let poses: Vec<_> = (0..4).map(|frame| scene.drive().pose(frame).unwrap()).collect();
        let mut whole = scene.session();
        let mut short = Scene::by(machine).session();
        for (frame, pose) in poses.iter().enumerate() {
            let step = json!({ "do": "step", "pose": pose_json(pose) });
            done(&ask(&mut whole, step.clone()));
            if frame < 2 {
                done(&ask(&mut short, step));
            }
        }
        let cut = ask(&mut whole, json!({ "do": "state", "frames": 2 }));
        assert_eq!(cut, ask(&mut short, json!({ "do": "state" })), "{machine}");
        // From there it is driven anew, with the same bytes.
        let restored = ask_with(&mut whole, json!({ "do": "restore" }), cut.planes);
        assert_eq!(done(&restored)["driven"], 2);
        let step = json!({ "do": "step", "pose": pose_json(&poses[3]) });
        assert_eq!(ask(&mut whole, step.clone()), ask(&mut short, step), "{machine}");
        let none = ask(&mut whole, json!({ "do": "state", "frames": 0 }));
        assert_eq!(done(&ask_with(&mut whole, json!({ "do": "restore" }), none.planes))["driven"], 0);
    }
}

/// Forty sweeps and forty columns: each sweep completes its column, without a yoke and with level sweeps.
#[test]
fn sweeps_complete_their_columns() {
    let mut session = Scene::by("ideal").session();
    let seen = ask(&mut session, json!({ "do": "frame", "frame": 1, "planes": ["picture", "sweep"] }));
    let completes = seen.plane("sweep").unwrap();
    assert_eq!(completes.shape(), seen.plane("picture").unwrap().shape());
    let values = completes.values::<u16>().unwrap();
    for line in values.chunks(40) {
        assert!(line.is_sorted(), "{line:?}");
        assert!(
            line.iter().enumerate().all(|(column, sweep)| (i64::from(*sweep) - column as i64).abs() <= 1),
            "{line:?}"
        );
    }
}

#[test]
fn blocks_have_links_parts_and_tables() {
    let mut session = Scene::by("pra-nominal").session();
    let told = ok(&mut session, json!({ "do": "blocks" }));
    let blocks = told["blocks"].as_array().unwrap();
    let terrain = blocks.iter().find(|block| block["name"] == "terrain-generator").unwrap();
    assert_eq!(terrain["links"][0]["to"], "mixing-unit");
    assert!(terrain["parts"].to_string().contains("108 analog multipliers"), "{}", terrain["parts"]);
    let keys = ok(&mut session, json!({ "do": "parameters" }));
    let tables: Vec<&str> = blocks
        .iter()
        .flat_map(|block| block["tables"].as_array().unwrap())
        .map(|table| table.as_str().unwrap())
        .collect();
    for row in keys["parameters"].as_array().unwrap() {
        let table = row["key"].as_str().unwrap().split_once('.').map(|(table, _)| table);
        assert!(table.is_none_or(|table| tables.contains(&table)), "{row}: no block has this table");
    }
    let faults = ok(&mut session, json!({ "do": "faults" }));
    assert!(
        faults["faults"]
            .as_array()
            .unwrap()
            .iter()
            .all(|fault| fault["predicts"].as_str().unwrap().len() > 20)
    );
}
