//! What is found is what the waveforms say.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;
use crate::{json, with};

fn places(scene: &Scene, code: i32, more: &[&str]) -> Vec<Value> {
    let (out, _) = scene.expect(code, &[&["trigger", "tiny.toml", "--json", "-q"], more].concat());
    json(&out)["places"].as_array().unwrap().clone()
}

/// Heights of a frame by sweep and sample, as `probe` writes them.
fn heights(scene: &Scene, frame: &str) -> Vec<Vec<f64>> {
    scene.expect(
        0,
        &[
            "probe",
            "tiny.toml",
            "--frame",
            frame,
            "--sweep",
            "0..40",
            "--signals",
            "tg.height",
            "--out",
            "h.csv",
        ],
    );
    let text = fs::read_to_string(scene.join("h.csv")).unwrap();
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let place = |name: &str| head.iter().position(|word| word.starts_with(name)).unwrap();
    let (sweep, height) = (place("sweep"), place("tg.height"));
    let mut sweeps = vec![Vec::new(); 40];
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        sweeps[cells[sweep].parse::<usize>().unwrap()].push(cells[height].parse().unwrap());
    }
    sweeps
}

#[test]
fn every_rise_is_found_and_no_other() {
    let scene = Scene::new();
    let all = heights(&scene, "1");
    let flat: Vec<f64> = all.iter().flatten().copied().collect();
    let (low, high) = flat.iter().fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(*v), high.max(*v)));
    let level = 0.5 * (low + high);
    let mut expected = Vec::new();
    for (sweep, values) in all.iter().enumerate() {
        for k in 1..values.len() {
            if values[k - 1] < level && values[k] >= level {
                let share = (level - values[k - 1]) / (values[k] - values[k - 1]);
                expected.push((sweep as u64, k as u64, (k - 1) as f64 + share));
            }
        }
    }
    assert!(expected.len() > 3, "{expected:?}");
    let found = places(&scene, 0, &["--frames", "1", "--all", "--on", &format!("rising tg.height {level}")]);
    let of = |place: &Value| {
        (
            place["sweep"].as_u64().unwrap(),
            place["sample"].as_u64().unwrap(),
            place["instant"].as_f64().unwrap(),
        )
    };
    let found: Vec<(u64, u64, f64)> = found.iter().map(of).collect();
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!((found.0, found.1), (expected.0, expected.1));
        assert!((found.2 - expected.2).abs() < 1e-3, "{found:?} {expected:?}");
    }
    // In part of the frame only these.
    let part = places(
        &scene,
        0,
        &["--frames", "1", "--sweep", "5..27", "--all", "--on", &format!("rising tg.height {level}")],
    );
    assert_eq!(part.len(), expected.iter().filter(|place| (5..27).contains(&place.0)).count());
}

#[test]
fn the_nth_is_the_nth_of_all_and_threads_and_ranges_change_nothing() {
    let scene = Scene::new();
    let on = ["--on", "fold x and tg.slope.u > 0"];
    let all = places(&scene, 0, &[&on[..], &["--all", "-j", "2"]].concat());
    assert!(all.len() > 20);
    assert_eq!(all, places(&scene, 0, &[&on[..], &["--all", "-j", "1"]].concat()));
    let plain =
        |place: &Value| ["frame", "sweep", "sample", "instant", "values"].map(|key| place[key].clone());
    for nth in [1, 7, all.len()] {
        let one = places(&scene, 0, &[&on[..], &["--nth", &nth.to_string()]].concat());
        assert_eq!((one.len(), plain(&one[0])), (1, plain(&all[nth - 1])));
    }
    let beyond = (all.len() + 1).to_string();
    assert!(places(&scene, 1, &[&on[..], &["--nth", &beyond]].concat()).is_empty());
    let parts =
        ["0..1", "1..4"].map(|frames| places(&scene, 0, &[&on[..], &["--all", "--frames", frames]].concat()));
    assert_eq!(
        parts.concat().iter().map(plain).collect::<Vec<_>>(),
        all.iter().map(plain).collect::<Vec<_>>()
    );
}

