//! What the block sheets say is not modelled has no key, and all sheets have the same heads.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::metadata::root;
use crate::pages::{cells, pages, quoted, sections, text};

/// Heads of every sheet, in their order.
const HEADS: [&str; 10] = [
    "Ports",
    "Signals",
    "Law",
    "Timing",
    "Parameters",
    "Real parts",
    "Faults it can show",
    "Not modelled",
    "Our choices",
    "Tests",
];

/// Why something is left out that no key could bring in.
const REASONS: [&str; 7] = ["circuit", "design", "light", "mechanics", "optics", "report", "software"];

/// Pages with a table of keys.
const KEY_PAGES: [&str; 4] = [
    "docs/hardware-model-format.md",
    "docs/scenario-format.md",
    "docs/blocks/lunsim.md",
    "docs/blocks/sampled.md",
];

/// Keys in the first cells of the tables of a page.
fn documented(page: &str) -> BTreeSet<String> {
    let rows = page.lines().filter_map(cells);
    rows.flat_map(|row| quoted(row[0]).map(str::to_owned).collect::<Vec<_>>()).collect()
}

/// Keys of a file in TOML, with their tables.
fn written(file: &str) -> BTreeSet<String> {
    let mut table = String::new();
    let mut keys = BTreeSet::new();
    for line in file.lines().map(str::trim).filter(|line| !line.starts_with('#')) {
        if line.starts_with('[') {
            let name = line.split('#').next().unwrap_or_default();
            table = name.trim().trim_matches(['[', ']']).to_owned();
        } else if let Some((key, _)) = line.split_once('=') {
            keys.insert(format!("{table}.{}", key.trim()));
        }
    }
    keys
}

/// Files in TOML under a folder.
fn models(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of hardware models") {
        let path = entry.expect("an entry of that folder").path();
        if path.is_dir() {
            models(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "toml") {
            found.push(path);
        }
    }
}

/// Every key that a page documents or a shipped model has.
fn known() -> BTreeSet<String> {
    let mut keys: BTreeSet<String> = KEY_PAGES.iter().flat_map(|page| documented(&text(page))).collect();
    let mut files = Vec::new();
    models(&root().join("hardware-models"), &mut files);
    for file in files {
        keys.extend(written(&fs::read_to_string(file).expect("a hardware model in UTF-8")));
    }
    keys
}

/// Sheets with their names; the index is none.
fn sheets() -> Vec<(String, String)> {
    let name = |path: &PathBuf| path.file_name().expect("a name").to_string_lossy().into_owned();
    let all = pages("docs/blocks").into_iter().map(|path| (name(&path), path));
    let sheets = all.filter(|(name, _)| name != "README.md");
    sheets.map(|(name, path)| (name, fs::read_to_string(path).expect("a sheet in UTF-8"))).collect()
}

/// Entries of a list, each in one line.
fn items(list: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for line in list.lines().filter(|line| !line.trim().is_empty()) {
        match (line.strip_prefix("- "), found.last_mut()) {
            (Some(item), _) => found.push(item.trim().to_owned()),
            (None, Some(last)) => last.push_str(&format!(" {}", line.trim())),
            (None, None) => found.push(line.to_owned()),
        }
    }
    found
}

/// What is wrong with an entry `NAME: sentence (no key ...)` or `NAME: sentence (reason)`.
fn fault(item: &str, known: &BTreeSet<String>) -> Option<String> {
    let bracket = item.rsplit_once('(').and_then(|(_, rest)| rest.strip_suffix(")."));
    match bracket.map(|bracket| (bracket, bracket.strip_prefix("no key `"))) {
        Some((_, Some(key))) => {
            let key = key.trim_end_matches('`');
            known.contains(key).then(|| format!("{item}\n    the key {key} exists"))
        }
        Some((reason, None)) if REASONS.contains(&reason) => None,
        _ => Some(format!("{item}\n    expected `(no key ...).` or one of {REASONS:?} at its end")),
    }
}

#[test]
fn what_is_not_modelled_has_no_key() {
    let known = known();
    assert!(known.contains("sweep.smoother_ns") && known.contains("shadows.reach_m"), "no keys were found");
    let mut found = Vec::new();
    for (name, sheet) in sheets() {
        let section = sections(&sheet).into_iter().find(|(head, _)| *head == "Not modelled");
        let entries = items(section.map_or("", |(_, list)| list));
        if entries.is_empty() {
            found.push(format!("{name}: nothing under `Not modelled`"));
        }
        found.extend(entries.iter().filter_map(|item| Some(format!("{name}: {}", fault(item, &known)?))));
    }
    assert!(found.is_empty(), "\n  {}", found.join("\n  "));
}

#[test]
fn all_sheets_have_the_same_heads() {
    for (name, sheet) in sheets() {
        let heads: Vec<&str> = sections(&sheet).into_iter().map(|(head, _)| head).collect();
        assert_eq!(heads, HEADS, "docs/blocks/{name}");
    }
}

#[test]
fn entries_are_held_to_their_form() {
    let known = BTreeSet::from(["drum.count".to_owned()]);
    assert_eq!(fault("Wander: none (no key `drum.wander_pct`).", &known), None);
    assert_eq!(fault("Lens: none (optics).", &known), None);
    assert!(fault("Drums: none (no key `drum.count`).", &known).is_some());
    assert!(fault("Drums: none.", &known).is_some());
    assert!(fault("Drums: none (weather).", &known).is_some());
    assert_eq!(items("- a\n  b\n- c"), ["a b", "c"]);
    assert_eq!(written("[a]\nb = 1 # c\n[[d.e]]\nf = 2"), BTreeSet::from(["a.b".into(), "d.e.f".into()]));
}
