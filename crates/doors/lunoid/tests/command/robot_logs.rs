//! `replay --mcap` and `--exr`: what the command refuses, and in a build with the features what it writes.

#[cfg(all(feature = "mcap", feature = "exr"))]
use std::fs;

use crate::scene::Scene;

#[test]
fn the_help_says_whether_this_build_has_them() {
    let (help, _) = Scene::new().expect(0, &["replay", "--help"]);
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    for (feature, is_built) in [("mcap", cfg!(feature = "mcap")), ("exr", cfg!(feature = "exr"))] {
        let absent = format!("Not in this build: `cargo build --release --features {feature}` brings it in");
        assert_eq!(help.contains(&absent), !is_built, "{help}");
    }
}

#[test]
#[cfg(not(feature = "mcap"))]
fn a_build_without_the_feature_refuses_a_log_before_any_work() {
    let scene = Scene::new();
    let (_, err) = scene.expect(2, &["replay", "tiny.toml", "--mcap", "a.mcap"]);
    assert!(err.contains("--mcap: this build of lunoid has not the feature `mcap`"), "{err}");
    assert!(err.contains("--features mcap"), "{err}");
    assert!(!scene.join("a.mcap").exists() && !scene.join("runs").exists());
}

#[test]
#[cfg(not(feature = "exr"))]
fn a_build_without_the_feature_refuses_openexr_before_any_work() {
    let scene = Scene::new();
    let (_, err) = scene.expect(2, &["replay", "tiny.toml", "--exr"]);
    assert!(err.contains("--exr: this build of lunoid has not the feature `exr`"), "{err}");
    assert!(!scene.join("runs").exists());
}

#[test]
fn several_machines_are_several_runs() {
    let scene = Scene::new();
    for option in [&["--mcap", "a.mcap"][..], &["--exr"]] {
        let words = [&["replay", "tiny.toml", "-m", "ideal", "-m", "exact"][..], option].concat();
        let (_, err) = scene.expect(2, &words);
        assert!(err.contains(&format!("{}: this belongs to one run", option[0])), "{err}");
    }
}

#[test]
#[cfg(all(feature = "mcap", feature = "exr"))]
fn a_log_and_files_of_a_run() {
    let scene = Scene::new();
    let (out, err) = scene.expect(0, &["replay", "tiny.toml", "--mcap", "a.mcap", "--exr"]);
    assert_eq!(err, "");
    assert!(
        out.contains("  mcap of 4 frames: a.mcap\n") && out.contains("  exr of 4 frames: runs/tiny/exr\n"),
        "{out}"
    );
    assert_eq!(scene.list("runs/tiny/exr").len(), 4);
    let log = fs::read(scene.join("a.mcap")).unwrap();
    // The same again draws nothing and writes the same.
    let (again, _) = scene.expect(0, &["replay", "tiny.toml", "--mcap", "a.mcap", "--exr", "--jobs", "1"]);
    assert!(again.contains("all there already"), "{again}");
    assert!(fs::read(scene.join("a.mcap")).unwrap() == log);
    // Shards have logs of their own frames; the joined folder has that of the whole.
    for shard in ["1/2", "2/2"] {
        let file = format!("{}.mcap", &shard[..1]);
        scene.expect(0, &["replay", "tiny.toml", "--shard", shard, "--mcap", &file, "--no-page"]);
        assert!(fs::read(scene.join(&file)).unwrap().len() < log.len());
    }
    let shards = ["runs/tiny-shard-1-of-2", "runs/tiny-shard-2-of-2"];
    scene.expect(0, &["merge", shards[0], shards[1], "--out", "runs/joined"]);
    let whole = ["replay", "tiny.toml", "--out", "runs/joined", "--mcap", "joined.mcap", "--no-page"];
    let (joined, _) = scene.expect(0, &whole);
    assert!(joined.contains("all there already"), "{joined}");
    assert!(fs::read(scene.join("joined.mcap")).unwrap() == log);
    // What is not ours stays, and `--fresh` removes what is.
    fs::write(scene.join("notes"), "mine").unwrap();
    let (_, err) = scene.expect(4, &["replay", "tiny.toml", "--mcap", "notes"]);
    assert!(err.contains("notes: exists, and is no log that lunoid wrote"), "{err}");
    assert_eq!(fs::read(scene.join("notes")).unwrap(), b"mine");
    let (_, err) = scene.expect(4, &["replay", "tiny.toml", "--mcap", "runs"]);
    assert!(err.contains("runs: this is a folder, expected a file name"), "{err}");
    let (_, err) = scene.expect(2, &["replay", "tiny.toml", "--mcap", "b.mcap", "--truth", "range"]);
    assert!(err.contains("the ground truth has no `label`; expected --truth with label,distance"), "{err}");
    scene.expect(0, &["replay", "tiny.toml", "--fresh", "--no-page"]);
    assert!(!scene.join("runs/tiny/exr").exists() && !scene.join("runs/tiny/truth").exists());
}
