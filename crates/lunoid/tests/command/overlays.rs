//! `lunoid check` on files of differences.

use std::fs;

use crate::scene::Scene;

fn faults() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../hardware-models/faults");
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
