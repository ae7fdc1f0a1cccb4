//! Effect files: the library that ships, and bad input of every kind.

use std::path::{Path, PathBuf};

use faces::{Effect, Group, Setting};
use quantities::{Rate, unit_interval};

const SIGNALS: [&str; 4] = ["pitch", "speed", "thrust", "wheel-speed"];

fn setting() -> Setting<'static> {
    Setting { frames: Rate::new(30, 1).expect("a frame rate"), signals: &SIGNALS, most: 200_000 }
}

fn library() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../scenarios/effects");
    let entries = std::fs::read_dir(folder).expect("the library").map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> = entries.filter(|path| path.extension().is_some()).collect();
    files.sort();
    files
}

fn effect(name: &str) -> Effect {
    let files = library();
    let path = files.iter().find(|path| path.file_stem().is_some_and(|stem| stem == name));
    Effect::read(path.expect("a file of the library"), setting()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_library_is_read_without_a_word_of_warning() {
    let files = library();
    assert!(files.len() >= 8, "{files:?}");
    for path in files {
        let read = Effect::read(&path, setting()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(read.warnings, [], "{}", path.display());
        assert!(!read.groups.is_empty() && !read.title.is_empty() && !read.about.is_empty());
        for group in &read.groups {
            assert!(!group.mesh.faces().is_empty(), "{}", path.display());
            assert_eq!(group.normals.knife_edges(), 0, "{}", path.display());
        }
    }
}

/// Frames of one round in which a list shows other faces than in the frame before.
fn changes(group: &Group, frames: u64) -> usize {
    (1..=frames).filter(|&frame| group.shown(frame, |_| 0.0) != group.shown(frame - 1, |_| 0.0)).count()
}

#[test]
fn what_the_library_shows_from_frame_to_frame() {
    let counts = |name: &str| {
        let group = &effect(name).groups[0];
        (group.mesh.faces().len(), group.shown(0, |_| 0.0).len())
    };
    assert_eq!(counts("smoke"), (24, 2));
    assert_eq!(counts("fire"), (24, 3));
    assert_eq!(counts("rotor-disc"), (24, 4));
    assert_eq!(counts("rain"), (72, 12));
    assert_eq!(counts("white-caps"), (16, 4));
    assert_eq!(counts("wand-signals"), (10, 2));
    assert_eq!(counts("dust-ring").0, counts("dust-ring").1);
    assert_eq!(counts("turning-dish"), (144, 12));
    assert_eq!(counts("opening-panel"), (10, 1));
    assert_eq!(changes(&effect("rain").groups[0], 6), 6);
    assert_eq!(changes(&effect("smoke").groups[0], 48), 12);
    // Four sequences of ten frames a member start 0, 7, 14 and 21 frames early: one of them changes at a time.
    let caps = &effect("white-caps").groups[0];
    assert_eq!(changes(caps, 40), 16);
}

#[test]
fn flames_shine_of_themselves_from_both_sides() {
    let fire = &effect("fire").groups[0];
    for behind in [false, true] {
        assert_eq!(fire.brightness(5, -glam::DVec3::Z, behind), [1.0; 3]);
    }
}

#[test]
fn a_panel_opens_once_and_a_beacon_flashes_by_its_sun() {
    let panel = &effect("opening-panel").groups[0];
    assert_eq!((panel.shown(0, |_| 0.0), panel.shown(10_000, |_| 0.0)), (vec![0], vec![9]));
    let beacon = &effect("beacon").groups[0];
    let light = |frame| beacon.corner_brightness(0, 0, beacon.sun.vector(frame, glam::DVec3::Z), false);
    let film: Vec<f64> = (0..30).map(light).collect();
    assert!(film.iter().any(|&light| light > 0.7) && film.contains(&0.0), "{film:?}");
    assert_eq!(light(30).to_bits(), light(0).to_bits());
}

#[test]
fn a_signal_drives_a_sequence() {
    let driven = "mode = \"driven\"\nsignal = \"thrust\"\nlow = 0\nstep = 0.5";
    let read = parse(&GOOD.replacen("frames = 3", driven, 1)).expect("an effect");
    let shown =
        |thrust: f64| read.groups[0].shown(9, |name| if name == "thrust" { thrust } else { f64::NAN });
    assert_eq!((shown(0.0), shown(0.5), shown(7.0), shown(-7.0)), (vec![0], vec![1], vec![1], vec![0]));
    assert_eq!(changes(&effect("weapon-flash").groups[0], 6), 6);
}

#[test]
fn patterns_of_the_library_move_outwards_and_hold_their_mean() {
    let grain = &effect("grain-field").groups[0];
    let faces = grain.mesh.faces().len();
    let sun = grain.sun.vector(0, glam::DVec3::Z);
    let light: Vec<f64> = (0..faces).flat_map(|face| grain.brightness(face, sun, false)).collect();
    let mean = light.iter().sum::<f64>() / light.len() as f64;
    assert!((mean - 0.6).abs() < 0.01, "{mean}");
    let dust = &effect("dust-ring").groups[0];
    assert_eq!((dust.gain, dust.detail), (0.5, faces::Detail::Add));
}

const GOOD: &str = r#"format = 1
title = "Beacon"
about = "A lamp that turns"

[[group]]
name = "lamp"
priority = 4
vertices = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0]]
normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1], [0, 0, 2]]
sun = { elevation_deg = 40, turns = 1, seconds = 2 }

