//! Options that are named alone: in messages of any crate, and between backticks of any page.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use clap::Command;

use super::pages::{self, root};
use crate::cli::command;

/// All options of `command` and of everything below it, as they are typed.
fn options(command: &Command, found: &mut BTreeSet<String>) {
    let longs = command.get_arguments().filter_map(|argument| argument.get_long());
    found.extend(longs.map(|long| format!("--{long}")));
    command.get_subcommands().for_each(|below| options(below, found));
}

/// What `text` names as an option of a program.
fn named(text: &str) -> impl Iterator<Item = &str> {
    let of_option = |c: char| c.is_ascii_alphanumeric() || c == '-';
    let words = text.split(move |c| !of_option(c)).filter(|word| word.starts_with("--"));
    words.filter(|word| word[2..].starts_with(|c: char| c.is_ascii_lowercase()))
}

/// Source files of the crates whose messages a user of the program sees.
fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        // Measuring programs and the builder of the page have options of their own; this folder has those of cargo.
        let has_own = ["benchmarks", "doors/site", "src/written"].iter().any(|end| name.ends_with(end));
        if path.is_dir() && !has_own {
            sources(&path, found);
        } else if name.ends_with(".rs") && name.contains("/src/") {
            found.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
}

#[test]
fn every_option_that_is_named_is_one() {
    // The latter two are of cargo: how a program with another feature is built.
    let mut known = BTreeSet::from(["--help", "--version", "--release", "--features"].map(str::to_owned));
    options(&command(), &mut known);
    let (mut faults, mut seen) = (Vec::new(), 0);
    let mut check = |place: String, text: &str| {
        for option in named(text) {
            seen += 1;
            if !known.contains(option) {
                faults.push(format!("{place}: {option}"));
            }
        }
    };
    let mut files = Vec::new();
    sources(&root().join("crates"), &mut files);
    for (name, text) in &files {
        let lines = text.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"));
        for (number, line) in lines {
            check(format!("{name}:{}", number + 1), line);
        }
    }
    for page in pages::all(&mut command()) {
        page.spans()
            .iter()
            .filter(|span| span.starts_with("--"))
            .for_each(|span| check(page.name.clone(), span));
    }
    assert!(faults.is_empty(), "no such option:\n{}", faults.join("\n"));
    assert!(seen > 400, "only {seen} found");
}

#[test]
fn options_are_found_in_sentences() {
    let text = "give --spacing-m METRES, `--set`=3, not -- or --- or --2, (--out)";
    assert_eq!(named(text).collect::<Vec<_>>(), ["--spacing-m", "--set", "--out"]);
}
