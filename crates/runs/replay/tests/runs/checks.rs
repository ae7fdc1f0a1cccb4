//! Random sweeps of a run against `exact`.

use std::fs;
use std::path::Path;

use replay::{Outcome, ReplayError};
use serde_json::Value;
use tempfile::tempdir;

use crate::stage::{Wish, differences};

fn wish(check: u32) -> Wish {
    Wish { check, ..Wish::default() }
}

fn record(folder: &Path, name: &str) -> Value {
    serde_json::from_slice(&fs::read(folder.join(name)).unwrap()).unwrap()
}

fn figure<'a>(check: &'a Value, error: &str) -> &'a Value {
    let errors = check["errors"].as_array().unwrap();
    errors.iter().find(|found| found["error"] == error).unwrap()
}

#[test]
fn a_check_says_how_far_the_run_is_off() {
    let at = tempdir().unwrap();
    let (plain, checked) = (at.path().join("plain"), at.path().join("checked"));
    wish(0).run(&plain).unwrap();
    wish(24).run(&checked).unwrap();
    // Nothing but the record knows of it.
    assert_eq!(differences(&plain, &checked), ["run.json"]);
    let (mut before, mut after) = (record(&plain, "run.json"), record(&checked, "run.json"));
    assert!(before["check"].is_null());
    let check = after["check"].take();
    before["check"].take();
    [&mut before, &mut after].into_iter().for_each(|record| drop(record["seal"].take()));
    assert_eq!(before, after);
    assert_eq!((check["sweeps"].as_u64(), check["checked"].as_array().unwrap().len()), (Some(24), 24));
    let frames: Vec<u64> =
        check["checked"].as_array().unwrap().iter().map(|sweep| sweep["frame"].as_u64().unwrap()).collect();
    assert_eq!(frames.iter().filter(|frame| **frame == 7).count(), 2, "two a frame: {frames:?}");
    // Signals are good to rounding of f32; between 80 samples a sweep the picture is not.
    for (error, least, most) in [
        ("height", 1e-9, 1e-6),
        ("slope", 1e-11, 1e-7),
        ("reflectivity", 1e-10, 1e-6),
        ("picture", 1e-4, 0.01),
    ] {
        let found = figure(&check, error);
        let number = |value: &Value| value.as_f64().unwrap();
        let [rms, max] = ["rms", "max"].map(|key| number(&found[key]));
        let [low, high] = [0, 1].map(|end| number(&found["interval"][end]));
        assert!((least..most).contains(&rms), "{error}: {found}");
        assert!(low <= rms && rms <= high && rms <= max && low < high, "{error}: {found}");
    }
    let phases = record(&checked, "performance.json")["phases"].clone();
    let phase = phases.as_array().unwrap().iter().find(|phase| phase["phase"] == "check").unwrap();
    assert!(phase["seconds"].as_f64().unwrap() > 0.0);
}

#[test]
fn the_same_sweeps_however_the_run_came_about() {
    let at = tempdir().unwrap();
    let whole = at.path().join("whole");
    wish(9).run(&whole).unwrap();
    let cut = at.path().join("cut");
    let outcome = Wish { cancel_after: Some(4), threads: 1, ..wish(9) }.run(&cut).unwrap();
    assert!(matches!(outcome, Outcome::Interrupted { .. }), "{outcome:?}");
    wish(9).run(&cut).unwrap();
    assert_eq!(differences(&whole, &cut), Vec::<String>::new());
    let later = at.path().join("later");
    wish(0).run(&later).unwrap();
    let drawing = record(&later, "performance.json")["frames_drawn"].clone();
    Wish { threads: 5, ..wish(9) }.run(&later).unwrap();
    assert_eq!(differences(&whole, &later), Vec::<String>::new());
    // The time of the check joins those of the drawing.
    let times = record(&later, "performance.json");
    assert_eq!(times["frames_drawn"], drawing);
    assert!(times["phases"].as_array().unwrap().iter().any(|phase| phase["phase"] == "check"));
}

#[test]
fn a_check_stays_until_frames_or_numbers_change() {
    let at = tempdir().unwrap();
    let check = |wish: Wish| {
        wish.run(at.path()).unwrap();
        record(at.path(), "run.json")["check"].clone()
    };
    let first = check(Wish { frames: 0..6, ..wish(5) });
    assert_eq!(check(Wish { frames: 0..6, ..wish(0) }), first);
    let more = check(Wish { frames: 0..6, ..wish(6) });
    assert_eq!(more["sweeps"], 6);
    // Of more frames it no longer speaks.
    assert!(check(wish(0)).is_null());
}

#[test]
fn more_sweeps_than_there_are_cannot_be_checked() {
    let at = tempdir().unwrap();
    let refused = Wish { frames: 0..1, ..wish(41) }.run(at.path()).unwrap_err();
    assert!(matches!(refused, ReplayError::TooManyChecks { asked: 41, available: 40 }), "{refused}");
    assert!(!at.path().join("frames").exists(), "drawn first and refused then");
    let all = Wish { frames: 0..1, ..wish(40) }.run(at.path()).unwrap();
    assert!(matches!(all, Outcome::Finished { .. }));
}