[[group.face]]
corners = [0, 1, 2]
colour = [1, 0.8, 0.2]

[[group.face]]
corners = [1, 3, 2]
colour = [1, 0.8, 0.2]
shading = "flat"
sides = "both"

[[group.sequence]]
members = 2
frames = 3

[[group]]
name = "sea"
priority = 9
sun = { elevation_deg = 40, turns = 1, seconds = 5 }

[group.pattern]
rule = "two-sine"
length_m = 40
second_length_m = 25
side_m = 10
rows = [-2, 2]
columns = [0, 3]
colour = [0, 0.1, 0.2]
"#;

fn parse(text: &str) -> Result<Effect, String> {
    Effect::parse("e.toml", text.as_bytes(), setting()).map_err(|error| error.to_string())
}

#[test]
fn a_whole_file() {
    let read = parse(GOOD).expect("an effect");
    assert_eq!((read.title.as_str(), read.about.as_str()), ("Beacon", "A lamp that turns"));
    let [lamp, sea] = &read.groups[..] else { panic!("two lists") };
    assert_eq!((lamp.name.as_str(), lamp.priority, sea.mesh.faces().len()), ("lamp", 4, 12));
    assert_eq!((lamp.shown(2, |_| 0.0), lamp.shown(3, |_| 0.0)), (vec![0], vec![1]));
    let half = 0.5_f64.sqrt();
    assert!(lamp.normals.of_face(0)[1].distance(glam::DVec3::new(0.0, half, half)) < 1e-15);
    assert_eq!(lamp.normals.of_face(1)[0], glam::DVec3::Z);
    assert!(lamp.sun.vector(15, glam::DVec3::Z).x.abs() < 1e-15);
}

/// The error of the good file with one piece of text put in place of another.
#[track_caller]
fn refused(from: &str, to: &str, expected: &[&str]) {
    assert!(GOOD.contains(from), "{from}");
    let Err(found) = parse(&GOOD.replacen(from, to, 1)) else { panic!("`{to}` is not refused") };
    for words in expected {
        assert!(found.contains(words), "no `{words}` in:\n{found}");
    }
}

#[test]
fn bad_files_are_refused_with_place() {
    refused("format = 1", "format = 2", &["newer than", "e.toml:1:10"]);
    refused("title = \"Beacon\"", "", &["missing key `title`"]);
    refused(
        "priority = 4",
        "priority = 4\nprioritty = 5",
        &["unknown key", "e.toml:8:1", "did you mean `priority`?"],
    );
    refused("priority = 9", "priority = 4", &["lists `lamp` and `sea` both have priority 4"]);
    refused("[1, 1, 0]]", "[1, nan, 0]]", &["e.toml:8"]);
    refused("[0, 0, 2]]", "[0, 0, 0]]", &["vertex 3: the normal has no direction"]);
    refused(", [0, 0, 2]]", "]", &["3 normals for 4 vertices", "e.toml:9:11"]);
    refused("corners = [1, 3, 2]", "corners = [1, 4, 2]", &["face 1: there is no vertex 4", "e.toml:16"]);
    refused("corners = [1, 3, 2]", "corners = [1, 3]", &["face 1: 2 corners: expected 3 or more"]);
    refused("[1, 0.8, 0.2]", "[1, 1.8, 0.2]", &["`group[0].face[0].colour`", "e.toml:14"]);
    refused("shading = \"flat\"", "shading = \"flatt\"", &["did you mean \"flat\"?"]);
    refused(
        "turns = 1, seconds = 2",
        "turns = 16",
        &["it would seem to turn backwards", "15 Hz or less", "e.toml:10"],
    );
    refused("elevation_deg = 40", "elevation_deg = 95", &["e.toml:10"]);
}

#[test]
fn bad_sequences_are_refused() {
    refused("members = 2", "members = 3", &["member 2 of a sequence of 3 is missing"]);
    refused("members = 2", "members = 99999999", &["member 2 of a sequence of 99999999 is missing"]);
    refused("members = 2", "first = 9\nmembers = 2", &["member 0 of a sequence of 2 is missing"]);
    refused("members = 2", "members = 0", &["e.toml:23"]);
    refused("frames = 3", "frames = 0", &["e.toml:24"]);
    refused("frames = 3", "", &["missing key `group[0].sequence[0].frames`"]);
    refused(
        "frames = 3",
        "frames = 1\n[[group.sequence]]\nfirst = 1\nmembers = 1\nframes = 1",
        &["face 1 stands in more than one place"],
    );
    let driven = "mode = \"driven\"\nsignal = \"thrsut\"\nlow = 0\nstep = 0.5";
    refused("frames = 3", driven, &["there is no signal `thrsut`", "did you mean `thrust`?", "e.toml:25:10"]);
    refused("frames = 3", &driven.replace("thrsut", "thrust").replace("0.5", "0"), &["not 0"]);
    refused("frames = 3", &format!("frames = 3\n{}", driven.replace("thrsut", "thrust")), &["unknown key"]);
    let moded =
        parse(&GOOD.replacen("frames = 3", "frames = 3\nmode = \"sometimes\"", 1)).expect_err("no such mode");
    assert!(moded.contains("\"ping-pong\"") && !moded.contains("unknown key"), "{moded}");
}

