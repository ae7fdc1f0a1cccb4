//! Random files: what fits the schema is read, what does not is refused in its line, by the schema and by the reader.

use std::fs;

use diagnostics::{ProblemList, Problems, TomlFile};
use proptest::prelude::*;
use scenario::Scenario;
use serde_json::Value;

use super::lines::{Line, lines, node, replaced};
use super::{document, faults, files, root};
use crate::SCENARIO;

/// Numbers change by this share at most: keys that must agree with each other (a path inside its ground) still do.
const NEAR: f64 = 1e-3;

/// Ends of keys that other keys bound closely: clocks divide each other, ground has a least wave.
const BOUND: [&str; 5] = ["_hz", "region_size_m", "shortest_m", "detail_m", "radius_m"];

fn schema() -> Value {
    serde_json::from_str(SCENARIO).expect("JSON")
}

/// A shipped scenario, by any number.
fn shipped(any: prop::sample::Index) -> String {
    fs::read_to_string(any.get(&files("scenarios"))).expect("a text")
}

/// Lines of the faults that the reader finds, from 0.
fn lines_of_faults(text: &str) -> Vec<usize> {
    let folder = root().join("scenarios/a.toml").display().to_string();
    let tables = registry::parameter_tables();
    let faults = |found: Option<ProblemList>| found.map(|faults| faults.records()).unwrap_or_default();
    let mut records = faults(Scenario::parse_beside(&folder, text, &tables).err());
    for row in registry::ROWS.iter().filter(|row| row.parameters.is_some()) {
        let problems = Problems::new();
        let configured = registry::configure(row, TomlFile::parse("a.toml", text, &problems));
        records.extend(faults(configured.err()));
    }
    records.iter().filter_map(|record| Some(record.line? - 1)).collect()
}

/// A number by the schema, near the one of `line`; nothing where the line is no float, or others bound it closely.
fn near(schema: &Value, line: &Line, share: f64) -> Option<f64> {
    let known = node(schema, &line.path)?;
    let is_bound = BOUND.iter().any(|end| line.path.last().is_some_and(|key| key.ends_with(end)));
    let number = line.value.as_f64().filter(|_| known["type"] == "number" && !is_bound)?;
    let changed = number * (1.0 + NEAR * share);
    let bound = |name: &str| known.get(name).and_then(Value::as_f64);
    let (low, high) = (bound("minimum").unwrap_or(f64::MIN), bound("maximum").unwrap_or(f64::MAX));
    Some(changed.clamp(low, high))
}

/// A value that `known` has no place for.
fn wrong(known: &Value, choice: u8) -> String {
    let bound = |name: &str| known.get(name).and_then(Value::as_f64);
    let below = bound("minimum").map(|low| low - 1.0).or(bound("exclusiveMinimum"));
    let above = bound("maximum").map(|high| high * 2.0 + 1.0).or(bound("exclusiveMaximum"));
    // A choice of types may take any text.
    let choice = if known.get("anyOf").is_some() { 3 } else { choice };
    match (choice % 4, below, above) {
        (0, Some(below), _) => format!("{below:?}"),
        (1, _, Some(above)) if above < 1e18 => format!("{above:?}"),
        (2, ..) => "\"nonsense of a word\"".into(),
        _ => "[[[true]]]".into(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_files_by_the_schema_are_read(any: prop::sample::Index, shares in prop::collection::vec(-1.0..1.0_f64, 64)) {
        let (schema, text) = (schema(), shipped(any));
        let mut changed = text.clone();
        for (line, share) in lines(&text).iter().zip(shares.iter().cycle()) {
            if let Some(number) = near(&schema, line, *share) {
                changed = replaced(&changed, line, &format!("{number:?}"));
            }
        }
        prop_assert_eq!(faults(&schema, &document(&changed), ""), [""; 0]);
        prop_assert_eq!(lines_of_faults(&changed), [0_usize; 0], "{}", changed);
    }

    #[test]
    fn random_broken_files_are_refused_in_their_line(any: prop::sample::Index, which: prop::sample::Index, choice: u8) {
        let (schema, text) = (schema(), shipped(any));
        let all = lines(&text);
        let known: Vec<_> = all.iter().filter_map(|line| Some((line, node(&schema, &line.path)?))).collect();
        let (line, known) = which.get(&known);
        // A text has no wrong words where the schema lists none.
        prop_assume!(known["type"] != "string" || known.get("enum").is_some() || choice % 4 != 2);
        let changed = replaced(&text, line, &wrong(known, choice));
        prop_assert!(!faults(&schema, &document(&changed), "").is_empty(), "{:?}: {}", line.path, wrong(known, choice));
        prop_assert!(lines_of_faults(&changed).contains(&line.index), "{:?}: {}", line.path, wrong(known, choice));
    }

    #[test]
    fn unknown_keys_are_refused_in_their_line(any: prop::sample::Index, which: prop::sample::Index, key in "[a-z]{3,12}") {
        let (schema, text) = (schema(), shipped(any));
        let all = lines(&text);
        let line = which.get(&all);
        let mut path = line.path.clone();
        *path.last_mut().expect("a key") = key.clone();
        prop_assume!(node(&schema, &path).is_none());
        let mut rows: Vec<&str> = text.lines().collect();
        let row = format!("{key} = 1");
        rows.insert(line.index + 1, &row);
        let changed = rows.join("\n");
        prop_assert!(!faults(&schema, &document(&changed), "").is_empty(), "{:?}", path);
        prop_assert!(lines_of_faults(&changed).contains(&(line.index + 1)), "{:?}", path);
    }
}
