//! The schema of landscapes, and the tables of `docs/terrain.md` against their reader.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use diagnostics::asked::record;
use serde_json::Value;
use terrain_builder::Description;

use super::{document, examples, expect_committed, faults, made, root};
use crate::{Keys, LANDSCAPE, Meanings, Told};

const PAGE: &str = include_str!("../../../../../docs/terrain.md");

/// The landscapes of the page and the one that ships.
fn texts() -> Vec<String> {
    let shipped = root().join("scenarios/built-ground/landscape.toml");
    let shipped = fs::read_to_string(shipped).expect("a text");
    examples(PAGE).into_iter().map(str::to_owned).chain([shipped]).collect()
}

fn read(text: &str) -> Result<Description, String> {
    Description::parse("a.toml", text, Path::new("")).map_err(|faults| faults.to_string())
}

fn keys() -> Keys {
    let mut keys = Keys::default();
    for text in texts() {
        let (found, asked) = record(|| read(&text));
        assert!(found.is_ok(), "{found:?}");
        keys.add(&asked);
    }
    keys
}

#[test]
fn the_schema_of_landscapes_is_that_of_their_reader() {
    let told = Told {
        title: "Landscape",
        description: "Features over a base, from which ground is built (docs/terrain.md).",
        required: None,
    };
    expect_committed("landscape.schema.json", LANDSCAPE, &made(&keys(), PAGE, &told));
}

#[test]
fn the_page_has_every_key_of_landscapes() {
    let keys = keys();
    let known: BTreeSet<String> = keys.paths().map(|path| path.replace("[]", "")).collect();
    let tables = ["area", "base", "light", "feature"];
    let known: BTreeSet<&str> =
        known.iter().map(String::as_str).filter(|key| !tables.contains(key)).collect();
    let meanings = Meanings::of_page(PAGE);
    let told: BTreeSet<&str> =
        meanings.keys().filter(|key| key.contains('.') || known.contains(key)).collect();
    let only = |one: &BTreeSet<&str>, other: &BTreeSet<&str>| format!("{:?}", one.difference(other));
    assert_eq!(known, told, "reader alone {}, page alone {}", only(&known, &told), only(&told, &known));
}

/// Words in backticks of a text.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// Keys of each kind of feature as the page lists them, a row a kind.
fn listed() -> BTreeMap<&'static str, BTreeSet<&'static str>> {
    let rows = PAGE.lines().skip_while(|line| !line.starts_with("| `kind` |")).skip(2);
    let kind = |row: &'static str| {
        let mut words = words(row);
        (words.next().expect("a kind"), words.collect())
    };
    rows.take_while(|line| line.starts_with('|')).map(kind).collect()
}

#[test]
fn each_kind_of_feature_has_the_keys_that_the_page_lists() {
    let listed = listed();
    let mut read_kinds = BTreeSet::new();
    for text in texts() {
        let asked = record(|| read(&text)).1;
        for (number, feature) in document(&text)["feature"].as_array().into_iter().flatten().enumerate() {
            let kind = feature["kind"].as_str().expect("a kind");
            let head = format!("feature[{number}].");
            let own = asked.iter().filter_map(|asked| asked.path.strip_prefix(&head));
            let own: BTreeSet<&str> = own
                .filter(|key| !key.contains(['.', '[']) && !["id", "kind", "enabled"].contains(key))
                .collect();
            assert_eq!(listed.get(kind), Some(&own), "{kind}");
            read_kinds.insert(kind.to_owned());
        }
    }
    assert_eq!(read_kinds.len(), listed.len());
}

#[test]
fn landscapes_fit_their_schema_and_broken_ones_do_not() {
    let schema: Value = serde_json::from_str(LANDSCAPE).expect("JSON");
    for text in texts() {
        assert_eq!(faults(&schema, &document(&text), ""), [""; 0]);
    }
    let shipped = texts().pop().expect("the one that ships");
    for (from, to) in [
        ("format = 1", "format = 2"),
        ("[area]", "[place]"),
        ("resolution_m = ", "resolution = "),
        ("kind = \"growth\"", "kind = \"growing\""),
        ("id = \"round\"", "name = \"round\""),
        ("ambient = [", "ambient = [9.0, "),
        ("sizes = \"chi-squared\"", "sizes = \"gauss\""),
        ("seed = 11", "seed = -1"),
    ] {
        let text = shipped.replacen(from, to, 1);
        assert_ne!(text, shipped, "{from}");
        assert!(!faults(&schema, &document(&text), "").is_empty(), "{to}: accepted by the schema");
        assert!(read(&text).is_err(), "{to}: accepted by the reader");
    }
}
