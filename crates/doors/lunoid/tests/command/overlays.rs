//! `lunoid check` on files of differences.

use std::fs;

use crate::scene::Scene;

fn faults() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../hardware-models/faults");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path().display().to_string());
    let mut files: Vec<String> = files.collect();
    files.sort();
    files
}

#[test]
fn every_shipped_fault_is_checked_as_an_overlay() {
    let files = faults();
    assert!(files.len() > 20);
    let arguments: Vec<&str> = ["check"].into_iter().chain(files.iter().map(String::as_str)).collect();
    let (out, err) = Scene::new().expect(0, &arguments);
    assert_eq!(out.matches(": overlay over ideal, no fault\n").count(), files.len(), "{out}{err}");
}

#[test]
fn what_is_wrong_in_an_overlay_is_told_and_nothing_else() {
    let scene = Scene::new();
    scene.write("slow.toml", "format = 1\n[multiplier]\nbandwidth_mhz = -1\n[comparator]\ndelay = 40\n");
    let (out, err) = scene.expect(3, &["check", "slow.toml"]);
    assert!(out.is_empty() && err.contains("bandwidth_mhz") && err.contains("delay"), "{err}");
    assert!(!err.contains("missing") && err.matches("slow.toml:").count() == 2, "{err}");
    let (out, _) = scene.expect(3, &["check", "slow.toml", "--json"]);
    assert!(out.contains("\"kind\": \"overlay over ideal\""), "{out}");
}

/// A name or a base makes it a model again, and what a model lacks is missing.
#[test]
fn a_model_is_still_a_model() {
    let scene = Scene::new();
    scene.write("whole.toml", "format = 1\nname = 'mine'\n[multiplier]\nerror_pct = 1\n");
    let (_, err) = scene.expect(3, &["check", "whole.toml"]);
    assert!(err.contains("missing"), "{err}");
    scene.write("based.toml", "format = 1\nname = 'mine'\nbase = 'ideal'\n[multiplier]\nerror_pct = 1\n");
    let (out, _) = scene.expect(0, &["check", "based.toml"]);
    assert_eq!(out, "based.toml: hardware-model, no fault\n");
}

#[test]
fn an_overlay_that_is_not_there_is_told_what_is_like_it() {
    let scene = Scene::new();
    for name in ["taer", "hardware-models/faults/taer.toml"] {
        let (_, err) = scene.expect(3, &["replay", "tiny.toml", "--overlay", name]);
        assert!(err.contains(&format!("{name}: no such file")), "{err}");
        assert!(err.contains("did you mean `tear`? known: blur, "), "{err}");
    }
}

/// Every kind of TOML file that the project ships is known, and what is none of them is not taken for one.
#[test]
fn every_kind_of_file_is_checked_as_what_it_is() {
    let scene = Scene::new();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    for (file, kind) in [
        ("hardware-models/programs/lunsim.toml", "hardware of lunsim"),
        ("tests/cartridges/flat-plane/cartridge.toml", "cartridge"),
        ("hardware-models/ideal.toml", "hardware-model"),
        ("scenarios/first-light.toml", "scenario"),
    ] {
        let (out, _) = scene.expect(0, &["check", &format!("{root}/{file}")]);
        assert!(out.ends_with(&format!("{file}: {kind}, no fault\n")), "{out}");
    }
    scene.write("gear.toml", "[computer]\nadd_us = -1\n[recorder]\npoints_s = 10000\n");
    let (_, err) = scene.expect(3, &["check", "gear.toml"]);
    assert!(err.contains("`computer.add_us`") && err.contains("missing key"), "{err}");
    scene.write("cartridge.toml", "format = 2\ntitle = \"None\"\n[scene]\nkind = \"none\"\n");
    let (_, err) = scene.expect(3, &["check", "cartridge.toml"]);
    assert!(err.contains("--> cartridge.toml") && err.matches("error").count() == 1, "{err}");
    scene.write("other.toml", "max_width = 110\n");
    let (_, err) = scene.expect(3, &["check", "other.toml"]);
    assert!(err.contains("no key of any kind") && err.contains("a scenario (title, "), "{err}");
    assert!(err.matches("error").count() == 1, "{err}");
    let (_, err) = scene.expect(3, &["info", "other.toml"]);
    assert!(err.contains("a file of no known kind; expected a scenario"), "{err}");
}
