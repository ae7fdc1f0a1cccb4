//! `lunoid state`: a machine in a file, gone on from and stepped, and what is refused.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

/// A slow phosphor, two fields and a residue, so that earlier frames stay in the picture.
const LASTING: &[&str] = &["tiny.toml", "--machine", "pra-overloaded"];

/// A state of `tiny.toml` as `there.state`.
fn saved(frame: &str, sweep: &str) -> Scene {
    let scene = Scene::new();
    let place = ["--frame", frame, "--sweep", sweep, "--out", "there.state"];
    let (out, _) = scene.expect(0, &[&["state", "save"], LASTING, &place].concat());
    assert!(out.starts_with("there.state: Tiny on pra-overloaded: frame"), "{out}");
    scene
}

fn json(scene: &Scene, arguments: &[&str]) -> Value {
    serde_json::from_str(&scene.expect(0, arguments).0).unwrap()
}

fn bytes(scene: &Scene, name: &str) -> Vec<u8> {
    fs::read(scene.join(name)).unwrap()
}

#[test]
fn a_state_goes_on_as_the_run_does() {
    let scene = saved("1", "17");
    scene.expect(0, &[&["replay"], LASTING, &["--frames", "1..4", "--out", "run"]].concat());
    let (out, _) = scene.expect(0, &["state", "load", "there.state", "--frames", "3", "--out", "after"]);
    assert!(out.contains("rows of frame 1: 17 x") && out.contains("store of frame 0: 40 x"), "{out}");
    assert_eq!(scene.list("after"), ["frame-000001.png", "frame-000002.png", "frame-000003.png"]);
    for name in scene.list("after") {
        let run = bytes(&scene, &format!("run/frames/{name}"));
        assert!(bytes(&scene, &format!("after/{name}")) == run, "{name}");
    }
    let told = json(&scene, &["state", "load", "there.state", "--out", "one.png", "--json"]);
    assert_eq!((&told["schema"], &told["written"][0]), (&"lunoid.state.load/1".into(), &"one.png".into()));
    assert_eq!(told["place"]["sweep"], 17);
    assert_eq!(told["digital"]["levels"][0]["registers"].as_object().unwrap().len(), 12);
    assert!(bytes(&scene, "one.png") == bytes(&scene, "run/frames/frame-000001.png"));
    // Threads change no byte.
    let other = ["--frame", "1", "--sweep", "17", "--jobs", "3", "--out", "other.state"];
    scene.expect(0, &[&["state", "save"], LASTING, &other].concat());
    assert!(bytes(&scene, "other.state") == bytes(&scene, "there.state"));
    // The scenario may be named, with the options; a folder that is there takes more frames.
    let named = [&["state", "load", "there.state"], LASTING, &["--out", "after"]].concat();
    scene.expect(0, &named);
}

