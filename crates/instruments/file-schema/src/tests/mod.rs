//! The committed schemas are those of the readers, every key of the pages is in them, and shipped files fit and name them.

mod landscape;
mod lines;
mod random;
mod taplo;

use std::fs;
use std::path::{Path, PathBuf};

use diagnostics::TomlFile;
use diagnostics::asked::{Asked, record};
use hardware_model::{BUILT_IN, HardwareModel, ModelSource};
use scenario::Scenario;
use serde_json::Value;

use crate::{Keys, MODEL, Meanings, SCENARIO, Told};

const SCENARIO_PAGE: &str = include_str!("../../../../../docs/scenario-format.md");
const MODEL_PAGE: &str = include_str!("../../../../../docs/hardware-model-format.md");

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// TOML files of a folder of the repository.
fn files(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("a folder of the repository");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut all: Vec<PathBuf> =
        paths.filter(|path| is_written_by_people(&path.display().to_string())).collect();
    all.sort();
    assert!(!all.is_empty(), "{folder}");
    all
}

/// A bank that somebody made has a description beside it, which nobody writes by hand.
fn is_written_by_people(path: &str) -> bool {
    path.ends_with(".toml") && !path.ends_with(".bank.toml")
}

/// Whole scenarios that a page shows.
fn examples(page: &str) -> Vec<&str> {
    let starts = page.match_indices("```toml\n").map(|(at, mark)| at + mark.len());
    let blocks = starts.map(|start| &page[start..start + page[start..].find("```").expect("an end")]);
    blocks.filter(|text| text.starts_with("format")).collect()
}

fn scenario_keys() -> Keys {
    let (folder, tables) = (root().join("scenarios"), registry::parameter_tables());
    let shipped = files("scenarios").into_iter().chain(files("scenarios/real"));
    let texts: Vec<String> = shipped.map(|path| fs::read_to_string(path).expect("a text")).collect();
    let mut keys = Keys::default();
    for text in texts.iter().map(String::as_str).chain(examples(SCENARIO_PAGE)) {
        // What is named beside it may be missing here: its own keys are asked for all the same.
        let problems = diagnostics::Problems::new();
        let name = folder.join("a.toml").display().to_string();
        let mut asked = record(|| drop(Scenario::parse_beside(&name, text, &tables))).1;
        for row in registry::ROWS {
            let configured = || drop(registry::configure(row, TomlFile::parse("a.toml", text, &problems)));
            let of_table = |asked: &Asked| {
                row.parameters.is_some_and(|table| asked.path.split('.').next() == Some(table))
            };
            asked.extend(record(configured).1.into_iter().filter(of_table));
        }
        keys.add(&asked);
    }
    keys
}

fn model_keys() -> Keys {
    let mut keys = Keys::default();
    // No shipped model holds a word back.
    let delay = "[{ frame = 1, sweep = 2, crossing = 3, colour = 'green', register = 'x-first', word = [1, 0], ticks = 2 }]";
    let sets = [("loader.delay".to_owned(), delay.to_owned())];
    let faults = files("hardware-models/faults").into_iter().map(ModelSource::File);
    for source in BUILT_IN.iter().map(|(name, _)| ModelSource::BuiltIn((*name).into())).chain(faults) {
        keys.add(&record(|| HardwareModel::load(&source, &[], &sets)).1);
    }
    keys
}

fn made(keys: &Keys, page: &str, told: &Told<'_>) -> String {
    let schema = keys.schema(told, &Meanings::of_page(page));
    serde_json::to_string_pretty(&schema).expect("a document") + "\n"
}

/// Compares with the committed file; `LUNOID_WRITE_SCHEMA=1` writes it anew.
fn expect_committed(name: &str, committed: &str, made: &str) {
    if std::env::var_os("LUNOID_WRITE_SCHEMA").is_some() {
        fs::write(root().join("docs/schema").join(name), made).expect("a file that can be written");
        return;
    }
    let other = committed.lines().zip(made.lines()).find(|(committed, made)| committed != made);
    assert!(committed == made, "{name} is of other readers; the first line that differs: {other:?}");
}

#[test]
fn the_schema_of_scenarios_is_that_of_their_reader() {
    let told = Told {
        title: "Scenario",
        description: "What happens and how it is seen: ground, light, vehicle, path, raster (docs/scenario-format.md).",
        required: None,
    };
    expect_committed("scenario.schema.json", SCENARIO, &made(&scenario_keys(), SCENARIO_PAGE, &told));
}

#[test]
fn the_schema_of_models_is_that_of_their_reader() {
    let told = Told {
        title: "Hardware model",
        description: "What a machine is made of, or how it differs from another (docs/hardware-model-format.md).",
        required: Some(&["format"]),
    };
    expect_committed("hardware-model.schema.json", MODEL, &made(&model_keys(), MODEL_PAGE, &told));
}

/// Every key that a page describes is a key of the reader.
#[test]
fn every_key_of_the_pages_is_there() {
    for (page, keys) in [(SCENARIO_PAGE, scenario_keys()), (MODEL_PAGE, model_keys())] {
        let known: Vec<String> = keys.paths().map(|path| path.replace("[]", "")).collect();
        let meanings = Meanings::of_page(page);
        let missing: Vec<&str> =
            meanings.keys().filter(|key| key.contains('.') && !known.iter().any(|k| k == key)).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }
}

