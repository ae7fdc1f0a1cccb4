//! Tests of the command `lunoid model`.

use serde_json::Value;

use crate::scene::Scene;

#[test]
fn a_model_tells_where_its_values_came_from() {
    let scene = Scene::new();
    scene.write("over.toml", "format = 1\n[raster]\nupdate_hz = 15\n");
    let arguments = ["model", "show", "ideal", "--overlay", "over.toml", "--set", "raster.sweeps=525"];
    let (out, _) = scene.expect(0, &arguments);
    let line = |key: &str| out.lines().find(|line| line.starts_with(key)).unwrap_or_default().to_owned();
    assert!(
        line("raster.update_hz").contains("= 15") && line("raster.update_hz").contains("over.toml:3"),
        "{out}"
    );
    assert!(line("raster.sweeps").contains("= 525") && line("raster.sweeps").contains("--set"), "{out}");
    assert!(line("dpp.projection").contains("ideal.toml"), "{out}");
}

#[test]
fn two_models_differ_by_their_keys() {
    let scene = Scene::new();
    scene.write("mine.toml", "format = 1\nname = \"mine\"\nbase = \"ideal\"\n[raster]\nupdate_hz = 15\n");
    let (out, _) = scene.expect(1, &["model", "diff", "ideal", "mine.toml"]);
    let rows: Vec<Vec<&str>> = out.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(rows[0], ["key", "ideal", "mine.toml"], "{out}");
    assert_eq!((rows.len(), rows[1][0], rows[1].last()), (2, "raster.update_hz", Some(&"15")), "{out}");
    let document = json(&scene, 1, &["model", "diff", "ideal", "mine.toml"]);
    assert_eq!(document["differences"][0]["second"], "15");
    let (out, _) = scene.expect(0, &["model", "diff", "ideal", "ideal"]);
    assert!(out.contains("the same values"), "{out}");
    scene.expect(3, &["model", "diff", "ideal", "gone.toml"]);
}

fn json(scene: &Scene, code: i32, arguments: &[&str]) -> Value {
    let (out, _) = scene.expect(code, &[arguments, &["--json"]].concat());
    serde_json::from_str(&out).unwrap()
}

#[test]
fn diagram_and_budget_are_shown() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["model", "show", "pra-nominal", "--diagram"]);
    assert!(out.contains("terrain generator") && out.contains("108 D/A multipliers (36)"), "{out}");
    assert!(!out.contains("sweep period"), "{out}");
    let budget = ["model", "show", "pra-nominal", "--budget", "--region-size-m", "500", "--range-m", "5000"];
    let (out, _) = scene.expect(0, &budget);
    assert!(out.lines().any(|line| line.starts_with("sweep period") && line.contains("63.49 µs")), "{out}");
    let document = json(&scene, 0, &budget);
    assert_eq!(document["schema"], "lunoid.model/1");
    assert_eq!(document["budget"]["region_size_m"], 500.0);
    assert!((document["budget"]["axis_crossing_us"].as_f64().unwrap() - 5.26).abs() < 0.01, "{document}");
    assert!(document["parts"].is_null());
    let parts = &json(&scene, 0, &["model", "show", "ideal", "--diagram"])["parts"];
    assert_eq!((&parts["multipliers"], &parts["sub_generators"]), (&108.into(), &Value::Null));
    scene.expect(2, &["model", "show", "ideal", "--budget", "--region-size-m", "0"]);
}

#[test]
fn a_check_ends_with_its_verdict() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["model", "check", "pra-nominal"]);
    assert_eq!(out, "pra-nominal: nothing against it\n");
    let (out, _) = scene.expect(0, &["model", "check", "ideal", "--overlay", "tear"]);
    assert!(out.starts_with("warning A1  loader.access_ns, ") && out.lines().count() == 1, "{out}");
    let wrong = ["model", "check", "ideal", "--set", "loader.served_by=io-processor"];
    let (out, _) = scene.expect(1, &wrong);
    assert!(out.starts_with("refused  loader.words_per_access, loader.served_by"), "{out}");
    let document = json(&scene, 1, &wrong);
    assert_eq!((&document["schema"], &document["ok"]), (&"lunoid.model.check/1".into(), &false.into()));
    assert_eq!(document["findings"][0]["grade"], "refuse");
    let document = json(&scene, 0, &["model", "check", "pra-nominal", "--region-size-m", "20"]);
    assert!(document["findings"].as_array().unwrap().iter().any(|finding| finding["artefact"] == "A1"));
}

