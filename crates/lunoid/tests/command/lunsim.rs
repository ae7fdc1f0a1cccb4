//! `--machine lunsim`: refused with its restrictions, drawn without them, and told in the record.

use crate::scene::Scene;

#[test]
fn restrictions_are_refused_and_lifted_on_the_command_line() {
    let scene = Scene::new();
    let (_, err) = scene.expect(3, &["replay", "tiny.toml", "-q", "--machine", "lunsim", "--out", "r"]);
    let words = [
        "lunsim cannot do ground of any relief",
        "a sun at azimuth 100.000 deg",
        "lunsim.restrictions=false",
    ];
    assert!(words.iter().all(|word| err.contains(word)), "{err}");
    let lifted = ["--machine", "lunsim", "--set", "lunsim.restrictions=false", "--set", "lunsim.grid=64"];
    scene
        .expect(0, &[&["replay", "tiny.toml", "-q", "--frames", "0..1", "--out", "s"], &lifted[..]].concat());
    let record: serde_json::Value =
        serde_json::from_slice(&std::fs::read(scene.join("s/run.json")).unwrap()).unwrap();
    assert_eq!(record["generator"], "lunsim");
    let run = serde_json::json!({ "grid": 64, "intensity_codes": 16, "restrictions": false });
    assert_eq!(record["settings"]["lunsim"], run);
    let (_, err) = scene.expect(3, &["replay", "tiny.toml", "--set", "lunsim.gird=64"]);
    assert!(err.contains("gird"), "{err}");
    let (_, err) = scene.expect(2, &["timing", "show", "tiny.toml", "--machine", "lunsim"]);
    assert!(err.contains("--machine lunsim") && err.contains("expected a hardware model"), "{err}");
}

#[test]
fn machines_are_models_and_generators() {
    let (out, _) = Scene::new().expect(0, &["list", "machines", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    let names: Vec<_> =
        document["generators"].as_array().unwrap().iter().map(|row| &row["generator"]).collect();
    assert_eq!(names, ["exact", "lunsim"]);
    assert!(document["models"].as_array().unwrap().iter().any(|row| row["name"] == "ideal"));
}
