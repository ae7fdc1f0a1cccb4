//! `docs/architecture.md` says which files a change touches: they exist.

use crate::metadata::root;
use crate::pages::{cells, quoted, sections, text};

const PAGE: &str = "docs/architecture.md";
const HEAD: &str = "To add this, touch that";

/// Files and folders of the repository that a row names.
fn named<'a>(row: &[&'a str]) -> Vec<&'a str> {
    row.iter()
        .flat_map(|cell| quoted(cell))
        .filter(|word| word.contains('/') || word.ends_with(".md"))
        .collect()
}

#[test]
fn what_a_change_touches_exists() {
    let page = text(PAGE);
    let (_, section) = sections(&page).into_iter().find(|(head, _)| *head == HEAD).expect("the section");
    let rows: Vec<Vec<&str>> = section.lines().filter_map(cells).skip(2).collect();
    assert!(rows.len() >= 10, "{PAGE}: only {} changes", rows.len());
    for row in rows {
        let [change, _, _] = row[..] else { panic!("{PAGE}: expected three cells: {row:?}") };
        let files = named(&row);
        assert!(files.len() >= 2, "{PAGE}: {change} names no files");
        for file in files {
            assert!(root().join(file).exists(), "{PAGE}: {change} names {file}, which is not there");
        }
    }
}
