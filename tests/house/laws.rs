//! The map of laws (`docs/laws.md`) names files that exist, and tests that stand in them.

use crate::metadata::root;
use crate::pages::{cells, quoted, text};

/// Whether a word in backticks is a file of the repository.
fn is_file(word: &str) -> bool {
    ["crates/", "tests/"].iter().any(|folder| word.starts_with(folder)) && word.ends_with(".rs")
}

/// Whether a word in backticks has the form of a test's name.
fn is_name(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

/// Tests that a cell names, each with the file before it.
fn tests(cell: &str) -> Vec<(&str, &str)> {
    let mut file = "";
    let mut found = Vec::new();
    for word in quoted(cell) {
        if is_file(word) {
            file = word;
        } else if is_name(word) && !file.is_empty() {
            found.push((file, word));
        }
    }
    found
}

/// The cell of a row in which its tests stand: the last of four, the first of two.
fn cell_of_tests<'a>(row: &[&'a str]) -> Option<&'a str> {
    match *row {
        [_, _, _, tests] | [tests, _] => Some(tests),
        _ => None,
    }
}

#[test]
fn files_of_the_map_exist() {
    let page = text("docs/laws.md");
    let files: Vec<&str> = quoted(&page).filter(|word| is_file(word)).collect();
    assert!(files.len() > 100, "only {} files found", files.len());
    let missing: Vec<&&str> = files.iter().filter(|file| !root().join(file).is_file()).collect();
    assert!(missing.is_empty(), "docs/laws.md names what is not there: {missing:#?}");
}

#[test]
fn tests_of_the_map_stand_where_it_says() {
    let page = text("docs/laws.md");
    let rows: Vec<Vec<&str>> = page.lines().filter_map(cells).collect();
    let named: Vec<(&str, &str)> = rows.iter().filter_map(|row| cell_of_tests(row)).flat_map(tests).collect();
    assert!(named.len() > 80, "only {} tests found", named.len());
    let is_there = |file: &str, name: &str| text(file).contains(&format!("fn {name}("));
    let missing: Vec<_> = named.iter().filter(|(file, name)| !is_there(file, name)).collect();
    assert!(missing.is_empty(), "docs/laws.md names tests that are not there: {missing:#?}");
}

#[test]
fn a_cell_is_read_file_by_file() {
    assert_eq!(
        tests("`crates/a/src/b.rs`: `one`, `two`; `tests/c.rs`: `three`"),
        [("crates/a/src/b.rs", "one"), ("crates/a/src/b.rs", "two"), ("tests/c.rs", "three"),]
    );
    assert_eq!(tests("none: `given`"), []);
}
