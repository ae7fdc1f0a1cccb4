//! What tests of the house read from pages: their text, the sections of a page, the cells of a row, the files they name.

use std::fs;
use std::path::PathBuf;

use crate::metadata::root;

/// Text of a file of the repository.
pub fn text(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Markdown files of a folder of the repository, by name.
pub fn pages(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("a folder of pages");
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.expect("a page").path()).collect();
    found.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    found.sort();
    found
}

/// Heads of the second order and the text under each, in their order.
pub fn sections(page: &str) -> Vec<(&str, &str)> {
    let parts = page.split("\n## ").skip(1);
    parts.map(|part| part.split_once('\n').unwrap_or((part, ""))).collect()
}

/// Cells of a row of a table.
pub fn cells(line: &str) -> Option<Vec<&str>> {
    let inner = line.trim().strip_prefix('|')?.strip_suffix('|')?;
    Some(inner.split('|').map(str::trim).collect())
}

/// What stands between backticks in a line.
pub fn quoted(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2)
}

#[test]
fn pages_are_read_as_they_are_written() {
    assert_eq!(sections("# A\n\nintro\n\n## B\n\none\n\n## C\ntwo"), [("B", "\none\n"), ("C", "two")]);
    assert_eq!(cells("| a | `b` |"), Some(vec!["a", "`b`"]));
    assert_eq!(cells("plain"), None);
    assert_eq!(quoted("see `x` and `y.z`").collect::<Vec<_>>(), ["x", "y.z"]);
}
