//! The inputs of `shared/cases` that are scenarios, shapes, tables and limits, each as the file that it is: what the README
//! beside it calls right. Elevation files are held by `survey`, attacks on folders by [`crate::attacks`].

use std::fs;
use std::path::{Path, PathBuf};

use crate::room::{INPUT, Room};

/// A room with the files of a case; nothing, and a loud line, where the cases are not.
fn room(case: &str) -> Option<Room> {
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let Some(folder) =
        folders.map(|folder| folder.join("shared/cases").join(case)).find(|path| path.is_dir())
    else {
        println!("SKIPPED: shared/cases/{case} is not there");
        return None;
    };
    let room = Room::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path: PathBuf = entry.unwrap().path();
        fs::copy(&path, room.join(path.file_name().unwrap().to_str().unwrap())).unwrap();
    }
    Some(room)
}

/// The first frame of a scenario of a case.
fn frame(room: &Room, scenario: &str, out: &str) -> Vec<u8> {
    let said = room.run(&["replay", scenario, "-q", "--no-page", "--frames", "0..1", "--out", out]);
    assert_eq!(said.code, Some(0), "{said:?}");
    room.read(&format!("{out}/frames/frame-000000.png"))
}

/// The scenario `scene.toml` with another file in it.
fn exchange(room: &Room, old: &str, new: &str) {
    let scene = String::from_utf8(room.read("scene.toml")).unwrap();
    assert_eq!(scene.matches(old).count(), 1, "{old}");
    room.write("other.toml", scene.replace(old, new));
}

#[test]
fn shapes_of_other_programs_are_drawn() {
    for (case, file) in [
        ("16-obj-line-continuation", "continued.obj"),
        ("18-obj-latin1-comment", "latin1.obj"),
        ("19-obj-group-for-each-face", "groups.obj"),
    ] {
        let Some(room) = room(case) else { continue };
        let drawn = frame(&room, "scene.toml", "r");
        exchange(&room, &format!("[[object]]\nid = \"box\"\nfile = \"{file}\"\nx_m = 112\ny_m = 200\n"), "");
        assert_ne!(drawn, frame(&room, "other.toml", "bare"), "{case}: the box is not there");
    }
    let Some(room) = room("16-obj-line-continuation") else { return };
    let drawn = frame(&room, "scene.toml", "r");
    exchange(&room, "continued.obj", "plain.obj");
    assert_eq!(drawn, frame(&room, "other.toml", "plain"));
}

#[test]
fn tables_of_other_programs_are_read() {
    if let Some(room) = room("20-craters-csv-all-quoted") {
        let drawn = frame(&room, "scene.toml", "r");
        exchange(&room, "quoted.csv", "plain.csv");
        assert_eq!(drawn, frame(&room, "other.toml", "plain"));
    }
    let Some(room) = room("22-path-csv-epoch-times") else { return };
    room.run(&["replay", "scene.toml", "-q", "--no-page", "--out", "r"]);
    let poses = String::from_utf8(room.read("r/poses.csv")).unwrap();
    let mut rows = poses.lines();
    let column = rows.next().unwrap().split(',').position(|name| name == "x_m").unwrap();
    let found: Vec<f64> = rows.map(|row| row.split(',').nth(column).unwrap().parse().unwrap()).collect();
    assert_eq!(found.len(), 4, "{poses}");
    for (x, expected) in found.iter().zip([100.0, 101.0, 102.0, 103.0]) {
        assert!((x - expected).abs() < 1e-6, "{poses}");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused_by_the_figure_that_can() {
    if let Some(room) = room("a08-slow-bandwidth") {
        for key in ["amplifier.gain_bandwidth_mhz", "multiplier.bandwidth_mhz"] {
            let set = format!("{key}=1e-9");
            let replay =
                ["replay", "m.toml", "--machine", "pra-nominal", "--frames", "0..1", "--sweeps", "32"];
            let rest = ["--samples", "64", "--out", "r", "--set", &set];
            room.refused(INPUT, &[&replay[..], &rest].concat(), &[key, "MHz"]);
        }
    }
    if let Some(room) = room("a09-infinite-speed") {
        room.refused(INPUT, &["replay", "td.toml", "--out", "r"], &["td.toml", "keyframes", "t_s"]);
    }
    if let Some(room) = room("a05-geotiff-subbyte") {
        for (file, bits) in [("bits4-fmt1.tif", "4"), ("bits1-fmt1.tif", "1")] {
            let said = room.run(&["survey", file, "--region-size-m", "40", "--out", "x.bank"]);
            match said.code {
                Some(0) => {
                    assert!(said.out.contains("20 x 20 samples of the file, 0 without data"), "{said:?}")
                }
                _ => said.is_one_error(INPUT, &[file, "BitsPerSample", bits], file),
            }
        }
    }
}

#[test]
fn many_objects_and_many_faults_are_told_shortly() {
    let head = |room: &Room| String::from_utf8(room.read("tiny.toml")).unwrap();
    if let Some(room) = room("a06-objects-without-limit") {
        let flag = |i: usize| format!("[[object]]\nid=\"o{i}\"\nmodel=\"flag\"\nx_m=200\ny_m=200\n");
        room.write("s.toml", head(&room) + &(0..22_000).map(flag).collect::<String>());
        room.refused(INPUT, &["check", "s.toml"], &["s.toml", "objects", "22000"]);
    }
    let Some(room) = room("a07-many-faults-quadratic") else { return };
    let tables: String = (0..110_000).map(|i| format!("[t{i}]\n")).collect();
    for (text, word) in [(tables, "10000 more faults"), ("[[object]]\n".repeat(50_000), "50000 objects")] {
        room.write("s.toml", head(&room) + &text);
        let said = room.run(&["check", "s.toml"]);
        assert_eq!(said.code, Some(INPUT));
        assert!(said.err.contains("s.toml") && said.err.contains(word), "{} bytes", said.err.len());
    }
}

#[test]
fn what_a_file_says_never_reaches_the_terminal_raw() {
    let Some(room) = room("a11-escapes") else { return };
    for file in ["meta-esc.tif", "esc.lbl", "esc2.lbl"] {
        let bank = format!("{file}.bank");
        let survey =
            room.run(&["survey", file, "--spacing-m", "10", "--region-size-m", "40", "--out", &bank]);
        let survey = match survey.code {
            // A file with a place of its own takes no spacing.
            Some(0) => survey,
            _ => room.run(&["survey", file, "--region-size-m", "40", "--out", &bank]),
        };
        let show = room.run(&["bank", "show", &bank]);
        for said in [survey, show] {
            assert!(!said.out.contains('\u{1b}') && !said.err.contains('\u{1b}'), "{file}: {said:?}");
        }
    }
}
