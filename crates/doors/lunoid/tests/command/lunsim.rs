//! `--machine lunsim`: refused with its restrictions, drawn without them, and told in the record.

use crate::scene::Scene;

/// A grid of 64 points a side over any ground.
const LIFTED: [&str; 6] =
    ["--machine", "lunsim", "--set", "lunsim.restrictions=false", "--set", "lunsim.grid=64"];

/// A command over the tiny scene, its restrictions lifted.
fn lifted(scene: &Scene, code: i32, command: &[&str], rest: &[&str]) -> (String, String) {
    scene.expect(code, &[command, rest, &LIFTED[..]].concat())
}

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
    lifted(&scene, 0, &["replay", "tiny.toml", "-q"], &["--frames", "0..1", "--out", "s"]);
    let record: serde_json::Value =
        serde_json::from_slice(&std::fs::read(scene.join("s/run.json")).unwrap()).unwrap();
    assert_eq!(record["generator"], "lunsim");
    let run = serde_json::json!({ "grid": 64, "intensity_codes": 16, "restrictions": false });
    assert_eq!(record["settings"], run);
    let (_, err) = scene.expect(3, &["replay", "tiny.toml", "--set", "lunsim.gird=64"]);
    assert!(err.contains("gird"), "{err}");
    for command in [&["sizing"][..], &["timing", "columns", "--frame", "0"]] {
        let (_, err) = scene.expect(2, &[command, &["tiny.toml", "--machine", "lunsim"]].concat());
        assert!(err.contains("--machine lunsim") && err.contains("expected a hardware model"), "{err}");
    }
    // Also where the scenario names it, and not the command line.
    scene.vary("own.toml", "format = 1", "format = 1\nmachine = \"lunsim\"");
    let (_, err) = scene.expect(2, &["lockstep", "own.toml"]);
    assert!(err.contains("there is no interpreter of it"), "{err}");
}

