//! Pixels that late words changed (`explain --late`), and that a timing changed (`timing check --pictures`); delays and model
//! files that are odd.

use serde_json::Value;

use crate::scene::Scene;

/// `tiny.toml` on the nominal machine with a buffer that holds all of it, slow enough for late sets.
const LATE: [&str; 6] =
    ["--machine", "pra-nominal", "--set", "buffer.words=unlimited", "--set", "loader.access_ns=20000"];

fn on_late<'a>(command: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    command.iter().chain(&LATE).chain(more).copied().collect()
}

#[test]
fn late_words_lead_to_the_pixels_that_they_changed() {
    let scene = Scene::new();
    let trace = on_late(&["trace", "tiny.toml", "--frame", "1"], &["--event", "late", "--csv"]);
    let (listing, _) = scene.expect(0, &trace);
    let explain =
        |more: &[&str]| scene.expect(0, &on_late(&["explain", "tiny.toml", "--frame", "1"], more)).0;
    let tell = |line: &str| -> Value { serde_json::from_str(&explain(&["--late", line, "--json"])).unwrap() };
    let mut found = listing.lines().skip(1).map(|line| (line, tell(line)));
    let (line, told) =
        found.find(|(_, told)| told["frames"][0]["changed"] != 0).expect("some change a pixel");
    assert_eq!(told["schema"], "lunoid.explain.late/1");
    let cells: Vec<&str> = line.split(',').collect();
    assert_eq!([told["sweep"].to_string(), told["crossing"].to_string()], [cells[2], cells[6]]);
    // Two tubes in turn: the next frame of the same tube is frame 3, the last of the mission.
    let frames: Vec<u64> =
        told["frames"].as_array().unwrap().iter().map(|frame| frame["frame"].as_u64().unwrap()).collect();
    assert_eq!(frames, [1, 3], "{}", told["later"]);
    let pixels = told["frames"][0]["pixels"].as_array().unwrap();
    assert_eq!(told["frames"][0]["changed"], pixels.len());
    // The same by its place, as text with a picture a frame; the commands behind can be typed.
    let place = format!("{}:{}", cells[2], cells[6]);
    let text = explain(&["--late", &place, "--pictures", "changed"]);
    assert!(text.contains(&format!("frame 1: {} pixels changed", pixels.len())), "{text}");
    assert!(text.contains("\nlunoid explain tiny.toml ") && text.contains("--pixel "), "{text}");
    assert_eq!(scene.list("changed"), ["changed-000001.png", "changed-000003.png"]);
}

#[test]
fn what_was_not_late_and_what_is_no_place_is_refused() {
    let scene = Scene::new();
    let wrong = |machine: &str, more: &[&str]| {
        let line = ["explain", "tiny.toml", "--frame", "1", "--machine", machine];
        scene.expect(2, &[&line, more].concat()).1
    };
    let none = wrong("ideal", &["--late", "3:0"]);
    assert!(
        none.contains("--late 3:0: no word was missing at this crossing")
            && none.contains(", and none of frame 1"),
        "{none}"
    );
    assert!(wrong("ideal", &["--late", "40:0"]).contains("sweeps 0..40"));
    assert!(wrong("ideal", &["--late", "3:0", "--level", "coarse"]).contains("one level"));
    assert!(wrong("ideal", &["--late", "3"]).contains("expected sweep and crossing"));
    assert!(wrong("ideal", &["--late", "3:0", "--pixel", "1,1"]).contains("--pixel"));
    assert!(wrong("ideal", &[]).contains("--late SWEEP:PLACE: expected one of them"));
    assert!(wrong("exact", &["--late", "3:0"]).contains("no words that come late"));
}

#[test]
fn a_timing_that_is_not_met_shows_what_it_changed() {
    let scene = Scene::new();
    let record = on_late(&["timing", "record", "tiny.toml"], &["--frames", "1..3", "--out", "base.json"]);
    scene.expect(0, &record);
    let check = |more: &[&str]| {
        let line = on_late(
            &["timing", "check", "tiny.toml", "--baseline", "base.json", "--pictures", "pictures"],
            more,
        );
        scene.run(&line)
    };
    let met = check(&[]);
    assert_eq!((met.status.code(), scene.list("pictures").len()), (Some(0), 0));
    let slower = check(&["--set", "loader.access_ns=60000"]);
    let text = String::from_utf8_lossy(&slower.stdout).into_owned();
    assert_eq!(slower.status.code(), Some(1), "{text}");
    assert!(text.contains("picture of frame 1: ") && text.contains(" by a grey level or more\n"), "{text}");
    assert_eq!(scene.list("pictures"), ["changed-000001.png", "changed-000002.png"]);
    let wider = check(&["--sweeps", "24"]);
    let said = String::from_utf8_lossy(&wider.stderr).into_owned();
    assert_eq!(wider.status.code(), Some(1));
    assert!(said.contains("warning: --pictures: none: the baseline's pictures have 40 x "), "{said}");
}

#[test]
fn a_delay_without_a_word_and_a_file_of_another_name_are_told() {
    let scene = Scene::new();
    let model = |sweep: u32, crossing: u32| {
        format!(
            "format = 1\nname = \"mine\"\nbase = \"ideal\"\n[[loader.delay]]\nsweep = {sweep}\ncrossing = {crossing}\n\
             colour = \"red\"\nregister = \"x-first\"\nword = [1, 1]\nticks = 10\n"
        )
    };
    scene.write("other.toml", model(3, 900));
    let (_, said) =
        scene.expect(0, &["timing", "show", "tiny.toml", "--machine", "./other.toml", "--frames", "0..2"]);
    assert!(
        said.contains("warning: ./other.toml: the model in it is called `mine`, and its file `other`"),
        "{said}"
    );
    assert!(
        said.contains(
            "warning: loader.delay: word [1, 1] of red x-first at sweep 3, crossing 900: never met"
        ),
        "{said}"
    );
    scene.write("mine.toml", model(5000, 1));
    let (_, said) = scene.expect(0, &["check", "mine.toml"]);
    assert!(said.contains("word [1, 1] is held back in sweep 5000") && !said.contains("is called"), "{said}");
    let (json, _) = scene.expect(0, &["check", "mine.toml", "other.toml", "--json"]);
    let told: Value = serde_json::from_str(&json).unwrap();
    let warnings = |file: usize| told["files"][file]["warnings"].as_array().unwrap().len();
    assert_eq!([warnings(0), warnings(1)], [1, 1]);
}
