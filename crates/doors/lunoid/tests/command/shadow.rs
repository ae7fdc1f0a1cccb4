//! `lunoid study shadow`: what it finds, what it leaves in a folder, what it refuses.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

#[test]
fn the_error_of_flat_ground_is_the_formulas() {
    let scene = Scene::new();
    let base = ["study", "shadow", "tiny.toml", "--sun", "20", "--azimuths", "8"];
    let (out, _) = scene.expect(0, &[&base[..], &["--out", "s"]].concat());
    assert!(out.contains("own ") && out.contains("20.0 deg") && out.contains("top 3.048 m"), "{out}");
    assert_eq!(
        scene.list("s"),
        ["shadow.csv", "shadow.json", "shadow.md", "shadow.png", "shadow.svg"].map(str::to_owned)
    );
    let document: Value = serde_json::from_slice(&fs::read(scene.join("s/shadow.json")).unwrap()).unwrap();
    assert_eq!(document["holds"], true);
    let [own, given] = [0, 1].map(|sun| &document["suns"][sun]);
    // A scenario of four frames: four places, its own sun at each, eight azimuths of the other.
    assert_eq!([&own["masts"], &given["masts"]], [4, 32]);
    assert_eq!(given["seen"], 32);
    let figure = |name: &str| given["figures"][name].as_f64().unwrap();
    assert!(figure("mean_rad") > 1e-3 && figure("mean_rise_m") > 1e-3, "{given}");
    // 3.048 m over the tangent of 20 degrees.
    assert!((figure("mean_distance_m") - 8.37431117449769).abs() < 1e-9, "{given}");
    assert!(figure("largest_difference_rad") < 1e-9, "{given}");
    let csv = fs::read_to_string(scene.join("s/shadow.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 4 + 32);
    assert!(fs::read_to_string(scene.join("s/shadow.md")).unwrap().contains("](shadow.svg)"));
}

#[test]
fn the_vehicle_and_the_level_of_the_ground_decide() {
    let scene = Scene::new();
    scene.vary("level.toml", "rms_height_m = 2", "rms_height_m = 1e-12");
    let found = |arguments: &[&str]| -> Value {
        let (out, _) = scene.expect(0, &[&["study", "shadow"], arguments, &["--json"]].concat());
        serde_json::from_str(&out).unwrap()
    };
    let level = found(&["level.toml"]);
    for sun in level["suns"].as_array().unwrap() {
        assert!(sun["figures"]["largest_rad"].as_f64().unwrap() < 1e-9, "{sun}");
    }
    let rover = found(&["tiny.toml", "--vehicle", "rover", "--eye-height", "1.25"]);
    assert_eq!(rover["eye_m"], 1.25);
    assert!(rover["top_m"].as_f64().unwrap() > 1.25 && rover["top_m"] != level["top_m"], "{rover}");
}

#[test]
fn laws_and_methods_are_held_against_true_ground() {
    let scene = Scene::new();
    // The sun behind the drive: the shadow lies before the eye.
    scene.vary("behind.toml", "azimuth_deg = 100", "azimuth_deg = 212");
    let behind = fs::read_to_string(scene.join("behind.toml")).unwrap();
    scene.write("level.toml", behind.replace("rms_height_m = 2", "rms_height_m = 1e-12"));
    let laws = |scenario: &str| -> Vec<Value> {
        let study = ["study", "shadow", scenario, "--vehicle", "rover", "--laws", "--frame", "1"];
        let more = ["--repetitions", "1", "--no-progress", "--json", "--out", "s"];
        let (out, _) = scene.expect(0, &[&study[..], &more].concat());
        serde_json::from_str::<Value>(&out).unwrap()["laws"].as_array().unwrap().clone()
    };
    let figure = |laws: &[Value], law: &str, method: &str, name: &str| -> f64 {
        let is_it = |row: &&Value| row["law"] == law && row["method"] == method;
        laws.iter().find(is_it).unwrap()[name].as_f64().unwrap()
    };
    let found = laws("behind.toml");
    let rms = |law: &str, method: &str| figure(&found, law, method, "rms");
    assert!(figure(&found, "true ground", "not rounded", "dark") > 1e-3, "{found:?}");
    assert_eq!(rms("true ground", "not rounded"), 0.0);
    let bits = [10, 8, 6].map(|bits| rms("true ground", &format!("converters of {bits} bits")));
    assert!(0.0 < bits[0] && bits[0] < bits[1] && bits[1] < bits[2], "{bits:?}");
    let tube = |words: &str| rms("true ground", &format!("scan converter, {words}"));
    assert!(tube("325 lines") > tube("650 lines, in register") && bits[0] < tube("650 lines, in register"));
    assert!(rms("true ground, penumbra", "not rounded") > 0.0);
    // On level ground both laws are one, to a thousandth of the light of a pixel; where there is relief they are not.
    let level = laws("level.toml");
    let flat = |laws: &[Value]| figure(laws, "flat ground, parts", "not rounded", "rms");
    assert!(flat(&level) < 1e-4 && flat(&found) > 1e-3, "{} {}", flat(&level), flat(&found));
    let aside = ["study", "shadow", "tiny.toml", "--vehicle", "rover", "--laws", "--repetitions", "1"];
    let (out, _) = scene.expect(0, &aside);
    assert!(out.contains("in none of these pictures"), "{out}");
    assert!(scene.list("s").contains(&"laws.svg".to_owned()));
    assert!(fs::read_to_string(scene.join("s/shadow.md")).unwrap().contains("Laws and methods"));
}

#[test]
fn what_makes_no_sense_is_refused() {
    let scene = Scene::new();
    for (arguments, words) in [
        (["--sun", "0"], "expected degrees from 0.1 to 89"),
        (["--sun", "nan"], "expected degrees from 0.1 to 89"),
        (["--places", "0"], "from 1 to 1000"),
        (["--azimuths", "361"], "from 1 to 360"),
        (["--eye-height", "-1"], "expected metres from 0.001"),
    ] {
        let (_, said) = scene.expect(2, &[&["study", "shadow", "tiny.toml"][..], &arguments].concat());
        assert!(said.contains(words), "{said}");
    }
    let (_, said) = scene.expect(2, &["study", "shadow", "tiny.toml", "--laws"]);
    assert!(said.contains("--vehicle"), "{said}");
    let beyond = ["study", "shadow", "tiny.toml", "--vehicle", "rover", "--laws", "--frame", "4"];
    let (_, said) = scene.expect(2, &beyond);
    assert!(said.contains("frames 0..4"), "{said}");
    scene.write("pit.obj", "v 0 0 -1\nv 1 0 -2\nv 0 1 -2\nv 0 0 -3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
    let (_, said) = scene.expect(3, &["study", "shadow", "tiny.toml", "--vehicle", "pit.obj"]);
    assert!(said.contains("pit.obj") && said.contains("expected a vehicle above 0"), "{said}");
    let (_, said) = scene.expect(3, &["study", "shadow", "tiny.toml", "--vehicle", "rowboat"]);
    assert!(said.contains("rowboat") && said.contains("lander, rover"), "{said}");
}
