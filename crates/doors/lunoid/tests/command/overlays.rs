//! `lunoid check` on files of differences.

use std::fs;

use crate::scene::Scene;

const FAULTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../hardware-models/faults");

/// The overlays of a folder.
fn faults(folder: &str) -> Vec<String> {
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<String> =
        paths.filter(|path| path.is_file()).map(|path| path.display().to_string()).collect();
    files.sort();
    files
}

#[test]
fn every_shipped_fault_is_checked_as_an_overlay() {
    for (folder, kind, least) in
        [("", "ideal", 25), ("/sampled", "sampled", 7), ("/smooth-faces", "smooth-faces", 9)]
    {
        let files = faults(&format!("{FAULTS}{folder}"));
        assert!(files.len() >= least);
        let arguments: Vec<&str> = ["check"].into_iter().chain(files.iter().map(String::as_str)).collect();
        let (out, err) = Scene::new().expect(0, &arguments);
        let told = format!(": overlay over {kind}, no fault\n");
        assert_eq!(out.matches(&told).count(), files.len(), "{out}{err}");
    }
}

/// By name and by path, over the scenario and under `--set`; another machine has no such parameters.
#[test]
fn an_overlay_goes_over_the_generator_that_has_its_tables() {
    let scene = Scene::new();
    let keys = |more: &[&str]| {
        let record =
            ["timing", "record", "tiny.toml", "--machine", "sampled", "--frames", "0..1", "--out", "a"];
        scene.expect(0, &[&record[..], more].concat());
        let record: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(scene.join("a")).unwrap()).unwrap();
        (record["keys"]["asked.sampler.sampler_hz"].clone(), record["master"].clone())
    };
    let file = format!("{FAULTS}/sampled/slow-sampler.toml");
    for name in ["slow-sampler", &file] {
        assert_eq!(keys(&["--overlay", name]).1, "10000000 Hz");
    }
    let set = ["--overlay", "slow-sampler", "--set", "sampler.sampler_hz=20e6"];
    assert_eq!(keys(&set), ("20e6".into(), "20000000 Hz".into()));
    for machine in ["ideal", "lunsim"] {
        let command = ["timing", "show", "tiny.toml", "--machine", machine, "--overlay", "slow-sampler"];
        let (_, err) = scene.expect(2, &command);
        assert!(err.contains("these are differences of sampled") && err.contains(machine), "{err}");
    }
    scene.write("wrong.toml", "format = 1\n[sampled]\ntwinkle = true\n[loader]\naccess_ns = 90\n");
    let (_, err) =
        scene.expect(3, &["replay", "tiny.toml", "--machine", "sampled", "--overlay", "wrong.toml"]);
    assert!(err.contains("`sampled.twinkle`") || err.contains("twinkle"), "{err}");
    assert!(err.contains("loader"), "{err}");
}

/// Parts of the hybrid machine are none of a generator's; raster and range are.
#[test]
fn an_overlay_of_parts_is_refused_where_a_generator_draws() {
    let scene = Scene::new();
    let replay = |code: i32, overlay: &str| {
        let words = ["replay", "tiny.toml", "--machine", "smooth-faces", "--frames", "0..1", "--out", "over"];
        scene.expect(code, &[&words[..], &["--overlay", overlay]].concat()).1
    };
    scene.write("parts.toml", "format = 1\n[raster]\nsweeps = 40\n[loader]\naccess_ns = 90\n");
    for (overlay, told) in
        [("tear", "built-in faults/tear.toml:"), ("parts.toml", "parts.toml:5 sets `loader.access_ns`")]
    {
        let err = replay(2, overlay);
        assert!(err.contains(&format!("--overlay {overlay}: ")) && err.contains(told), "{err}");
        assert!(err.contains("smooth-faces has no such part"), "{err}");
    }
    scene.write("view.toml", "format = 1\n[raster]\nsweeps = 40\n");
    replay(0, "view.toml");
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
        assert!(err.contains("did you mean `tear`? known: band, "), "{err}");
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
        assert!(out.contains(&format!("{file}: {kind}, no fault")), "{out}");
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
