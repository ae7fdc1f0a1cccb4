//! The cost of the effects that ship, as `docs/effects.md` has it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use faces::{Cut, Effect, Group, Setting, SunProgramme};
use quantities::Rate;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// Faces, faces shown, triangles and edges of a list in frame 0, and words of its sun.
fn cost(group: &Group) -> [usize; 5] {
    let shown = group.shown(0, |_| 0.0);
    let (mut triangles, mut edges) = (0, BTreeSet::new());
    for &face in &shown {
        let corners = &group.mesh.faces()[face].corners;
        for piece in Cut::Fan.pieces(corners.len()) {
            triangles += 1;
            for k in 0..3 {
                let [from, to] = [corners[piece[k]], corners[piece[(k + 1) % 3]]];
                edges.insert([from.min(to), from.max(to)]);
            }
        }
    }
    let words = if group.sun == SunProgramme::Scenario { 0 } else { 3 };
    [group.mesh.faces().len(), shown.len(), triangles, edges.len(), words]
}

/// The row of an effect in the page.
fn row(folder: &str, path: &Path) -> String {
    let setting = Setting { frames: Rate::new(30, 1).expect("a frame rate"), signals: &[], most: 200_000 };
    let effect = Effect::read(path, setting).unwrap_or_else(|error| panic!("{error}"));
    let costs = effect.groups.iter().map(cost);
    let sum = costs.fold([0; 5], |sum, cost| [0, 1, 2, 3, 4].map(|k| sum[k] + cost[k]));
    let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let file = path.file_name().expect("a name").to_string_lossy().into_owned();
    let counts = sum.map(|count| count.to_string()).join(" | ");
    format!("| [{name}](../scenarios/effects/{folder}{file}) | {counts} |")
}

/// Effect files of a folder of the library (empty, or ends in a slash), by name.
fn files(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join("scenarios/effects").join(folder)).expect("the library");
    let paths = entries.map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> = paths.filter(|path| path.extension().is_some()).collect();
    files.sort();
    files
}

#[test]
fn the_page_has_the_cost_of_every_effect() {
    let rows = |folder: &'static str| files(folder).into_iter().map(move |path| row(folder, &path));
    let expected: Vec<String> = rows("").chain(rows("dropped/")).collect();
    let page = std::fs::read_to_string(root().join("docs/effects.md")).expect("the page");
    let is_row = |line: &&str| line.starts_with("| [") && line.contains("../scenarios/effects/");
    let found: Vec<&str> = page.lines().filter(is_row).collect();
    let is_same = found.len() == expected.len()
        && found.iter().zip(&expected).all(|(found, expected)| found.starts_with(expected.as_str()));
    assert!(is_same, "docs/effects.md should have rows that begin so:\n{}", expected.join("\n"));
}
