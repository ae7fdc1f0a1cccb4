//! The page that a replay leaves: what is in its folder, and what asking again does to it.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

const SCENARIO: &str = include_str!("tiny.toml");

fn scene() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("tiny.toml"), SCENARIO).unwrap();
    folder
}

/// Runs the command, which must end with `code`; standard output and standard error together.
fn lunoid(scene: &TempDir, code: i32, arguments: &[&str]) -> String {
    let mut command = Command::cargo_bin("lunoid").unwrap();
    let output =
        command.env_remove("LUNOID_THREADS").current_dir(scene.path()).args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    let text = String::from_utf8_lossy(&text).into_owned();
    assert_eq!(output.status.code(), Some(code), "{arguments:?}\n{text}");
    text
}

fn page(scene: &TempDir, run: &str) -> String {
    fs::read_to_string(scene.path().join(run).join("index.html")).unwrap()
}

fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("type=\"application/json\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

fn plots(run: &Path) -> Vec<String> {
    let entries = fs::read_dir(run.join("scopes")).into_iter().flatten();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn any_way_to_the_same_run_leads_to_the_same_page() {
    let scene = scene();
    let probe = ["--probe", "2:10", "--probe", "3:5..7:tg.*"];
    lunoid(&scene, 0, &[&["replay", "tiny.toml", "-q", "--out", "a", "--jobs", "1"], &probe[..]].concat());
    lunoid(
        &scene,
        0,
        &["replay", "tiny.toml", "-q", "--out", "b", "--frames", "2..", "--jobs", "3", "--probe", "2:10"],
    );
    assert_ne!(page(&scene, "a"), page(&scene, "b"));
    lunoid(&scene, 0, &["replay", "tiny.toml", "-q", "--out", "b", "--probe", "3:5..7:tg.*"]);
    assert_eq!(page(&scene, "a"), page(&scene, "b"));
    let read = |run: &str, name: &str| fs::read(scene.path().join(run).join(name)).unwrap();
    for name in ["page.json", "run.json"] {
        assert_eq!(read("a", name), read("b", name), "{name}");
    }
    let expected =
        ["frame-000002-sweep-0010.svg", "frame-000003-sweep-0005.svg", "frame-000003-sweep-0006.svg"];
    assert_eq!(plots(&scene.path().join("b")), expected);
    assert!(read("a", &format!("scopes/{}", expected[0])).starts_with(b"<"));
    let data = data(&page(&scene, "a"));
    assert_eq!(data["scopes"].to_string(), "[[2,10],[3,5],[3,6]]");
    assert_eq!(data["stage"], "tiny.toml");
    assert_eq!((data["first"].as_u64(), data["end"].as_u64()), (Some(0), Some(4)));
    assert!(page(&scene, "a").contains("Every deadline was met."));
}

/// The command that the page offers is that of the run: it finds every frame there.
#[test]
fn the_commands_of_a_page_are_those_of_its_run() {
    let scene = scene();
    fs::write(scene.path().join("less.toml"), "format = 1\n[raster]\nsamples_per_sweep = 60\n").unwrap();
    let stage =
        "tiny.toml --overlay less.toml --set raster.sweeps=32 --scalar f64 --shadow-cache shadows --lossless";
    let pictures = "--depth 16 --refresh";
    let run = format!("replay {stage} {pictures} --frames 1..3 --out a");
    lunoid(&scene, 0, &run.split(' ').collect::<Vec<_>>());
    let data = data(&page(&scene, "a"));
    let offered = |key: &str| data[key].as_str().unwrap().to_owned();
    assert_eq!([offered("stage"), offered("pictures")], [stage.to_owned(), format!(" {pictures}")]);
    assert!(
        page(&scene, "a")
            .contains(&format!("lunoid replay {stage} --frames 1..3 {pictures} --out runs/checked"))
    );
    let again =
        format!("replay {}{} --frames 1..3 --out a --probe 2:5", offered("stage"), offered("pictures"));
    let said = lunoid(&scene, 0, &again.split(' ').collect::<Vec<_>>());
    assert!(said.contains("all there already"), "{said}");
    assert_eq!(plots(&scene.path().join("a")), ["frame-000002-sweep-0005.svg"]);
}

#[test]
fn a_page_is_written_again_from_its_folder() {
    let scene = scene();
    lunoid(&scene, 0, &["replay", "tiny.toml", "-q", "--probe", "1:3"]);
    let before = page(&scene, "runs/tiny");
    fs::remove_file(scene.path().join("runs/tiny/index.html")).unwrap();
    let said = lunoid(&scene, 0, &["page", "runs/tiny"]);
    assert!(said.ends_with("index.html\n"), "{said}");
    assert_eq!(page(&scene, "runs/tiny"), before);
    let said: Value = serde_json::from_str(&lunoid(&scene, 0, &["page", "runs/tiny", "--json"])).unwrap();
    assert_eq!(said["schema"], "lunoid.page-written/1");
    lunoid(&scene, 3, &["page", "runs/none"]);
    assert!(!scene.path().join("runs/none").exists());
    // Damaged, it is an error for the page, and made anew by the replay.
    fs::write(scene.path().join("runs/tiny/page.json"), "{").unwrap();
    let said = lunoid(&scene, 3, &["page", "runs/tiny"]);
    assert!(said.contains("page.json") && said.contains("lunoid replay"), "{said}");
    lunoid(&scene, 0, &["replay", "tiny.toml", "-q", "--probe", "1:3"]);
    assert_eq!(page(&scene, "runs/tiny"), before);
    // A fresh run takes its plots with it.
    lunoid(&scene, 0, &["replay", "tiny.toml", "-q", "--fresh"]);
    assert_eq!(plots(&scene.path().join("runs/tiny")), Vec::<String>::new());
    assert!(page(&scene, "runs/tiny").contains("No sweep was recorded"));
}

#[test]
fn what_cannot_be_recorded_is_said_before_anything_is_drawn() {
    let scene = scene();
    for (probe, word) in [
        ("4:0", "the run has frames 0..4"),
        ("0:40", "a frame has sweeps 0..40"),
        ("0:1:nothing.*", "no signal of this name"),
        ("0", "expected FRAME:SWEEP"),
    ] {
        let said = lunoid(&scene, 2, &["replay", "tiny.toml", "--probe", probe]);
        assert!(said.contains(word), "{said}");
    }
    let said = lunoid(&scene, 2, &["replay", "tiny.toml", "--machine", "exact", "--probe", "0:1"]);
    assert!(
        said.contains("exact has no signals that a page could show; expected a hardware model"),
        "{said}"
    );
    assert!(!scene.path().join("runs").exists());
    lunoid(&scene, 0, &["replay", "tiny.toml", "-q", "--machine", "exact", "--frames", "0..1"]);
    assert!(page(&scene, "runs/tiny").contains("exact, without a machine"));
    assert!(data(&page(&scene, "runs/tiny"))["sight"].is_null());
}
