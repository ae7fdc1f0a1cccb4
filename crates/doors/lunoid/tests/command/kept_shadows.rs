//! Shadow boundaries are kept from run to run. The folder is the one that is asked for, or else one in the run folder.

use std::fs;

use crate::replays::frames;
use crate::scene::Scene;

/// The tiny scenario under a sun one degree high, with shadows, as `shadowed.toml`.
fn scene() -> Scene {
    let scene = Scene::new();
    scene.vary("shadowed.toml", "elevation_deg = 15", "elevation_deg = 1");
    let text = fs::read_to_string(scene.join("shadowed.toml")).unwrap();
    scene.write("shadowed.toml", text + "\n[shadows]\n");
    scene
}

#[test]
fn a_folder_that_is_asked_for_keeps_them() {
    let scene = scene();
    scene.expect(0, &["replay", "shadowed.toml", "--out", "plain"]);
    scene.expect(0, &["replay", "shadowed.toml", "--out", "first", "--shadow-cache", "kept/here"]);
    let kept = scene.list("kept/here");
    assert!(!kept.is_empty());
    scene.expect(0, &["replay", "shadowed.toml", "--out", "second", "--shadow-cache", "kept/here"]);
    assert_eq!(scene.list("kept/here"), kept, "nothing had to be computed again");
    assert!(!scene.join("second/shadows").exists(), "one folder is enough");
    assert_eq!(frames(&scene, "plain"), frames(&scene, "first"));
    assert_eq!(frames(&scene, "plain"), frames(&scene, "second"));
    let (_, err) =
        scene.expect(4, &["replay", "shadowed.toml", "--out", "third", "--shadow-cache", "tiny.toml"]);
    assert!(err.contains("--shadow-cache tiny.toml") && err.contains("can be written"), "{err}");
}

#[test]
fn the_run_keeps_them_for_itself_and_for_who_asks_of_it() {
    let scene = scene();
    scene.expect(0, &["replay", "shadowed.toml", "--frames", "0..3", "--out", "run"]);
    let kept = scene.list("run/shadows");
    assert!(!kept.is_empty());
    for arguments in [
        &["explain", "--frame", "1", "--pixel", "20,18", "--json"][..],
        &["trace", "--frame", "1", "--sweep", "20"],
        &["probe", "--frame", "1", "--sweep", "20", "--signals", "sc.*,dpp.y", "--out", "waves.csv"],
    ] {
        let of = |asked: &str| {
            let (said, _) = scene.expect(0, &[&arguments[..1], &[asked], &arguments[1..]].concat());
            (said, fs::read(scene.join("waves.csv")).ok())
        };
        assert!(of("run") == of("shadowed.toml"), "{arguments:?}");
        assert_eq!(scene.list("run/shadows"), kept, "{arguments:?} leaves the folder as it is");
    }
    // The same job draws on, and a folder without them is the same run.
    fs::remove_dir_all(scene.join("run/shadows")).unwrap();
    scene.expect(0, &["replay", "shadowed.toml", "--out", "run"]);
    scene.expect(0, &["replay", "shadowed.toml", "--out", "whole"]);
    assert_eq!(frames(&scene, "run"), frames(&scene, "whole"));
    let record = |folder: &str| fs::read(scene.join(folder).join("run.json")).unwrap();
    assert!(record("run") == record("whole"));
}

#[test]
fn fresh_removes_those_of_the_run_and_nothing_else() {
    let scene = scene();
    let replay = ["replay", "shadowed.toml", "--frames", "0", "--out", "run", "--fresh"];
    scene.expect(0, &replay);
    let kept = scene.list("run/shadows");
    scene.write("run/shadows/notes.txt", "mine");
    let stray = format!("run/shadows/{}-{}.shadow", "0".repeat(32), "0".repeat(16));
    scene.write(&stray, "lnshad01 of another version");
    scene.expect(0, &replay);
    assert_eq!(scene.list("run/shadows"), [&kept[..], &["notes.txt".to_owned()]].concat());
    // A name alone does not make a file the run's.
    scene.write(&stray, "mine as well");
    let (_, err) = scene.expect(4, &replay);
    assert!(err.contains(&stray["run/".len()..]), "{err}");
    assert_eq!(fs::read_to_string(scene.join(&stray)).unwrap(), "mine as well");
}

#[test]
#[cfg(unix)]
fn no_link_is_followed() {
    let scene = scene();
    let link = std::os::unix::fs::symlink::<_, std::path::PathBuf>;
    fs::create_dir(scene.join("elsewhere")).unwrap();
    fs::create_dir(scene.join("run")).unwrap();
    link(scene.join("elsewhere"), scene.join("run/shadows")).unwrap();
    let (_, err) = scene.expect(4, &["replay", "shadowed.toml", "--frames", "0", "--out", "run"]);
    assert!(err.contains("run/shadows: this is a link"), "{err}");
    assert!(scene.list("elsewhere").is_empty() && !scene.join("run/frames").exists());
}
