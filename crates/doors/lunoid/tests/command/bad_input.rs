//! One clear error each, non-zero exit, nothing half-written.

use std::fs;

use crate::scene::Scene;

#[test]
fn scenarios_that_cannot_be() {
    let scene = Scene::new();
    scene.vary("typo.toml", "elevation_deg = 15", "elevaton_deg = 15");
    scene.vary("nan.toml", "azimuth_deg = 100", "azimuth_deg = nan");
    scene.vary("zero.toml", "sweeps = 40", "sweeps = 0");
    scene.vary("machine.toml", "frames = 4", "frames = 4\nmachine = \"idael\"");
    scene.vary("away.toml", "x_m = 108", "x_m = 9000");
    scene.vary(
        "under.toml",
        "keyframes = [\n  { t_s = 0, x_m = 100, y_m = 200 },\n  { t_s = 5, x_m = 108, y_m = 205 },\n]",
        "file = \"under.csv\"",
    );
    scene.write(
        "under.csv",
        "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n0,100,200,-500,0,0,0\n9,108,205,-500,0,0,0\n",
    );
    scene.vary(
        "gone.toml",
        "[landscape.generated]",
        "[landscape]\nbank = \"gone.bank\"\n[landscape.generated]",
    );
    scene.write("bytes.toml", [0xff, 0xfe, 0x00]);
    fs::create_dir(scene.join("folder.toml")).unwrap();
    for (file, words) in [
        ("typo.toml", &["typo.toml:19", "elevaton_deg", "did you mean `elevation_deg`"][..]),
        ("nan.toml", &["nan.toml:18", "azimuth_deg", "nan"]),
        ("zero.toml", &["zero.toml", "sweeps", "from 1 to 8192"]),
        ("machine.toml", &["--> machine.toml", "unknown machine `idael`", "did you mean `ideal`"]),
        ("away.toml", &["outside the problem area"]),
        ("under.toml", &["eye under ground"]),
        ("gone.toml", &["gone.toml"]),
        ("bytes.toml", &["bytes.toml", "UTF-8"]),
        ("folder.toml", &["folder.toml", "folder"]),
        ("missing.toml", &["missing.toml", "no such file"]),
    ] {
        let (out, err) = scene.expect(3, &["replay", file]);
        assert!(out.is_empty() && err.starts_with("error: "), "{file}: {err}");
        assert!(words.iter().all(|word| err.contains(word)), "{file}: {err}");
        assert!(!scene.join("runs").exists(), "{file}");
        scene.expect(3, &["check", file]);
    }
}

#[test]
fn check_lists_every_fault_of_every_file() {
    let scene = Scene::new();
    scene.vary(
        "two.toml",
        "azimuth_deg = 100\nelevation_deg = 15",
        "azimuth_deg = 1000\nelevation_deg = -15",
    );
    scene.write("model.toml", "format = 1\nname = \"mine\"\nbase = \"ideal\"\n[raster]\nsweps = 500\n");
    let (out, err) = scene.expect(3, &["check", "tiny.toml", "two.toml", "model.toml"]);
    assert_eq!(out, "tiny.toml: scenario, no fault; drawn whole: each edge at its own instant\n");
    assert_eq!(err.matches("error: ").count(), 3, "{err}");
    let (out, _) = scene.expect(3, &["check", "tiny.toml", "two.toml", "model.toml", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    let counts: Vec<usize> =
        (0..3).map(|n| document["files"][n]["problems"].as_array().unwrap().len()).collect();
    assert_eq!(counts, [0, 2, 1]);
    assert_eq!(document["files"][2]["kind"], "hardware-model");
    assert_eq!(document["files"][1]["problems"][0]["line"], 18);
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "a.bank"]);
    let (out, _) = scene.expect(0, &["check", "a.bank.toml"]);
    assert_eq!(out, "a.bank.toml: description of a bank, no fault\n");
}