#[test]
fn bad_patterns_are_refused() {
    refused("length_m = 40", "length_m = 0", &["`group[1].pattern.length_m`"]);
    refused("rule = \"two-sine\"", "rule = \"swell\"", &["unknown key `group[1].pattern.second_length_m`"]);
    refused("side_m = 10", "side_m = -1", &["side_m"]);
    refused("rows = [-2, 2]", "rows = [2, 2]", &["whole, the second above the first"]);
    refused("rows = [-2, 2]", "rows = [-2, 2.5]", &["whole, the second above the first"]);
    refused("rows = [-2, 2]", "rows = [-200000, 200000]", &["has 1200000 faces"]);
    refused("side_m = 10", "side_m = 10\nring_m = [5, 5]", &["ring_m", "the second above the first"]);
    refused("side_m = 10", "side_m = 10\nnormals = 1", &["of at least 2"]);
    refused("side_m = 10", "side_m = 10\nalpha_deg = 91", &["alpha_deg"]);
    refused("side_m = 10", "side_m = 10\nalpha_deg = 0", &["alpha_deg"]);
    refused("side_m = 10", "side_m = 10\nhold_mean = 1", &["crest of the held pattern"]);
    refused("[group.pattern]", "vertices = [[0, 0, 0]]\n[group.pattern]", &["`vertices` beside a pattern"]);
    let own = "sun = { elevation_deg = 40, turns = 1, seconds = 5 }";
    let held = GOOD.replacen(own, "", 1).replacen("side_m = 10", "side_m = 10\nhold_mean = 0.5", 1);
    assert!(parse(&held).expect_err("no sun of its own").contains("under the scenario's sun"));
}

#[test]
fn faces_are_limited_and_files_are_named() {
    let few = Setting { most: 11, ..setting() };
    let found = Effect::parse("e.toml", GOOD.as_bytes(), few).expect_err("too many faces").to_string();
    assert!(found.contains("list `sea` has 12 faces: expected 11 or fewer"), "{found}");
    let missing = Effect::read(Path::new("no-such-effect.toml"), setting()).expect_err("no file").to_string();
    assert!(missing.contains("no-such-effect.toml"), "{missing}");
    assert!(
        parse("format = 1\ntitle = \"a\"\nabout = \"b\"\n").expect_err("no list").contains("without a list")
    );
    let empty =
        "format = 1\ntitle = \"a\"\nabout = \"b\"\n[[group]]\nname = \"n\"\npriority = 1\nvertices = []\n";
    assert!(parse(empty).expect_err("no faces").contains("a list without faces"));
    assert!(parse("title = ").is_err());
    assert!(Effect::parse("e.toml", b"\xff", setting()).is_err());
}

/// Bytes of the good file with some of them changed, cut out or doubled.
fn damaged(seed: u64) -> Vec<u8> {
    let mut bytes = GOOD.as_bytes().to_vec();
    for round in 0..1 + seed % 4 {
        let pick = |word: u64, below: usize| (unit_interval(seed, &[round, word]) * below as f64) as usize;
        let at = pick(0, bytes.len());
        match pick(1, 4) {
            0 => bytes[at] = b"0123456789-.[]{}\"=,\n#ae \xff"[pick(2, 25)],
            1 => drop(bytes.drain(at..(at + pick(2, 40)).min(bytes.len()))),
            2 => drop(bytes.splice(at..at, *b"99999999999")),
            _ => {
                let piece = bytes[at..(at + pick(2, 60)).min(bytes.len())].to_vec();
                drop(bytes.splice(at..at, piece));
            }
        }
    }
    bytes
}

#[test]
fn damaged_files_are_read_or_refused_and_never_panic() {
    let few = Setting { most: 10_000, ..setting() };
    let read = |seed: &u64| Effect::parse("e.toml", &damaged(*seed), few).is_ok();
    let good = (0..4000).filter(read).count();
    assert!(good > 20 && good < 3000, "{good} of 4000 were read");
}

#[test]
fn warnings_name_faces_that_are_left_out() {
    let read = parse(&GOOD.replacen("corners = [1, 3, 2]", "corners = [1, 3, 1]", 1)).expect("an effect");
    let told: Vec<String> = read.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(told, ["list `lamp`, face 1: two corners at one place; the face is left out"]);
    // The turn of the face that was left out shows nothing.
    assert!(read.groups[0].shown(3, |_| 0.0).is_empty());
}
