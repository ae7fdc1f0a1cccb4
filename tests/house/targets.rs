//! A program that `cargo test` passes over has no tests that nobody would run.

use std::fs;

use crate::metadata::{Metadata, Target, metadata};
use crate::sources::sources;

/// Programs of the workspace without a test program.
fn passed_over(all: &Metadata) -> impl Iterator<Item = &Target> {
    let ours = all.packages.iter().filter(|package| all.workspace_members.contains(&package.id));
    ours.flat_map(|package| &package.targets)
        .filter(|target| !target.test && target.kind.iter().any(|kind| kind == "bin"))
}

#[test]
fn programs_that_are_passed_over_have_no_tests() {
    let all = metadata(&["--no-deps"]);
    let mut count = 0;
    for target in passed_over(&all) {
        let mut files = vec![target.src_path.clone()];
        if target.src_path.ends_with("main.rs") {
            sources(target.src_path.parent().expect("a file lies in a folder"), &mut files);
        }
        for file in files {
            let text = fs::read_to_string(&file).expect("a source file in UTF-8");
            assert!(
                !text.contains("#[test]"),
                "{}: nobody runs its tests; see `test` of {}",
                file.display(),
                target.name
            );
        }
        count += 1;
    }
    assert!(count > 0, "no program is passed over: this test has nothing to do");
}
