//! Waveforms of a scenario, from the command line into files.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

const TINY: &str = include_str!("../tiny.toml");
const SIGNALS: &str = "sweep.*,tg.height,tg.red.hold,dpp.y,dpp.blank,sm.write";

/// A folder with the tiny scenario.
fn room() -> TempDir {
    let room = tempfile::tempdir().unwrap();
    fs::write(room.path().join("tiny.toml"), TINY).unwrap();
    room
}

fn run(room: &TempDir, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lunoid"));
    command.current_dir(room.path()).args(arguments).output().unwrap()
}

/// Standard output and error of a command that must end with `code`.
fn said(room: &TempDir, code: i32, arguments: &[&str]) -> (String, String) {
    let output = run(room, arguments);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {}", text(&output.stderr));
    (text(&output.stdout), text(&output.stderr))
}

fn probe<'a>(sweep: &'a str, out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let base = ["probe", "tiny.toml", "--frame", "1", "--sweep", sweep, "--signals", SIGNALS, "--out", out];
    [&base[..], more].concat()
}

fn list(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// The size is said before, and is right within a quarter.
#[test]
fn every_format_and_its_size() {
    let room = room();
    for format in ["csv", "vcd", "fst", "npz", "json", "raw", "sr"] {
        let out = format!("w.{format}");
        let (text, err) = said(&room, 0, &probe("all", &out, &["--json"]));
        assert!(err.contains(&format!("{out}: about ")), "{err}");
        let document: Value = serde_json::from_str(&text).unwrap();
        assert_eq!((&document["schema"], &document["format"]), (&"lunoid.probe/1".into(), &format.into()));
        assert_eq!(document["sweeps"], serde_json::json!([0, 40]));
        assert_eq!(document["files"][0], out.as_str());
        let said = document["estimated_bytes"].as_f64().unwrap();
        let real = fs::metadata(room.path().join(&out)).unwrap().len() as f64;
        assert!((0.75..1.25).contains(&(said / real)), "{format}: {said} said, {real} written");
    }
    let names = list(room.path());
    assert!(names.contains(&"w.fst.json".into()) && names.contains(&"w.fst.gtkw".into()), "{names:?}");
    assert!(names.iter().all(|name| !name.ends_with(".tmp")), "{names:?}");
}

/// A column of a CSV, by the beginning of its heading.
fn column(csv: &str, name: &str) -> Vec<f64> {
    let mut lines = csv.lines();
    let place = lines.next().unwrap().split(',').position(|head| head.starts_with(name)).unwrap();
    lines.map(|line| line.split(',').nth(place).unwrap().parse().unwrap()).collect()
}

/// Each sweep of a frame is that sweep by itself, to the bit.
#[test]
fn a_frame_is_its_sweeps() {
    let room = room();
    said(&room, 0, &probe("all", "all.csv", &[]));
    let all = fs::read_to_string(room.path().join("all.csv")).unwrap();
    assert_eq!(all.lines().count(), 1 + 40 * 80);
    for sweep in [0, 7, 8, 39] {
        said(&room, 0, &probe(&sweep.to_string(), "one.csv", &[]));
        let one = fs::read_to_string(room.path().join("one.csv")).unwrap();
        let rows: Vec<&str> = all.lines().skip(1 + sweep * 80).take(80).collect();
        assert_eq!(one.lines().skip(1).collect::<Vec<_>>(), rows);
    }
    let times = column(&all, "time [s]");
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
}

#[test]
fn nothing_is_written_that_is_not_wanted() {
    let room = room();
    let (out, err) = said(&room, 0, &probe("all", "w.npz", &["--dry-run"]));
    assert!(out.contains("not written") && err.contains("w.npz: about "), "{out}{err}");
    said(&room, 2, &probe("all", "w.txt", &[]));
    said(&room, 2, &probe("all", "w.png", &[]));
    said(&room, 2, &probe("3", "w.txt", &["--format", "png"]));
    said(&room, 2, &probe("3", "w.csv", &["--format", "zip"]));
    said(&room, 4, &probe("3", "gone/w.csv", &[]));
    assert_eq!(list(room.path()), ["tiny.toml"]);
}

/// 2 GB and more are written only if that is said.
#[test]
fn a_large_file_needs_a_word() {
    let room = room();
    let large = ["--sweeps", "8192", "--samples", "5000", "--signals", "tg.*,sweep.*,mu.*,dpp.*"];
    let base = ["probe", "tiny.toml", "--frame", "1", "--sweep", "all", "--out", "w.npz"];
    let (_, err) = said(&room, 2, &[&base[..], &large].concat());
    assert!(err.contains("GB; give --large"), "{err}");
    assert_eq!(list(room.path()), ["tiny.toml"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_and_a_device() {
    let room = room();
    for format in ["csv", "vcd", "fst", "npz", "json", "raw", "sr"] {
        let (_, err) = said(&room, 4, &probe("3", "/dev/full", &["--format", format]));
        assert!(err.contains("/dev/full: cannot write: no space left"), "{format}: {err}");
    }
    let (out, _) = said(&room, 0, &probe("3", "/dev/stdout", &["--format", "csv"]));
    assert!(out.starts_with("frame,sweep,index,time [s],sweep.accumulator.x [d],"), "{out}");
    assert_eq!(list(room.path()), ["tiny.toml"]);
}

/// A name means the signal, there or not; a star means what is there.
#[test]
fn wires_that_the_machine_does_not_have() {
    let room = room();
    let base = ["probe", "tiny.toml", "--frame", "1", "--sweep", "3", "--out", "w.csv", "--signals"];
    let (_, err) = said(&room, 0, &[&base[..], &["tg.height,fg.present"]].concat());
    assert!(err.contains("fg.present: this machine has no such wire"), "{err}");
    let csv = fs::read_to_string(room.path().join("w.csv")).unwrap();
    assert!(column(&csv, "fg.present").iter().all(|value| *value == 0.0));
    said(&room, 0, &[&base[..], &["*"]].concat());
    let csv = fs::read_to_string(room.path().join("w.csv")).unwrap();
    assert!(!csv.lines().next().unwrap().contains("fg."));
}

#[test]
fn signals_of_the_table_and_of_a_machine() {
    let room = room();
    let (out, _) = said(&room, 0, &["signals", "tg.height", "--json"]);
    let document: Value = serde_json::from_str(&out).unwrap();
    let signal = &document["signals"][0];
    assert_eq!((&signal["kind"], &signal["block"]), (&"analog".into(), &"terrain-generator".into()));
    assert!(signal["full_scale"].is_null() && document["scenario"].is_null());
    let (out, _) = said(&room, 0, &["signals", "tiny.toml", "--json"]);
    let document: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&document["scenario"], &document["machine"]), (&"tiny.toml".into(), &"ideal".into()));
    let signals = document["signals"].as_array().unwrap();
    let named = |name: &str| signals.iter().find(|signal| signal["name"] == name);
    assert!(named("tg.height").unwrap()["full_scale"].as_f64().unwrap() > 0.0);
    assert!(named("fg.height").is_none());
    assert!(document["left_out"].as_array().unwrap().contains(&"fg.height".into()));
    assert!(named("sweep.accumulator.x").is_some() && named("tg.product.34").is_some());
    let (out, _) = said(&room, 0, &["signals", "tiny.toml", "--everything", "tg.height", "fg.*"]);
    assert!(out.starts_with("name") && out.contains("full scale") && out.contains("fg.present"), "{out}");
    let (out, _) = said(&room, 0, &["signals", "tiny.toml"]);
    let line = |start: &str| out.lines().find(|line| line.starts_with(start)).unwrap_or_default().to_owned();
    assert!(
        line("tg.product.00").contains("tg.product.55") && line("tg.product.00").contains(" 36 "),
        "{out}"
    );
    assert!(line("not there").contains("fg.*"), "{out}");
    let blocks: Vec<&str> = out.lines().filter(|line| line.ends_with(':')).collect();
    assert_eq!(blocks[..3], ["sweep-generator:", "dpu:", "terrain-generator:"], "{out}");
    let (_, err) = said(&room, 2, &["signals", "zz.*"]);
    assert!(err.contains("zz.*: no signal of this name"), "{err}");
    said(&room, 3, &["signals", "gone.toml"]);
    said(&room, 2, &["signals", "--machine", "ideal"]);
    said(&room, 2, &["signals", "tiny.toml", "--machine", "exact"]);
}
