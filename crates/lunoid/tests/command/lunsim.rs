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

/// A row of the grid stands for a sweep.
#[test]
fn rows_of_the_grid_are_listed_and_probed() {
    let scene = Scene::new();
    let lunsim = ["--machine", "lunsim", "--set", "lunsim.restrictions=false", "--set", "lunsim.grid=64"];
    let probe = |code, rest: &[&str]| {
        scene.expect(code, &[&["probe", "tiny.toml", "--frame", "0"], rest, &lunsim[..]].concat())
    };
    probe(0, &["--sweep", "62..64", "--signals", "lunsim.height,*.code", "--out", "rows.csv"]);
    let text = std::fs::read_to_string(scene.join("rows.csv")).unwrap();
    let rows = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())).count();
    assert_eq!(rows, 128, "{text}");
    assert!(
        text.starts_with("frame,sweep,index,time [s],lunsim.height [m],lunsim.code [1]\n0,62,0,"),
        "{text}"
    );
    for format in ["fst", "vcd", "npz", "json", "raw", "sr"] {
        probe(0, &["--sweep", "0..2", "--out", &format!("rows.{format}")]);
    }
    let (_, err) = probe(2, &["--sweep", "64", "--out", "rows.csv"]);
    assert!(err.contains("a frame has sweeps 0..64"), "{err}");
    let (_, err) = probe(2, &["--sweep", "1", "--out", "rows.png"]);
    assert!(err.contains("lunsim has no sweeps that a scope could show"), "{err}");
    let (_, err) = probe(2, &["--sweep", "1", "--signals", "tg.height", "--out", "rows.csv"]);
    assert!(err.contains("tg.height: no signal of this name"), "{err}");
    let (_, err) =
        scene.expect(2, &[&["replay", "tiny.toml", "--out", "r", "--check", "1"], &lunsim[..]].concat());
    assert!(err.contains("lunsim has no sweeps"), "{err}");
    scene.vary("lunsim.toml", "[sun]", "[lunsim]\nrestrictions = false\ngrid = 64\n\n[sun]");
    let (out, _) = scene.expect(0, &["signals", "lunsim.toml", "--machine", "lunsim", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&document["machine"], document["signals"].as_array().unwrap().len()), (&"lunsim".into(), 9));
    assert_eq!(document["signals"][8]["full_scale"], 15.0);
    assert_eq!(document["signals"][0]["block"], "lunsim");
}