#[test]
fn steps_show_what_is_there_and_lead_back() {
    let scene = saved("1", "17");
    let step = |rest: &[&'static str]| [&["state", "step"], rest].concat();
    let shown = scene.expect(0, &step(&["there.state", "--count", "0"])).0;
    assert!(shown.starts_with("frame 1, sweep 17, start: tick ") && shown.contains("yellow hold"), "{shown}");
    let shown = scene.expect(0, &step(&["there.state", "--by", "event", "--count", "3"])).0;
    assert!(shown.lines().count() > 1 && shown.lines().nth(1).unwrap().starts_with("  tick "), "{shown}");
    let shown = scene.expect(0, &step(&["there.state", "--by", "sample", "--count", "40"])).0;
    let words = ["sample 40: tick", "sweep.x", "tg.height", "mu.reflectivity", "sm.video", "red y-first"];
    assert!(words.iter().all(|word| shown.contains(word)), "{shown}");
    let told = json(&scene, &step(&["there.state", "--by", "tick", "--count", "5", "--json"]));
    assert_eq!(told["schema"], "lunoid.state.step/1");
    assert_eq!((&told["from"]["gone"], &told["place"]["gone"]["ticks"]), (&"nothing".into(), &5.into()));
    for by in ["tick", "event", "sample", "sweep", "frame"] {
        scene.expect(0, &step(&["there.state", "--by", by, "--count", "2", "--out", "on.state"]));
        assert!(bytes(&scene, "on.state") != bytes(&scene, "there.state"), "{by}");
        scene.expect(0, &step(&["on.state", "--by", by, "--count", "-2", "--out", "back.state"]));
        assert!(bytes(&scene, "back.state") == bytes(&scene, "there.state"), "{by}");
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let scene = saved("3", "17");
    scene.vary("other.toml", "azimuth_deg = 100", "azimuth_deg = 101");
    let mut damaged = bytes(&scene, "there.state");
    damaged.truncate(5000);
    scene.write("short.state", &damaged);
    damaged[0] = b'P';
    scene.write("none.state", damaged);
    let save = |rest: &[&'static str]| [&["state", "save"], LASTING, rest].concat();
    let load = |rest: &[&'static str]| [&["state", "load", "there.state"], rest].concat();
    let step = |rest: &[&'static str]| [&["state", "step", "there.state"], rest].concat();
    for (code, arguments, words) in [
        (2, save(&["--frame", "4", "--sweep", "0", "--out", "a"]), "the scenario has frames 0..4"),
        (2, save(&["--frame", "0", "--sweep", "40", "--out", "a"]), "a frame has sweeps 0..40"),
        (
            2,
            save(&["--frame", "0", "--sweep", "0", "--out", "tiny.toml"]),
            "would replace the scenario tiny.toml",
        ),
        (3, vec!["state", "load", "tiny.toml"], "tiny.toml: byte 0: found `format =`, expected `LUNOSTAT`"),
        (3, vec!["state", "load", "gone.state"], "gone.state: no such file"),
        (3, vec!["state", "load", "short.state"], "short.state: the file has 5000 bytes, expected"),
        (3, vec!["state", "step", "none.state"], "this is no state"),
        (3, load(&["tiny.toml"]), "of the settings of the machine (pra-overloaded), expected"),
        (
            3,
            load(&["other.toml", "--machine", "pra-overloaded"]),
            "of the scenery (pra-overloaded), expected",
        ),
        (2, load(&["--machine", "ideal"]), "a state has its own machine and settings"),
        (2, load(&["--frames", "2"]), "expected --out with a folder"),
        (2, load(&["--frames", "2", "--out", "a.png"]), "a picture has one frame"),
        (2, load(&["--frames", "2", "--out", "after"]), "expected at most 1"),
        (2, load(&["tiny.toml", "--machine", "exact"]), "expected a hardware model"),
        (2, step(&["--out", "there.state"]), "would replace the state there.state"),
        (2, step(&["--by", "frame"]), "behind the end of frame 3"),
        (2, step(&["--by", "event", "--count", "-99999"]), "before the start of frame 0"),
        (2, step(&["--by", "line"]), "possible values: tick, event, sample, sweep, frame"),
    ] {
        let (out, err) = scene.expect(code, &arguments);
        assert!(out.is_empty() && err.contains(words), "{arguments:?}: {err}");
        assert_eq!(err.lines().filter(|line| line.starts_with("error")).count(), 1, "{err}");
    }
    assert!(!scene.join("after").exists() && !scene.join("a.png").exists());
    // The words lead to the scenario where the state was saved, and the message says so elsewhere.
    fs::rename(scene.join("tiny.toml"), scene.join("moved.toml")).unwrap();
    let (_, err) = scene.expect(3, &["state", "load", "there.state"]);
    assert!(err.contains("its scenario tiny.toml is not here"), "{err}");
    // What it holds is told all the same.
    let told = json(&scene, &["info", "there.state", "--json"]);
    assert_eq!((&told["schema"], &told["words"][0]), (&"lunoid.info.state/1".into(), &"tiny.toml".into()));
    let (out, _) = scene.expect(0, &["info", "there.state"]);
    assert!(out.contains("rows of frame 3: 17 x"), "{out}");
    let (_, err) = scene.expect(3, &["info", "short.state"]);
    assert!(err.contains("short.state: the file has 5000 bytes"), "{err}");
    let moved = [&["state", "load", "there.state", "moved.toml"], &LASTING[1..]].concat();
    scene.expect(0, &moved);
}