#[test]
fn machines_are_models_and_generators() {
    let (out, _) = Scene::new().expect(0, &["list", "machines", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    let names: Vec<_> =
        document["generators"].as_array().unwrap().iter().map(|row| &row["generator"]).collect();
    assert!(["exact", "lunsim"].iter().all(|name| names.iter().any(|row| *row == name)), "{names:?}");
    assert!(document["models"].as_array().unwrap().iter().any(|row| row["name"] == "ideal"));
}

/// A row of the grid stands for a sweep.
#[test]
fn rows_of_the_grid_are_listed_and_probed() {
    let scene = Scene::new();
    let probe = |code, rest: &[&str]| lifted(&scene, code, &["probe", "tiny.toml", "--frame", "0"], rest);
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
    let (_, err) = probe(2, &["--sweep", "1", "--signals", "tg.height", "--out", "rows.csv"]);
    assert!(err.contains("tg.height: no signal of this name"), "{err}");
    let (_, err) = lifted(&scene, 2, &["replay", "tiny.toml"], &["--out", "r", "--check", "1"]);
    assert!(err.contains("lunsim has no sweeps"), "{err}");
    scene.vary("lunsim.toml", "[sun]", "[lunsim]\nrestrictions = false\ngrid = 64\n\n[sun]");
    let (out, _) = scene.expect(0, &["signals", "lunsim.toml", "--machine", "lunsim", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&document["machine"], document["signals"].as_array().unwrap().len()), (&"lunsim".into(), 9));
    assert_eq!(document["signals"][8]["full_scale"], 15.0);
    assert_eq!(document["signals"][0]["block"], "lunsim");
}

/// Across the line of sight, in metres to both sides; nothing runs in time along a row.
#[test]
fn a_row_is_a_page_of_the_scope() {
    let scene = Scene::new();
    let row = ["probe", "tiny.toml", "--frame", "0", "--sweep", "40"];
    let probe = |code, rest: &[&str]| lifted(&scene, code, &row, rest);
    probe(0, &["--out", "row.csv", "--signals", "lunsim.across"]);
    let text = std::fs::read_to_string(scene.join("row.csv")).unwrap();
    let places: Vec<f64> =
        text.lines().filter_map(|line| line.split(',').next_back()?.parse().ok()).collect();
    assert_eq!(places.len(), 64);
    assert!(places[0] < 0.0 && places[63] > 0.0, "{places:?}");
    let cursors = format!("{},{}", 0.5 * places[0], 0.5 * places[63]);
    probe(0, &["--out", "row.svg", "--cursor", &cursors, "--from", &format!("{}", 0.9 * places[0])]);
    let page = std::fs::read_to_string(scene.join("row.svg")).unwrap();
    let words =
        ["across the line of sight (m)", "point", "row 40 of 64", "lunsim.height", "lunsim.shadow", "at A"];
    assert!(words.iter().all(|word| page.contains(word)), "{page}");
    assert!(!page.contains("(V)") && !page.contains("sweep time"), "a row has neither voltage nor time");
    for (rest, word) in
        [(&["--axis", "time"][..], "--axis time"), (&["--cursor", "3us"], "3us"), (&["--from", "8us"], "8us")]
    {
        let (_, err) = probe(2, &[&["--out", "row.png"], rest].concat());
        assert!(err.contains(word) && err.contains("a row has no sweep time"), "{err}");
    }
    let (_, err) = probe(2, &["--out", "row.png", "--signals", "lunsim.along"]);
    assert!(
        err.contains("none of them runs along the row; a picture needs one beside lunsim.across"),
        "{err}"
    );
    let (_, err) = probe(2, &["--out", "row.png", "--cursor", "1e9"]);
    assert!(err.contains("--cursor 1000000000 m: the samples lie from -127"), "{err}");
}

#[test]
fn a_run_has_rows_and_run_time_on_its_page() {
    let scene = Scene::new();
    let run = ["replay", "tiny.toml", "-q", "--frames", "0..2", "--out", "r"];
    let replay = |code, rest: &[&str]| lifted(&scene, code, &run, rest);
    let page = || std::fs::read_to_string(scene.join("r/index.html")).unwrap();
    replay(0, &[]);
    assert!(page().contains("No row was recorded") && page().contains("--probe FRAME:ROW"));
    assert!(page().contains("of the gear of 1969") && page().contains("There are no deadlines"));
    replay(0, &["--probe", "1:40", "--probe", "0:41:lunsim.height"]);
    assert!(page().contains("Frame 1, row 40.") && page().contains("Frame 0, row 41."));
    assert!(!page().contains("data-sweep=\"40\""), "a row is no column of the picture");
    let svg = std::fs::read_to_string(scene.join("r/scopes/frame-000001-sweep-0040.svg")).unwrap();
    assert!(svg.contains("across the line of sight (m)"), "{svg}");
    let (_, err) = replay(2, &["--probe", "0:64"]);
    assert!(err.contains("a frame has sweeps 0..64"), "{err}");
    let (_, err) = replay(2, &["--probe", "0:3:tg.height"]);
    assert!(err.contains("no signal of this name"), "{err}");
}

/// The shipped baseline by the command of its guide, its inputs among what is held; and what a program has not.
#[test]
fn its_timing_is_recorded_checked_and_shown() {
    let scene = Scene::new();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    let scenario = format!("{root}/scenarios/lunsim-landing.toml");
    let baseline = format!("{root}/tests/timing-baselines/lunsim-landing.lunsim.json");
    scene.expect(0, &["timing", "check", &scenario, "--frames", "3..4", "--baseline", &baseline]);
    let timing = |code, what: &str, rest: &[&str]| {
        scene.expect(code, &[&["timing", what, "tiny.toml", "--no-progress"], rest, &LIFTED[..]].concat())
    };
    timing(0, "record", &["--out", "base.json"]);
    timing(0, "check", &["--baseline", "base.json", "--junit", "check.xml", "--jobs", "1"]);
    let (out, _) = timing(1, "check", &["--baseline", "base.json", "--set", "recorder.points_s=5000"]);
    assert!(out.contains("-inputs: ") && out.contains("+units.recorder.busy: "), "{out}");
    let (out, _) = timing(0, "show", &["--frame", "1", "--utilisation", "use.png"]);
    assert!(out.contains("recorder   plotting") && out.contains("frame  cpu (s)"), "{out}");
    let (out, _) = timing(0, "show", &["--json"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["record"]["frames"][0]["tasks"][0]["task"], "drops");
    assert_eq!(document["critical_path"], serde_json::Value::Null);
    for option in [&["--slack", "a.png"][..], &["--misses", "3"]] {
        let (_, err) = timing(2, "show", option);
        assert!(err.contains(option[0]) && err.contains("lunsim has no deadlines"), "{err}");
    }
    let (_, err) = timing(3, "show", &["--set", "computer.add_us=-1"]);
    assert!(err.contains("computer.add_us") && err.contains("from 0.001"), "{err}");
}
