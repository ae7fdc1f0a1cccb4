//! `lunoid timing columns`: from a column to its cause.

use serde_json::Value;

use crate::scene::Scene;

/// High ground, quick sweeps: what is late or off shows.
fn scene() -> Scene {
    let scene = Scene::new();
    let rugged = include_str!("../tiny.toml")
        .replace("rms_height_m = 2", "rms_height_m = 9")
        .replace("elevation_deg = 15", "elevation_deg = 25")
        .replace("update_hz = 10", "update_hz = 30")
        .replace("sweeps = 40", "sweeps = 400")
        .replace("samples_per_sweep = 80", "samples_per_sweep = 160");
    scene.write("rugged.toml", rugged);
    scene
}

fn columns(scene: &Scene, code: i32, more: &[&str]) -> Value {
    let command = ["timing", "columns", "rugged.toml", "--frame", "2", "--json"];
    let (out, _) = scene.expect(code, &[&command[..], more].concat());
    serde_json::from_str(&out).unwrap()
}

fn total(document: &Value, name: &str) -> u64 {
    document["totals"][name].as_u64().unwrap()
}

#[test]
fn nothing_differs_from_itself() {
    let document = columns(&scene(), 0, &["--machine", "ideal", "--levels", "0"]);
    assert_eq!((total(&document, "compared"), total(&document, "differing")), (400, 0));
}

/// Each fault of the timing alone: every column that differs leads to lines of its own sweeps.
#[test]
fn columns_of_late_words_and_set_ups_lead_to_their_lines() {
    let scene = scene();
    let slow = ["--set", "loader.access_ns=3000"];
    for (fault, more) in [("tear", &slow[..]), ("stale", &[]), ("mirror", &[]), ("stripe", &[])] {
        let document = columns(&scene, 0, &[&["--overlay", fault], more].concat());
        let differing = total(&document, "differing");
        assert!(differing > 10, "{fault}: {differing}");
        assert_eq!(total(&document, "traced"), differing, "{fault}");
        assert_eq!((total(&document, "parts_alone"), &document["classes"]["timing"]), (0, &differing.into()));
        for column in document["columns"].as_array().unwrap() {
            let (trace, is_stripe) = (&column["trace"], fault == "stripe");
            assert_eq!(column["without_timing"], 0, "{fault}: {column}");
            let lines = trace["lines"].as_array().unwrap();
            let deadline = if is_stripe { "sweep-set-up" } else { "transfer" };
            let has = |line: &Value| line["missed"]["deadline"] == deadline;
            assert!(lines.iter().any(has), "{fault}: {column}");
            assert_eq!(is_stripe, !trace["drawn_with"].as_array().unwrap().is_empty(), "{fault}: {column}");
            let within = |line: &Value| {
                let (range, sweep) = (&line["missed"]["range_m"], &line["missed"]["sweep"]);
                let reach = trace["range_m"].as_f64().unwrap_or(f64::INFINITY);
                let sweeps = trace["sweeps"][0].as_u64()..=trace["sweeps"][1].as_u64();
                range.as_f64().is_none_or(|range| range <= reach) && sweeps.contains(&sweep.as_u64())
            };
            assert!(lines.iter().all(within), "{fault}: {column}");
        }
    }
}

#[test]
fn columns_of_parts_need_no_line() {
    for fault in ["quilt", "ghost"] {
        let document = columns(&scene(), 0, &["--overlay", fault]);
        let differing = total(&document, "differing");
        assert!(differing > 100, "{fault}: {differing}");
        assert_eq!((total(&document, "parts_alone"), total(&document, "traced")), (differing, 0), "{fault}");
    }
}

#[test]
fn everything_at_once_is_still_accounted_for() {
    let scene = scene();
    let document = columns(&scene, 0, &["--machine", "pra-overloaded"]);
    let [differing, traced, parts] =
        ["differing", "traced", "parts_alone"].map(|name| total(&document, name));
    assert!(differing > 300 && traced > 300 && traced + parts == differing, "{}", document["totals"]);
    assert_eq!(total(&document, "untraced"), 0);
}

#[test]
fn text_and_picture_say_the_same() {
    let scene = scene();
    let command =
        ["timing", "columns", "rugged.toml", "--overlay", "stale", "--frame", "2", "--out", "c.png"];
    let (out, _) = scene.expect(0, &command);
    let words = ["Tiny on ideal, frame 2", "timing, ", "transfer", "columns beyond 8 levels: compared 400"];
    assert!(words.iter().all(|word| out.contains(word)), "{out}");
    assert!(scene.join("c.png").is_file());
    let (_, err) = scene.expect(2, &["timing", "columns", "rugged.toml", "--frame", "99"]);
    assert!(err.contains("the scenario has frames 0..4"), "{err}");
    let (_, err) =
        scene.expect(2, &["timing", "columns", "rugged.toml", "--frame", "1", "--machine", "exact"]);
    assert!(err.contains("no sweeps and no deadlines; expected a hardware model"), "{err}");
}
