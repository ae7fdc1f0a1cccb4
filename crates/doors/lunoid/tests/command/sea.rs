//! `lunoid study sea`: what it finds, what it leaves in a folder, what it refuses; waves that cannot be.

use serde_json::Value;

use crate::scene::Scene;

/// A sea seen from 30 m above, half down.
const SEA: &str = r#"format = 1
title = "Water"
shows = "A sea of false normals, and waves in its place."
machine = "smooth-faces"
duration_s = 10
[landscape.generated]
seed = 1
extent_m = [600, 600]
region_size_m = 100
[sun]
azimuth_deg = 60
elevation_deg = 30
[sea]
square_m = 10
area_m = [0, 0, 600, 600]
state = 2
waves = { wind_m_s = 6, towards_deg = 240, components = 16, shortest_m = 6 }
[path]
file = "water.csv"
[raster]
columns = 24
lines = 16
update_hz = 2
[faces]
ground = false
order = "lists"
"#;

fn water() -> Scene {
    let scene = Scene::new();
    scene.write("water.toml", SEA);
    let head = "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg";
    scene.write("water.csv", format!("{head}\n0,300,300,30,0,-40,0\n10,300,300,30,0,-40,0\n"));
    scene
}

#[test]
fn a_sea_of_false_normals_has_one_frequency_and_waves_have_many() {
    let scene = water();
    let words = ["study", "sea", "water.toml", "--columns", "3", "--out", "found", "--json"];
    let (out, _) = scene.expect(0, &words);
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(told["schema"].as_str(), Some("lunoid.study-sea/1"));
    let of = |sea: &str, figure: &str| told[sea][figure].as_f64().unwrap();
    // State 2 turns its sun at 0.2 Hz; ten seconds are two turns.
    assert_eq!(of("imitation", "peak_hz"), 0.2);
    assert!((of("imitation", "mean_hz") - 0.2).abs() < 1e-4, "{told}");
    assert!(of("waves", "mean_hz") > 0.25, "{told}");
    let theory = told["spread_of_theory"].as_f64().unwrap();
    assert!((of("waves", "spread") / theory - 1.0).abs() < 0.25, "{told}");
    for file in ["sea.json", "sea.csv", "sea.md", "sea.svg"] {
        assert!(scene.path().join("found").join(file).exists(), "{file}");
    }
    let csv = std::fs::read_to_string(scene.path().join("found/sea.csv")).unwrap();
    assert!(csv.starts_with("frequency_hz,false_normals_per_hz,waves_per_hz,theory_per_hz\n0.1,"), "{csv}");
    assert_eq!(csv.lines().count(), 11);
}

#[test]
fn what_has_no_two_seas_is_refused() {
    let scene = water();
    let (_, said) = scene.expect(2, &["study", "sea", "water.toml", "--every", "4"]);
    assert!(said.contains("5 frames are looked at: a spectrum needs 8 or more"), "{said}");
    let (_, said) = scene.expect(2, &["study", "sea", "water.toml", "--machine", "exact"]);
    assert!(said.contains("--machine exact: it draws the waves"), "{said}");
    let (_, said) = scene.expect(3, &["study", "sea", "tiny.toml"]);
    assert!(said.contains("no `waves` in `[sea]`"), "{said}");
    scene.write(
        "water.csv",
        "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n0,300,300,30,0,60,0\n10,300,300,30,0,60,0\n",
    );
    let (_, said) = scene.expect(3, &["study", "sea", "water.toml", "--columns", "2"]);
    assert!(said.contains("no pixel shows the sea"), "{said}");
}

#[test]
fn waves_that_cannot_be_are_refused_with_their_place() {
    let scene = water();
    for (written, expected) in [
        ("wind_m_s = 60", "sea.waves.wind_m_s"),
        ("wind_m_s = 2", "the highest waves of this wind are 3.33 m long"),
        ("wind_m_s = 6, foam = 1", "foam"),
    ] {
        scene.write("water.toml", SEA.replacen("wind_m_s = 6", written, 1));
        let (_, said) = scene.expect(3, &["check", "water.toml"]);
        assert!(said.contains(expected) && said.contains("water.toml:17"), "{said}");
    }
}

#[test]
fn who_draws_no_waves_says_so() {
    let scene = water();
    scene.expect(0, &["replay", "water.toml", "--frames", "0..1", "--out", "run"]);
    let record = std::fs::read_to_string(scene.path().join("run/run.json")).unwrap();
    assert!(record.contains("sea of true waves (`sea.waves`): `exact` alone has it"), "{record}");
}
