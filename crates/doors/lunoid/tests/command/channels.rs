//! Channels of one scenario: a run of each, and one page.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

const CHANNELS: &str = "\n[[channel]]\nname = \"left\"\nheading_deg = -40\n\n[[channel]]\nname = \"ahead\"\n\
                        field_of_view_deg = [20, 15]\n";

/// The small scene with two windows.
fn scene() -> Scene {
    let scene = Scene::new();
    let path = scene.join("tiny.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text + CHANNELS).unwrap();
    scene
}

fn json(text: &[u8]) -> Value {
    serde_json::from_slice(text).unwrap()
}

#[test]
fn a_replay_draws_all_of_them_beside_one_another() {
    let scene = scene();
    let (out, _) = scene.expect(0, &["replay", "tiny.toml", "--sweeps", "48", "--out", "all", "--json"]);
    let document = json(out.as_bytes());
    assert_eq!(document["side_by_side"]["reference"], Value::Null);
    assert_eq!(scene.list("all"), ["ahead", "index.html", "left", "side-by-side.json"]);
    let page = fs::read_to_string(scene.join("all/index.html")).unwrap();
    assert!(page.contains("Views side by side") && page.contains("−40°") && !page.contains("Difference of"));
    let left = json(&fs::read(scene.join("all/left/run.json")).unwrap());
    assert_eq!(
        (&left["channel"]["name"], &left["channel"]["heading_deg"]),
        (&"left".into(), &(-40.0).into())
    );
    let ahead = json(&fs::read(scene.join("all/ahead/run.json")).unwrap());
    assert_ne!(left["fingerprint"], ahead["fingerprint"]);
    assert!((ahead["view"]["field_of_view_deg"][0].as_f64().unwrap() - 20.0).abs() < 1e-9);
}

#[test]
fn one_of_them_is_the_same_run_alone() {
    let scene = scene();
    scene.expect(0, &["replay", "tiny.toml", "--sweeps", "48", "--out", "all"]);
    scene.expect(0, &["replay", "tiny.toml", "--sweeps", "48", "--channel", "left", "--out", "left"]);
    let frames =
        |folder: &str| json(&fs::read(scene.join(folder).join("run.json")).unwrap())["frames"].clone();
    assert_eq!(frames("left"), frames("all/left"));
    assert_ne!(frames("left"), frames("all/ahead"));
    // A run is made again through its channel.
    let (told, _) = scene.expect(0, &["explain", "left", "--frame", "0", "--pixel", "20,20", "--json"]);
    let asked = [
        "explain",
        "tiny.toml",
        "--sweeps",
        "48",
        "--channel",
        "left",
        "--frame",
        "0",
        "--pixel",
        "20,20",
        "--json",
    ];
    assert_eq!(scene.expect(0, &asked).0, told);
}

#[test]
fn a_camera_turned_as_a_channel_sees_the_same() {
    let scene = scene();
    scene.expect(
        0,
        &[
            "replay",
            "tiny.toml",
            "--sweeps",
            "48",
            "--channel",
            "left",
            "--machine",
            "exact",
            "--frames",
            "0..1",
            "--out",
            "left",
        ],
    );
    let poses = fs::read_to_string(scene.join("left/poses.csv")).unwrap();
    let row = poses.lines().nth(1).unwrap();
    let of: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
    let path = format!(
        "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n0,{},{},{},{},{},{}\n",
        of[2], of[3], of[4], of[5], of[6], of[7]
    );
    scene.write("turned.csv", path);
    let text = fs::read_to_string(scene.join("tiny.toml")).unwrap();
    let text = text.replace(CHANNELS, "");
    let (before, keyframes) = text.split_once("[path]").unwrap();
    let rest = keyframes.find("\n[").map_or("", |at| &keyframes[at..]);
    scene.write("turned.toml", format!("{before}[path]\nfile = \"turned.csv\"\n{rest}"));
    scene.expect(
        0,
        &[
            "replay",
            "turned.toml",
            "--sweeps",
            "48",
            "--machine",
            "exact",
            "--frames",
            "0..1",
            "--out",
            "turned",
        ],
    );
    let (told, _) = scene.expect(0, &["compare", "left", "turned", "--json"]);
    let rmse = json(told.as_bytes())["pictures"][0]["rmse"].as_f64().unwrap();
    assert!(rmse < 1e-3, "{rmse}");
}

#[test]
fn what_is_asked_of_no_channel_is_refused_or_told() {
    let scene = scene();
    let (_, told) = scene.expect(0, &["explain", "tiny.toml", "--frame", "0", "--pixel", "20,20"]);
    assert!(told.contains("vehicle's own camera; --channel NAME looks through one of left, ahead"), "{told}");
    let (_, told) =
        scene.expect(2, &["explain", "tiny.toml", "--channel", "rear", "--frame", "0", "--pixel", "20,20"]);
    assert!(
        told.contains(
            "--channel rear: tiny.toml: no such channel; expected one of the scenario's channels left, ahead"
        ),
        "{told}"
    );
    let (_, told) = scene.expect(
        2,
        &[
            "replay",
            "tiny.toml",
            "--machine",
            "ideal",
            "--machine",
            "lunsim",
            "--set",
            "lunsim.restrictions=false",
        ],
    );
    assert!(told.contains("expected --channel with one of left, ahead"), "{told}");
    let (_, told) = scene.expect(2, &["replay", "tiny.toml", "--truth", "range"]);
    assert!(told.contains("--channel NAME --out FOLDER/NAME --truth"), "{told}");
    let bare = Scene::new();
    let (_, told) = bare.expect(2, &["replay", "tiny.toml", "--channel", "left"]);
    assert!(told.contains("the scenario has no [[channel]]; leave the option out"), "{told}");
}
