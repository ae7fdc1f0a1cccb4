//! A program or library that `cargo test` passes over has no tests that nobody would run, and a library without tests is passed
//! over.

use std::fs;
use std::path::PathBuf;

use crate::metadata::{Metadata, Target, metadata};
use crate::sources::sources;

/// Programs and libraries of the workspace; a procedural macro or a test is neither.
fn targets(all: &Metadata) -> impl Iterator<Item = &Target> {
    let ours = all.packages.iter().filter(|package| all.workspace_members.contains(&package.id));
    ours.flat_map(|package| &package.targets)
        .filter(|target| target.kind.iter().any(|kind| kind == "bin" || kind == "lib"))
}

/// Files of a target that have tests.
fn tested(target: &Target) -> Vec<PathBuf> {
    let mut files = vec![target.src_path.clone()];
    if ["main.rs", "lib.rs"].iter().any(|name| target.src_path.ends_with(name)) {
        sources(target.src_path.parent().expect("a file lies in a folder"), &mut files);
    }
    let has_tests = |file: &PathBuf| {
        fs::read_to_string(file).expect("a source file in UTF-8").lines().any(|line| line.trim() == "#[test]")
    };
    files.retain(has_tests);
    files
}

#[test]
fn targets_that_are_passed_over_have_no_tests() {
    let all = metadata(&["--no-deps"]);
    let passed_over: Vec<&Target> = targets(&all).filter(|target| !target.test).collect();
    assert!(!passed_over.is_empty(), "nothing is passed over: this test has nothing to do");
    for target in passed_over {
        let tested = tested(target);
        assert!(tested.is_empty(), "{tested:?}: nobody runs their tests; see `test` of {}", target.name);
    }
}

#[test]
fn libraries_without_tests_are_passed_over() {
    let all = metadata(&["--no-deps"]);
    for target in targets(&all).filter(|target| target.test && target.src_path.ends_with("src/lib.rs")) {
        assert!(
            !tested(target).is_empty(),
            "{}: nothing to run; set `test = false` in its `[lib]`",
            target.name
        );
    }
}