/// Faults of a document by a schema, each with its place: as much of JSON Schema as the schemas use.
fn faults(schema: &Value, value: &Value, place: &str) -> Vec<String> {
    if let Some(choices) = schema.get("anyOf").and_then(Value::as_array) {
        let all: Vec<Vec<String>> = choices.iter().map(|choice| faults(choice, value, place)).collect();
        return if all.iter().any(Vec::is_empty) {
            Vec::new()
        } else {
            vec![format!("{place}: none of {}", all.len())]
        };
    }
    let fault = |what: &str| vec![format!("{place}: {what}")];
    let number = value.as_f64();
    match schema["type"].as_str() {
        Some("object") => {
            let Some(table) = value.as_object() else { return fault("no table") };
            let Some(properties) = schema.get("properties").and_then(Value::as_object) else {
                return Vec::new();
            };
            let required = schema.get("required").and_then(Value::as_array).into_iter().flatten();
            let lacking = required.filter_map(Value::as_str).filter(|key| !table.contains_key(*key));
            let mut all: Vec<String> = lacking.map(|key| format!("{place}: no {key}")).collect();
            for (key, value) in table {
                match properties.get(key) {
                    Some(schema) => all.extend(faults(schema, value, &format!("{place}.{key}"))),
                    None => all.push(format!("{place}.{key}: unknown")),
                }
            }
            all
        }
        Some("array") => {
            let Some(elements) = value.as_array() else { return fault("no array") };
            let count = elements.len() as u64;
            let is_counted = schema.get("minItems").is_none_or(|least| least.as_u64() <= Some(count))
                && schema.get("maxItems").is_none_or(|most| most.as_u64() >= Some(count));
            let all =
                elements.iter().flat_map(|element| faults(&schema["items"], element, &format!("{place}[]")));
            if is_counted { all.collect() } else { fault("wrong count") }
        }
        Some("number") | Some("integer") => {
            let Some(number) = number.filter(|_| schema["type"] != "integer" || value.is_i64()) else {
                return fault("no number");
            };
            let bound = |name: &str| schema.get(name).and_then(Value::as_f64);
            let holds = bound("minimum").is_none_or(|low| low <= number)
                && bound("maximum").is_none_or(|high| number <= high)
                && bound("exclusiveMinimum").is_none_or(|low| low < number)
                && bound("exclusiveMaximum").is_none_or(|high| number < high);
            if holds { Vec::new() } else { fault("out of bounds") }
        }
        Some("boolean") => {
            if value.is_boolean() {
                Vec::new()
            } else {
                fault("no truth")
            }
        }
        _ => {
            let Some(text) = value.as_str() else { return fault("no text") };
            let words = schema.get("enum").and_then(Value::as_array);
            if words.is_none_or(|words| words.iter().any(|word| word == text)) {
                Vec::new()
            } else {
                fault("no such word")
            }
        }
    }
}

fn document(text: &str) -> Value {
    toml::from_str::<Value>(text).expect("TOML")
}

#[test]
fn shipped_files_fit() {
    let [scenario, model]: [Value; 2] =
        [SCENARIO, MODEL].map(|schema| serde_json::from_str(schema).expect("JSON"));
    let of = |schema: &Value, path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a text");
        assert_eq!(faults(schema, &document(&text), ""), [""; 0], "{}", path.display());
    };
    files("scenarios").into_iter().chain(files("scenarios/real")).for_each(|path| of(&scenario, path));
    files("hardware-models")
        .into_iter()
        .chain(files("hardware-models/faults"))
        .for_each(|path| of(&model, path));
}

/// An editor finds the schema of a shipped file by the file's first line.
#[test]
fn shipped_files_name_their_schema() {
    let kinds = [("scenarios", "scenario"), ("hardware-models", "hardware-model")];
    for (folder, kind) in kinds {
        let below = if kind == "scenario" { "real" } else { "faults" };
        for path in files(folder).into_iter().chain(files(&format!("{folder}/{below}"))) {
            let text = fs::read_to_string(&path).expect("a text");
            let named =
                text.lines().next().and_then(|line| line.strip_prefix("#:schema ")).unwrap_or_default();
            let schema = path.parent().expect("a folder").join(named);
            let expected = root().join(format!("docs/schema/{kind}.schema.json"));
            let is_there = |path: &Path| path.canonicalize().expect("a schema");
            assert_eq!(is_there(&schema), is_there(&expected), "{}", path.display());
        }
    }
}

/// What the schema refuses, the reader refuses: one change of a shipped file each.
#[test]
fn broken_files_are_refused_by_schema_and_reader() {
    let shipped = fs::read_to_string(root().join("scenarios/full-drive.toml")).expect("a text");
    let schema: Value = serde_json::from_str(SCENARIO).expect("JSON");
    let folder = root().join("scenarios/a.toml").display().to_string();
    for (from, to) in [
        ("format = 1", "format = 2"),
        ("title = ", "titel = "),
        ("[sun]", "[moon]"),
        ("azimuth_deg = ", "azimuth_rad = "),
        ("elevation_deg = ", "elevation_deg = 900 #"),
        ("[path]", "[path]\nspeed = 3"),
        ("machine = ", "machine = 4 #"),
        ("seed = ", "seed = -1 #"),
        ("[landscape.generated]", "[landscape.generated]\nextent_m = [1]"),
    ] {
        let text = shipped.replacen(from, to, 1);
        assert_ne!(text, shipped, "{from}");
        let parsed: Result<Value, _> = toml::from_str(&text);
        let is_refused = parsed.is_err() || !faults(&schema, &parsed.unwrap_or_default(), "").is_empty();
        assert!(is_refused, "{to}: accepted by the schema");
        assert!(Scenario::parse(&folder, &text).is_err(), "{to}: accepted by the reader");
    }
}
