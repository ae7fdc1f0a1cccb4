//! Every section that comments and pages cite has a heading: in `docs/specification.md`, or in
//! `docs/specification-hardware.md` where the citation says hardware.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use crate::metadata::root;
use crate::pages::{pages, text};
use crate::sources::sources;

const MACHINE: &str = "docs/specification.md";
const HARDWARE: &str = "docs/specification-hardware.md";

/// Numbers of the headings of a page: `## 6. Terrain` is 6, `### 6.2 Sweep` is 6.2.
fn headings(page: &str) -> BTreeSet<String> {
    let heads = page.lines().filter_map(|line| line.strip_prefix("## ").or(line.strip_prefix("### ")));
    let numbers = heads.filter_map(|head| head.split_whitespace().next());
    let numbers = numbers.map(|number| number.trim_end_matches('.').to_owned());
    numbers.filter(|number| number.starts_with(|c: char| c.is_ascii_digit())).collect()
}

/// The number that a text begins with, such as `6.2` or `23.2b`, and the rest.
fn number(text: &str) -> Option<(&str, &str)> {
    let end = text.find(|c: char| !(c.is_ascii_alphanumeric() || c == '.')).unwrap_or(text.len());
    let word = text[..end].trim_end_matches('.');
    word.starts_with(|c: char| c.is_ascii_digit()).then(|| (word, &text[word.len()..]))
}

/// Numbers of a list such as `6.3, 6.5 and 17`.
fn numbers(mut text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    while let Some((first, rest)) = number(text) {
        found.push(first);
        let next = [", ", " and ", " to ", " or "].iter().find_map(|between| rest.strip_prefix(between));
        text = next.unwrap_or_default();
    }
    found
}

/// Places behind a word in a line.
fn behind<'a>(line: &'a str, word: &str) -> Vec<&'a str> {
    line.match_indices(word).map(|(at, _)| &line[at + word.len()..]).collect()
}

/// Sections that a line cites.
fn cited(line: &str) -> Vec<&str> {
    let words = ["section ", "sections ", "Section ", "Sections ", "hardware ", "Hardware "];
    words.iter().flat_map(|word| behind(line, word)).flat_map(numbers).collect()
}

/// Comments of the crates and pages of the docs, line by line, with the places they stand at.
fn lines() -> Vec<(String, String)> {
    let mut files: Vec<PathBuf> = Vec::new();
    sources(&root().join("crates"), &mut files);
    files.extend(pages("docs"));
    files.extend(pages("docs/blocks"));
    let mut found = Vec::new();
    for file in files {
        let is_page = file.extension().is_some_and(|extension| extension == "md");
        let text = fs::read_to_string(&file).expect("a file in UTF-8");
        for (number, line) in text.lines().enumerate() {
            if is_page || line.trim_start().starts_with("//") {
                found.push((format!("{}:{}", file.display(), number + 1), line.to_owned()));
            }
        }
    }
    found
}

#[test]
fn every_cited_section_has_a_heading() {
    let (machine, hardware) = (headings(&text(MACHINE)), headings(&text(HARDWARE)));
    assert!(machine.len() > 40 && hardware.len() > 25, "{} and {} headings", machine.len(), hardware.len());
    let has = |number: &str| machine.contains(number) || hardware.contains(number);
    let mut count = 0;
    let mut missing = Vec::new();
    for (place, line) in lines() {
        for number in cited(&line) {
            count += 1;
            if !has(number) {
                missing.push(format!("{place}: section {number}"));
            }
        }
    }
    assert!(count > 300, "only {count} citations found");
    assert!(missing.is_empty(), "no page has these sections:\n  {}", missing.join("\n  "));
}

#[test]
fn citations_are_read_in_all_their_forms() {
    assert_eq!(cited("(sections 6.3, 6.5 and 17; hardware section 4.4)"), ["4.4", "6.3", "6.5", "17"]);
    assert_eq!(cited("sections 6 to 8, and hardware 3.8."), ["6", "8", "3.8"]);
    assert_eq!(cited("the next section is longer"), [""; 0]);
    assert_eq!(headings("# A\n## 6. B\n### 6.2 C\n## Words\n"), BTreeSet::from(["6".into(), "6.2".into()]));
}
