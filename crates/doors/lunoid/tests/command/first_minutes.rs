//! What somebody needs who has just installed the program: completions, manual, schemas, names.

use std::process::Command;

use crate::scene::{Scene, lunoid};

#[test]
fn completions_are_there_for_five_shells_and_bash_reads_its_own() {
    let scene = Scene::new();
    for (shell, word) in [
        ("bash", "complete"),
        ("zsh", "#compdef lunoid"),
        ("fish", "complete -c lunoid"),
        ("elvish", "edit:completion"),
        ("powershell", "Register-ArgumentCompleter"),
    ] {
        let (out, err) = scene.expect(0, &["completions", shell]);
        assert!(out.contains(word) && out.contains("replay") && err.is_empty(), "{shell}");
        scene.write(&format!("lunoid.{shell}"), out);
    }
    scene.expect(2, &["completions", "korn"]);
    match Command::new("bash").args(["-n", "lunoid.bash"]).current_dir(scene.path()).status() {
        Ok(status) => assert!(status.success()),
        Err(error) => eprintln!("SKIPPED: bash cannot be run: {error}"),
    }
}

#[test]
fn the_manual_has_a_page_for_each_command() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["man", "--out", "man"]);
    let pages = scene.list("man");
    assert_eq!(out, format!("man: {} pages\n", pages.len()));
    for page in ["lunoid.1", "lunoid-replay.1", "lunoid-state-save.1", "lunoid-man.1"] {
        assert!(pages.contains(&page.to_owned()), "{page} of {pages:?}");
    }
    let replay = std::fs::read_to_string(scene.join("man/lunoid-replay.1")).unwrap();
    assert!(replay.contains(".TH lunoid\\-replay 1") || replay.contains(".TH lunoid-replay 1"), "{replay}");
    assert!(replay.contains("\\-\\-frames"), "{replay}");
    let (first, _) = scene.expect(0, &["man"]);
    assert!(
        first.contains(".SH EXAMPLES\n.nf\n") && first.contains("\n.fi\n"),
        "examples stand line by line: {first}"
    );
    assert_eq!(first, std::fs::read_to_string(scene.join("man/lunoid.1")).unwrap());
    scene.write("file", "");
    let (_, err) = scene.expect(4, &["man", "--out", "file"]);
    assert!(err.contains("file"), "{err}");
}

#[test]
fn every_kind_of_file_has_a_schema() {
    for (kind, title) in [("scenario", "Scenario"), ("model", "Hardware model"), ("cartridge", "Cartridge")] {
        let output = lunoid().args(["schema", kind]).output().unwrap();
        let schema: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(schema["title"], title);
        assert_eq!(schema["additionalProperties"], false);
    }
}

/// A scenario has a name in `scenarios/`; a name that is nearly right is told.
#[test]
fn scenarios_go_by_name() {
    let scene = Scene::new();
    std::fs::create_dir(scene.join("scenarios")).unwrap();
    std::fs::rename(scene.join("tiny.toml"), scene.join("scenarios/tiny.toml")).unwrap();
    scene.expect(0, &["replay", "tiny", "--frames", "0..1", "--out", "run"]);
    let (_, err) = scene.expect(3, &["replay", "tinny", "--out", "run2"]);
    assert!(
        err.contains("scenarios/tinny.toml") && err.contains("did you mean scenarios/tiny.toml?"),
        "{err}"
    );
    let (_, err) = scene.expect(3, &["replay", "scenarios/tiny.tml", "--out", "run2"]);
    assert!(err.contains("did you mean scenarios/tiny.toml?"), "{err}");
    assert!(!scene.join("run2").exists());
    std::fs::create_dir(scene.join("scenarios/real")).unwrap();
    std::fs::copy(scene.join("scenarios/tiny.toml"), scene.join("scenarios/real/other.toml")).unwrap();
    std::fs::write(scene.join("clippy.toml"), "").unwrap();
    scene.expect(0, &["check", "tiny", "tiny.toml", "other"]);
    let (_, err) = scene.expect(3, &["replay", "full-drive.toml", "--out", "run2"]);
    assert!(
        err.contains("scenarios/full-drive.toml: no such file") && !err.contains("did you mean"),
        "{err}"
    );
}

/// A file that only has the name of a page stays.
#[test]
fn pages_of_the_manual_replace_pages_alone() {
    let scene = Scene::new();
    scene.expect(0, &["man", "--out", "m"]);
    scene.expect(0, &["man", "--out", "m"]);
    std::fs::write(scene.join("m/lunoid-replay.1"), "mine").unwrap();
    let (_, err) = scene.expect(4, &["man", "--out", "m"]);
    assert!(err.contains("lunoid-replay.1: this file is no page of the manual"), "{err}");
    assert_eq!(std::fs::read(scene.join("m/lunoid-replay.1")).unwrap(), b"mine");
}