#[test]
fn machines_that_cannot_be() {
    let scene = Scene::new();
    for (arguments, words) in [
        (&["--machine", "pra-nominla"][..], "unknown machine `pra-nominla`"),
        (&["--machine", "lunsin"], "did you mean `lunsim`"),
        (&["--machine", "zzz"], "--> --machine"),
        (&["--machine", "./gone.toml"], "gone.toml"),
        (&["--overlay", "gone.toml"], "gone.toml"),
        (&["--set", "raster.sweps=1"], "sweps"),
        (&["--set", "dpp.projection=\"exakt\""], "exakt"),
    ] {
        let (_, err) = scene.expect(3, &[&["replay", "tiny.toml"], arguments].concat());
        assert!(err.contains(words), "{arguments:?}: {err}");
    }
    assert_eq!(scene.list("."), ["tiny.toml"]);
}

#[test]
fn damaged_banks() {
    let scene = Scene::new();
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "a.bank"]);
    let whole = fs::read(scene.join("a.bank")).unwrap();
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 1;
    scene.write("short.bank", &whole[..whole.len() / 2]);
    scene.write("flipped.bank", flipped);
    scene.write("empty.bank", "");
    for name in ["short", "flipped", "empty", "gone"] {
        let file = format!("{name}.bank");
        let (_, err) = scene.expect(3, &["replay", "tiny.toml", "--bank", &file]);
        assert!(err.starts_with("error: ") && err.contains(&file), "{err}");
        scene.expect(3, &["bank", "show", &file]);
    }
    assert!(!scene.join("runs").exists());
}

#[test]
fn outputs_that_cannot_be_written() {
    let scene = Scene::new();
    scene.write("file", "mine");
    let code = |arguments: &[&str]| scene.expect(4, arguments).1;
    assert!(code(&["replay", "tiny.toml", "--out", "file"]).contains("expected a folder"));
    assert!(code(&["replay", "tiny.toml", "--out", "file/below"]).contains("file/below"));
    assert!(code(&["replay", "tiny.toml", "--y4m", "gone/film.y4m"]).contains("gone/film.y4m"));
    assert!(code(&["bank", "generate", "tiny.toml", "-o", "gone/a.bank"]).contains("gone/a.bank"));
    assert!(code(&["compare", "a.png", "b.png", "--out", "."]).contains("folder"));
    assert_eq!(scene.list("."), ["file", "tiny.toml"]);
    fs::create_dir(scene.join("thesis")).unwrap();
    scene.write("thesis/chapter.tex", "mine");
    assert!(code(&["replay", "tiny.toml", "--out", "thesis"]).contains("chapter.tex"));
    assert_eq!(scene.list("thesis"), ["chapter.tex"]);
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_one_error() {
    let scene = Scene::new();
    let (_, err) = scene.expect(4, &["replay", "tiny.toml", "-q", "--y4m", "/dev/full"]);
    assert_eq!(err.lines().count(), 1, "{err}");
    assert!(err.starts_with("error: /dev/full: ") && err.contains("no space left"), "{err}");
    // The frames were written before the film.
    scene.expect(0, &["replay", "tiny.toml"]);
}

#[test]
fn pictures_that_cannot_be_compared() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "-q", "--out", "a", "--frames", "0"]);
    scene.expect(0, &["replay", "tiny.toml", "-q", "--out", "b", "--frames", "0", "--sweeps", "20"]);
    scene.expect(0, &["replay", "tiny.toml", "-q", "--out", "c", "--frames", "1"]);
    scene.write("no.png", "no picture");
    let frame = "a/frames/frame-000000.png";
    for (a, b, word) in [
        ("a", "b", "20x"),
        ("a", "c", "no frame is in both"),
        ("a", frame, "one is a folder"),
        (frame, "no.png", "no.png"),
        (frame, "gone.png", "gone.png"),
        ("a", ".", "run.json"),
    ] {
        let (_, err) = scene.expect(3, &["compare", a, b]);
        assert!(err.contains(word), "{a} {b}: {err}");
    }
}
