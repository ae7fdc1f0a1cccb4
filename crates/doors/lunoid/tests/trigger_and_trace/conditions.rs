//! Conditions that are none.

use crate::scene::Scene;

#[test]
fn each_is_one_error_at_its_place() {
    let scene = Scene::new();
    for (on, words) in [
        ("tg.hight > 5", &["did you mean `tg.height`?", "\n  tg.hight > 5\n  ^^^^^^^^\n"][..]),
        ("tg.height >", &["found the end, expected a number", "\n  tg.height >\n             ^\n"]),
        ("tg.height > 5 and sm.write > 0.5", &["runs down the display and `tg.height` along the ground"]),
        ("slope tg.height > 5", &["expected /sample, /m or /us"]),
        ("fold z", &["found `z`, expected x, y"]),
    ] {
        // Nothing is read before the condition is understood.
        let (out, err) = scene.expect(2, &["trigger", "gone.toml", "--on", on]);
        assert!(out.is_empty() && err.starts_with("error: ") && err.matches("error: ").count() == 1, "{err}");
        assert!(words.iter().all(|word| err.contains(word)), "{on}: {err}");
    }
    let (_, err) = scene.expect(2, &["trigger", "tiny.toml", "--on", "fg.height > 0"]);
    assert!(err.contains("no `fg.height`: its feature-generator is left out; --everything"), "{err}");
    scene.expect(1, &["trigger", "tiny.toml", "--everything", "--frames", "0", "--on", "fg.height > 0"]);
}

#[test]
fn options_that_cannot_be() {
    let scene = Scene::new();
    let of = |more: &[&str]| {
        let command = ["trigger", "tiny.toml", "--on", "tg.height > 0"];
        let (out, err) = scene.expect(2, &[&command[..], more].concat());
        assert!(out.is_empty() && err.matches("error: ").count() == 1, "{err}");
        err
    };
    assert!(of(&["--frames", "0..9"]).contains("frames 0..4"));
    assert!(of(&["--sweep", "30..41"]).contains("sweeps 0..40"));
    assert!(of(&["--sample", "80"]).contains("samples 0..80"));
    assert!(of(&["--machine", "exact"]).contains("expected a hardware model"));
    assert!(of(&["--out", "a.txt"]).contains(".csv, .vcd, .fst"));
    assert!(of(&["--out", "a.png", "--around-sweeps", "2"]).contains("a picture shows one sweep"));
    assert!(of(&["--out", "a.csv", "--signals", "no.*"]).contains("no signal of this name"));
    assert!(of(&["--all", "--nth", "3"]).contains("cannot be used with"));
    assert_eq!(scene.list("."), ["tiny.toml"]);
}

#[test]
fn on_a_plain_nothing_rises() {
    let scene = Scene::new();
    scene.vary("plain.toml", "rms_height_m = 2", "rms_height_m = 0");
    let of = |on: &str, code| scene.expect(code, &["trigger", "plain.toml", "-q", "--on", on]).0;
    assert_eq!(of("slope tg.height > 0.01/m", 1), "not found in 160 sweeps\n");
    assert!(of("slope tg.height < 0.01/m", 0).starts_with("1: frame 0 (0.000 s), sweep 0, sample 1.000"));
}

#[test]
fn traces_that_cannot_be() {
    let scene = Scene::new();
    for (more, words) in [
        (&["--frame", "4"][..], "frames 0..4"),
        (&["--frame", "0", "--sweep", "40"], "sweeps 0..40"),
        (&["--frame", "0", "--unit", "loader.blue"], "loader.blue"),
        (&["--frame", "0", "--event", "fold"], "possible values"),
        (&["--frame", "0", "--at", "700000000"], "frame 0 has ticks 0..100000000"),
        (&["--frame", "0", "--at", "3:80"], "samples 0..80"),
        (&["--frame", "0", "--at", "3.5"], "expected a tick, or sweep and sample"),
        (&["--frame", "0", "--at", "3:5", "--csv"], "cannot be used with"),
        (&["--frame", "0", "--from", "9", "--to", "3"], "an end behind the first tick"),
    ] {
        let (out, err) = scene.expect(2, &[&["trace", "tiny.toml"], more].concat());
        assert!(out.is_empty() && err.contains(words), "{more:?}: {err}");
    }
}
