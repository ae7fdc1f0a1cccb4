//! `lunoid explain`: from a pixel to its wires.

use serde_json::Value;

use crate::scene::Scene;

#[test]
fn a_pixel_leads_to_its_sweep_and_agrees_with_the_picture() {
    let scene = Scene::new();
    scene.write("scene.toml", include_str!("../tiny.toml"));
    let pixel = ["explain", "scene.toml", "--frame", "1", "--pixel", "20,20"];
    let (text, _) = scene.expect(0, &pixel);
    assert!(text.starts_with("frame 1 (") && text.contains("\nread beam "), "{text}");
    let (json, _) = scene.expect(0, &[&pixel[..], &["--json"]].concat());
    let told: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&told["schema"], &told["pixel"]), (&"lunoid.explain/1".into(), &Value::from(vec![20, 20])));
    assert_eq!(told["place"]["sweep"], 20, "forty sweeps, forty columns");
    let difference = told["intensity"].as_f64().unwrap() - told["left"].as_f64().unwrap();
    assert!(difference.abs() < 0.05, "{told}");
    let reason = told["because"][0].as_str().unwrap();
    assert!(text.contains(reason), "{text}");
    // Ground has a place and a shade, the sky neither.
    let line_of_exact = |text: &str| text.lines().find(|line| line.starts_with("exact ")).unwrap().to_owned();
    let ground = line_of_exact(&text);
    assert!(ground.contains("terrain at ") && ground.contains(" m high, "), "{ground}");
    let (text, _) = scene.expect(0, &["explain", "scene.toml", "--frame", "1", "--pixel", "20,0"]);
    assert!(line_of_exact(&text).ends_with(": sky"), "{text}");
    assert!(text.contains("cell 0.000 of ") && !text.contains("-0.000"), "{text}");
}

/// A run is made again by the words of its own command.
#[test]
fn a_run_folder_stands_for_its_scenario() {
    let scene = Scene::new();
    scene.write("scene.toml", include_str!("../tiny.toml"));
    let raster = ["--sweeps", "24", "--set", "loader.access_ns=900"];
    let draw = ["replay", "scene.toml", "--frames", "0..2", "--out", "run", "-q"];
    scene.expect(0, &[&draw[..], &raster].concat());
    let pixel = ["--frame", "1", "--pixel", "12,10", "--json"];
    let (of_run, _) = scene.expect(0, &[&["explain", "run"], &pixel[..]].concat());
    let (of_scene, _) = scene.expect(0, &[&["explain", "scene.toml"], &raster[..], &pixel].concat());
    assert_eq!(of_run, of_scene);
    let (_, err) = scene.expect(2, &[&["explain", "run", "--sweeps", "20"], &pixel[..]].concat());
    assert!(err.contains("run: a run has its own"), "{err}");
    scene.vary("scene.toml", "elevation_deg = 15", "elevation_deg = 16");
    let (_, err) = scene.expect(3, &[&["explain", "run"], &pixel[..]].concat());
    assert!(err.contains("another file than when"), "{err}");
    let (_, err) = scene.expect(3, &[&["explain", "."], &pixel[..]].concat());
    assert!(err.contains("run.json"), "{err}");
}

#[test]
fn a_pixel_that_is_not_there() {
    let scene = Scene::new();
    scene.write("scene.toml", include_str!("../tiny.toml"));
    let wrong = |code: i32, more: &[&str]| scene.expect(code, &[&["explain", "scene.toml"], more].concat()).1;
    let outside = wrong(2, &["--frame", "1", "--pixel", "400,3"]);
    assert!(outside.contains("--pixel") && outside.contains("columns 0..40"), "{outside}");
    let late = wrong(2, &["--frame", "100000", "--pixel", "4,3"]);
    assert!(late.contains("--frame 100000"), "{late}");
    let words = wrong(2, &["--frame", "1", "--pixel", "4"]);
    assert!(words.contains("column and line"), "{words}");
    let exact = wrong(2, &["--frame", "1", "--pixel", "400,3", "--machine", "exact"]);
    assert!(exact.contains("--pixel") && exact.contains("columns 0..40"), "{exact}");
    let needless = wrong(2, &["--frame", "1", "--pixel", "4,3", "--machine", "exact", "--no-exact"]);
    assert!(needless.contains("--no-exact"), "{needless}");
}

#[test]
fn other_generators_say_what_they_know_of_a_pixel() {
    let scene = Scene::new();
    scene.write("scene.toml", include_str!("../tiny.toml"));
    let of = |pixel, machine, more: &[&str]| {
        let line = ["explain", "scene.toml", "--frame", "1", "--pixel", pixel, "--machine", machine];
        scene.expect(0, &[&line, more].concat()).0
    };
    let ground = of("20,20", "exact", &[]);
    assert!(ground.starts_with("frame 1 (") && ground.contains("pixel 20,20, by exact"), "{ground}");
    let json: Value = serde_json::from_str(&of("20,20", "exact", &["--json"])).unwrap();
    let fact = |what: &str| {
        let facts = json["facts"].as_array().unwrap();
        facts.iter().find(|fact| fact["what"] == what).unwrap()["value"].as_str().unwrap()
    };
    assert_eq!((json["schema"].as_str(), fact("label")), (Some("lunoid.facts/1"), "terrain"));
    let (machine, _) =
        scene.expect(0, &["explain", "scene.toml", "--frame", "1", "--pixel", "20,20", "--json"]);
    let machine: Value = serde_json::from_str(&machine).unwrap();
    let range: f64 = fact("range").strip_suffix(" m").unwrap().parse().unwrap();
    assert!((range - machine["exact"]["range_m"].as_f64().unwrap()).abs() < 1e-3, "{range}, {machine}");
    assert!(of("20,0", "exact", &[]).contains("sky"));
}