#[test]
fn a_model_that_cannot_be_read_is_bad_input() {
    let scene = Scene::new();
    scene.write("bad.toml", "format = 1\nname = \"bad\"\nbase = \"ideal\"\n[sweep]\ndac_bits = 0\n");
    for command in [&["model", "check", "bad.toml"][..], &["model", "show", "bad.toml", "--budget"]] {
        let (out, err) = scene.expect(3, command);
        assert!(out.is_empty() && err.contains("sweep.dac_bits"), "{err}");
    }
    scene.expect(3, &["model", "check", "nominal"]);
}

#[test]
fn models_and_overlays_are_listed_once() {
    let scene = Scene::new();
    std::fs::create_dir_all(scene.join("hardware-models/faults")).unwrap();
    scene.write("hardware-models/mine.toml", "format = 1\nname = \"mine\"\nbase = \"pra-nominal\"\n");
    scene.write("hardware-models/faults/mine.toml", "format = 1\n[loader]\naccess_ns = 90\n");
    let (out, _) = scene.expect(0, &["model", "list"]);
    for name in [
        "ideal",
        "pra-nominal",
        "pra-frugal",
        "pra-overloaded",
        "pra-parts",
        "pra-wires",
        "modern-analog",
        "mine",
        "tear",
    ] {
        assert_eq!(
            out.lines().filter(|line| line.split(' ').next() == Some(name)).count(),
            1,
            "{name}:\n{out}"
        );
    }
    assert!(out.contains("A23, roll steps") && !out.contains("fault:"), "{out}");
    let document = json(&scene, 0, &["model", "list"]);
    assert_eq!(document["models"].as_array().unwrap().len(), 8);
    assert_eq!(document["overlays"].as_array().unwrap().len(), 25);
}

/// A digital memory of four bits keeps fifteenths of the white of the display, in whatever way the sweeps are drawn.
#[test]
fn a_digital_memory_keeps_words() {
    let scene = Scene::new();
    let cells = |more: &[&str]| {
        let probe = [
            "probe",
            "tiny.toml",
            "--frame",
            "1",
            "--sweep",
            "all",
            "--signals",
            "sm.write",
            "--out",
            "w.csv",
        ];
        let model = ["--machine", "ideal", "--set", "sweep_memory.kind=digital-memory"];
        scene.expect(0, &[&probe[..], &model, more].concat());
        let text = std::fs::read_to_string(scene.join("w.csv")).unwrap();
        let rows = text.lines().filter(|line| line.starts_with("1,"));
        rows.map(|row| row.rsplit(',').next().unwrap().parse().unwrap()).collect::<Vec<f64>>()
    };
    for quality in [&[][..], &["--lossless"]] {
        let whole = cells(quality);
        let words = cells(&[&["--set", "sweep_memory.bits=4"], quality].concat());
        let mut seen = std::collections::BTreeSet::new();
        for (cell, word) in whole.iter().zip(&words) {
            let number = (15.0 * word).round();
            assert!((15.0 * word - number).abs() < 1e-6 && (15.0 * cell - number).abs() < 0.5 + 1e-5);
            seen.insert(number as i64);
        }
        assert!(whole.len() == words.len() && words.len() > 1000 && seen.len() > 3, "{seen:?}");
    }
    let idle = ["model", "check", "ideal", "--set", "sweep_memory.bits=2"];
    assert!(scene.expect(0, &idle).0.contains("the memory is a scan converter"));
}
