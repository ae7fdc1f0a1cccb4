//! `lunoid dataset`: list, shards and their join, loaders, and what is refused.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::tempdir;

const PLAN: &str = r#"format = 1
title = "Tiny"
about = "Nothing but a test."
licence = "CC0-1.0"
seed = 7
draws = 3
scenarios = ["scene.toml"]
machines = ["ideal"]
truth = ["range", "label"]
set = ["scenario.raster.columns=40", "scenario.raster.lines=30"]

[pose]
x_m = [20, 380]
y_m = [20, 380]
heading_deg = [0, 360]

[splits]
block_m = 80
reach_m = 15
train = 0.5
validation = 0.25
test = 0.25
"#;

fn lunoid(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lunoid")).current_dir(folder).args(arguments).output().unwrap()
}

fn told(folder: &Path, arguments: &[&str]) -> String {
    let output = lunoid(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn scene() -> tempfile::TempDir {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), include_str!("../../../drive/tests/scene.toml")).unwrap();
    fs::write(folder.path().join("plan.toml"), PLAN).unwrap();
    folder
}

#[test]
fn shards_are_made_listed_and_joined() {
    let folder = scene();
    let at = folder.path();
    let list: Value = serde_json::from_str(&told(at, &["dataset", "plan.toml", "--list", "--json"])).unwrap();
    assert_eq!((&list["samples"], &list["measured"]), (&Value::from(3), &Value::from(3)));
    assert!(!at.join("runs").exists(), "a list makes no files");
    told(at, &["dataset", "plan.toml", "--out", "whole", "-j", "1"]);
    told(at, &["dataset", "plan.toml", "--shard", "2/2"]);
    let gaps = lunoid(at, &["merge", "runs/plan-shard-2-of-2", "--out", "joined"]);
    let said = String::from_utf8(gaps.stdout).unwrap();
    assert_eq!(gaps.status.code(), Some(1), "{said}");
    let command = said.lines().find_map(|line| line.trim().strip_prefix("lunoid ")).expect("a command");
    told(at, &command.split(' ').collect::<Vec<_>>());
    told(at, &["merge", "joined-samples-0-1", "runs/plan-shard-2-of-2", "--out", "joined"]);
    for name in ["dataset.json", "manifest.jsonl", "README.md", "contact-sheet.png"] {
        assert_eq!(
            fs::read(at.join("joined").join(name)).unwrap(),
            fs::read(at.join("whole").join(name)).unwrap()
        );
    }
    let only = told(at, &["dataset", "plan.toml", "--only", "2", "--json"]);
    let only: Value = serde_json::from_str(&only).unwrap();
    assert_eq!((&only["folder"], &only["made"]), (&Value::from("runs/plan-samples-2-3"), &Value::from(1)));
}

#[test]
fn what_is_asked_wrongly_is_refused() {
    let folder = scene();
    let at = folder.path();
    let cases: [(&[&str], i32, &str); 5] = [
        (&["dataset", "plan.toml", "--only", "3"], 2, "0..3"),
        (&["dataset", "plan.toml", "--shard", "5/4"], 2, "1 <= K <= N"),
        (&["dataset", "plan.toml", "--shard", "1/4"], 2, "at most as many shards"),
        (&["dataset", "gone.toml"], 3, "gone.toml"),
        (&["dataset", "scene.toml"], 3, "unknown key"),
    ];
    for (arguments, code, expected) in cases {
        let output = lunoid(at, arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(code) && said.contains(expected), "{arguments:?}: {said}");
    }
    fs::create_dir(at.join("mine")).unwrap();
    fs::write(at.join("mine/notes.txt"), "mine").unwrap();
    let output = lunoid(at, &["dataset", "plan.toml", "--out", "mine"]);
    assert_eq!(output.status.code(), Some(4));
}

/// The interpreter of Python: that of LUNOID_PYTHON, or the usual one.
pub fn python() -> String {
    std::env::var("LUNOID_PYTHON").unwrap_or_else(|_| "python3".into())
}

/// Whether Python has the module; without it the test says so and is skipped.
pub fn has(module: &str) -> bool {
    let found = Command::new(python()).args(["-c", &format!("import {module}")]).output();
    let found = found.is_ok_and(|output| output.status.success());
    if !found {
        eprintln!("SKIPPED: Python has no {module}; what reads by it is not run");
    }
    found
}

#[test]
fn loaders_read_every_sample_of_a_split() {
    let folder = scene();
    let at = folder.path();
    told(at, &["dataset", "plan.toml", "--out", "whole"]);
    let manifest = fs::read_to_string(at.join("whole/manifest.jsonl")).unwrap();
    let rows: Vec<Value> = manifest.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let split = rows[0]["split"].as_str().unwrap();
    let count = rows.iter().filter(|row| row["split"] == split).count();
    for (loader, module) in [("load_numpy.py", "numpy"), ("load_torch.py", "torch")] {
        if !has(module) {
            continue;
        }
        let path: PathBuf = at.join("whole").join(loader);
        let output = Command::new(python()).arg(path).arg(at.join("whole")).arg(split).output().unwrap();
        let said = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success(), "{loader}: {}", String::from_utf8_lossy(&output.stderr));
        if module == "numpy" {
            assert!(
                said.lines().count() == count && said.contains("picture[30, 40] split[30, 40]"),
                "{said}"
            );
        } else {
            assert!(said.contains(", 1, 30, 40]") && said.contains("range["), "{said}");
        }
    }
}
