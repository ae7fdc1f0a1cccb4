//! What a command asks for over the scenario: single keys, no page.

use crate::scene::Scene;

#[test]
fn keys_of_the_scenario_are_set_by_the_command() {
    let scene = Scene::new();
    let text = std::fs::read_to_string(scene.join("tiny.toml")).unwrap();
    assert!(text.contains("frames = "), "{text}");
    let arguments = ["replay", "tiny.toml", "-q", "--frames", "0..1", "--out"];
    scene.expect(0, &[&arguments[..], &["file"]].concat());
    scene.expect(0, &[&arguments[..], &["set", "--set", "scenario.landscape.albedo=0.3"]].concat());
    let (_, err) = scene.expect(1, &["compare", "file", "set", "--max-rmse", "0"]);
    assert!(!err.contains("error"), "{err}");
    // Words need no quotes.
    scene.expect(0, &[&arguments[..], &["word", "--set", "scenario.title=Other ground"]].concat());
    assert!(std::fs::read_to_string(scene.join("word/run.json")).unwrap().contains("Other ground"));
    let record = std::fs::read_to_string(scene.join("set/run.json")).unwrap();
    assert!(record.contains("\"albedo\": 0.3"), "{record}");
    for (set, said) in [
        ("scenario.landscape.albdo=0.3", "did you mean `albedo`?"),
        ("scenario.landscape.albedo=3", "--set:1"),
        ("scenario.lunsim.grid=64", "expected --set lunsim.grid"),
        ("scenario.title=a\nframes = 1", "no key with a value in one line"),
        ("scenario.=a", "no key with a value in one line"),
    ] {
        let output = scene.run(&[&arguments[..], &["no", "--set", set]].concat());
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && err.contains(said), "{set}: {err}");
        assert!(!scene.join("no").exists(), "{set}");
    }
}

#[test]
fn a_run_may_have_no_page() {
    let scene = Scene::new();
    scene.expect(
        0,
        &["replay", "tiny.toml", "-q", "--frames", "0..1", "--no-page", "--truth", "range", "--out", "a"],
    );
    let files = scene.list("a");
    assert!(!files.iter().any(|name| name == "index.html" || name == "page.json"), "{files:?}");
    assert!(
        scene.join("a/frames/frame-000000.png").exists() && scene.join("a/truth/frame-000000.npz").exists()
    );
    scene.expect(2, &["replay", "tiny.toml", "--no-page", "--probe", "0:3", "--out", "b"]);
    scene.expect(2, &["replay", "tiny.toml", "--no-page", "-m", "ideal", "-m", "lunsim", "--out", "b"]);
}