#[test]
fn late_loads_are_those_of_the_timing_record() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &with(&["timing", "show", "tiny.toml"], &["--frames", "1", "--json"]));
    let record = json(&out);
    let misses = record["record"]["frames"][0]["misses"].as_array().unwrap().clone();
    assert!(misses.len() > 100, "{}", misses.len());
    let command =
        with(&["trigger", "tiny.toml", "-q", "--json"], &["--frames", "1", "--all", "--on", "late-load"]);
    let (out, _) = scene.expect(0, &command);
    let found = json(&out);
    let of_record: Vec<(u64, f64, u64)> = misses
        .iter()
        .map(|miss| {
            (miss["sweep"].as_u64().unwrap(), miss["due"].as_f64().unwrap(), miss["words"].as_u64().unwrap())
        })
        .collect();
    let of_trigger: Vec<(u64, f64)> = found["places"]
        .as_array()
        .unwrap()
        .iter()
        .map(|place| (place["sweep"].as_u64().unwrap(), place["instant"].as_f64().unwrap()))
        .collect();
    assert_eq!(of_trigger.len(), of_record.len());
    for (found, expected) in of_trigger.iter().zip(&of_record) {
        assert!(found.0 == expected.0 && (found.1 - expected.1).abs() < 1e-9, "{found:?} {expected:?}");
    }
    scene.expect(1, &["trigger", "tiny.toml", "-q", "--on", "late-load"]);
}

#[test]
fn a_place_has_its_neighbours_and_commands_that_go_on() {
    let scene = Scene::new();
    let on = ["--sweep", "2..38", "--on", "blank", "--nth", "3", "--around", "1", "--around-sweeps", "1"];
    let found = places(&scene, 0, &on);
    let [place] = &found[..] else { panic!("{found:?}") };
    let rows = place["around"].as_array().unwrap();
    let (sweep, sample) = (place["sweep"].as_u64().unwrap(), place["sample"].as_u64().unwrap());
    let own: Vec<&Value> = rows.iter().filter(|row| row["sweep"] == sweep).collect();
    assert_eq!((rows.len(), own.len()), (5, 3));
    assert_eq!(
        own.iter().map(|row| row["sample"].as_u64().unwrap()).collect::<Vec<_>>(),
        (sample - 1..=sample + 1).collect::<Vec<_>>()
    );
    assert_eq!(
        (&own[0]["values"]["dpp.blank"], &own[1]["values"]["dpp.blank"]),
        (&Value::from(0.0), &Value::from(1.0))
    );
    assert_eq!(place["is_blanked"], true);
    for command in place["next"].as_array().unwrap() {
        let words: Vec<&str> = command.as_str().unwrap().split(' ').skip(1).collect();
        scene.expect(0, &words);
    }
    assert_eq!(place["next"].as_array().unwrap().len(), 3);
    assert!(scene.join("sweep.png").exists());
    let (text, _) = scene.expect(0, &[&["trigger", "tiny.toml", "-q"], &on[..]].concat());
    assert!(text.contains("the beam is blanked here") && text.contains("\n=>"), "{text}");
}

/// The pixel that is told leads back to the sweep, and near the sample.
#[test]
fn the_pixel_shows_the_place() {
    let scene = Scene::new();
    for frame in ["0", "3"] {
        let found =
            places(&scene, 0, &["--frames", frame, "--sample", "12..60", "--on", "fold x", "--nth", "3"]);
        let [x, y] = [0, 1].map(|axis| found[0]["pixel"][axis].as_u64().unwrap());
        let pixel = format!("{x},{y}");
        let explain = ["explain", "tiny.toml", "--frame", frame, "--pixel", &pixel, "--no-exact", "--json"];
        let told = json(&scene.expect(0, &explain).0);
        assert_eq!(told["place"]["sweep"], found[0]["sweep"]);
        let away = told["ground"]["range_m"].as_f64().unwrap() / found[0]["range_m"].as_f64().unwrap();
        assert!((0.7..1.5).contains(&away), "{away}");
    }
}

#[test]
fn the_sweep_is_written_in_every_format() {
    let scene = Scene::new();
    let on = ["trigger", "tiny.toml", "-q", "--on", "rising sweep.x 0.5", "--signals", "mu.*", "--out"];
    for (name, head) in [
        ("a.csv", &b""[..]),
        ("a.vcd", b"$"),
        ("a.fst", b""),
        ("a.npz", b"PK"),
        ("a.json", b"{"),
        ("a.raw", b"Title:"),
        ("a.sr", b"PK"),
        ("a.png", b"\x89PNG"),
        ("a.svg", b"<svg"),
    ] {
        let (_, err) = scene.expect(0, &[&on[..], &[name]].concat());
        let bytes = fs::read(scene.join(name)).unwrap();
        assert!(bytes.len() > 100 && bytes.starts_with(head), "{name}: {err}");
        assert!(err.starts_with(name), "{name}: {err}");
    }
    scene.expect(0, &[&on[..], &["b.csv", "--around-sweeps", "2"]].concat());
    let rows = fs::read_to_string(scene.join("b.csv")).unwrap();
    let found = places(&scene, 0, &["--on", "rising sweep.x 0.5"]);
    let sweep = found[0]["sweep"].as_u64().unwrap();
    let sweeps = (sweep + 2).min(39) - sweep.saturating_sub(2) + 1;
    let data = rows.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())).count() as u64;
    assert_eq!(data, 80 * sweeps, "{rows}");
}
