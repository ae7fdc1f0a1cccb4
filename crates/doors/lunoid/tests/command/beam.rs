//! The list of a beam, and sampling points, on the command line.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

const STARS: &str = "\n[stars]\nseed = 3\ncount = 400\nfaintest = 5\ncalligraphic = true\n";

/// The small scene under stars that a beam draws.
fn scene() -> Scene {
    let scene = Scene::new();
    let text = fs::read_to_string(scene.join("tiny.toml")).unwrap();
    scene.write("tiny.toml", text + STARS);
    scene
}

const BEAM: [&str; 6] = ["beam", "tiny.toml", "--machine", "sampled", "--frame", "0"];

#[test]
fn its_points_are_written_as_csv_and_json() {
    let scene = scene();
    let (out, _) = scene.expect(0, &[&BEAM[..], &["--json"]].concat());
    let document: Value = serde_json::from_str(&out).unwrap();
    let points = document["points"].as_array().unwrap();
    assert!(document["schema"] == "lunoid.beam/1" && points.len() > 5, "{document}");
    scene.expect(0, &[&BEAM[..], &["--out", "points.csv"]].concat());
    let csv = fs::read_to_string(scene.join("points.csv")).unwrap();
    assert_eq!(csv.lines().count(), points.len() + 1);
    let row: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(row[1].parse::<f64>().unwrap(), points[0]["place_px"][0].as_f64().unwrap());
    scene.expect(0, &[&BEAM[..], &["--out", "points.json"]].concat());
    let written: Value = serde_json::from_slice(&fs::read(scene.join("points.json")).unwrap()).unwrap();
    assert_eq!(written, document);
    let (told, _) = scene.expect(0, &BEAM);
    assert!(told.contains(&format!("{} points drawn, 0 left out", points.len())), "{told}");
}

#[test]
fn generators_without_one_say_so() {
    let scene = scene();
    let (_, told) = scene.expect(2, &["beam", "tiny.toml", "--machine", "exact", "--frame", "0"]);
    assert!(told.contains("exact has no beam for light points; name a generator that has one"), "{told}");
    let (_, told) = scene.expect(2, &[&BEAM[..5], &["99"]].concat());
    assert!(told.contains("frames 0..4"), "{told}");
}

#[test]
fn a_sampling_point_is_printed_or_refused() {
    let scene = scene();
    let explain = |sample: &'static str| {
        ["explain", "tiny.toml", "--machine", "sampled", "--frame", "0", "--sample", sample]
    };
    let (out, _) = scene.expect(0, &explain("20,20,3"));
    let told: Value = serde_json::from_str(&out).unwrap();
    assert!(told["schema"] == "lunoid.sampling-point/1" && told["stack"].is_array(), "{told}");
    let (_, told) = scene.expect(2, &explain("20,20,4"));
    assert!(told.contains("--sample 20,20,4: sampled has no such sampling point"), "{told}");
    let (_, told) = scene.expect(2, &explain("9000,20,0"));
    assert!(told.contains("--sample: ") && told.contains("9000"), "{told}");
    let (_, told) = scene.expect(2, &explain("20,20"));
    assert!(told.contains("column, line and number of the sampling point"), "{told}");
}
